// SPDX-License-Identifier: MIT
#pragma once

#include <shd/render.h>

namespace shd::frame {

/// Adds the counts and times of a part of a frame to the frame's statistics; scratch_bytes is not changed.
inline void add(const shd_render_stats& piece, shd_render_stats* frame) {
  frame->triangles += piece.triangles;
  frame->nonfinite += piece.nonfinite;
  frame->outside += piece.outside;
  frame->culled += piece.culled;
  frame->empty += piece.empty;
  frame->rasterised += piece.rasterised;
  frame->clipped += piece.clipped;
  frame->fragments += piece.fragments;
  frame->nonfinite_fragments += piece.nonfinite_fragments;
  frame->hidden_samples += piece.hidden_samples;
  frame->order_conflicts += piece.order_conflicts;
  frame->splits += piece.splits;
  frame->vertex_seconds += piece.vertex_seconds;
  frame->assembly_seconds += piece.assembly_seconds;
  frame->binning_seconds += piece.binning_seconds;
  frame->tile_seconds += piece.tile_seconds;
}

}  // namespace shd::frame
