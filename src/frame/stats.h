// SPDX-License-Identifier: MIT
#pragma once

#include <shd/render.h>

namespace shd::frame {

/// Adds the counts and times of a part of a frame to the frame's statistics; scratch_bytes is not changed.
inline void add(const shd_render_stats& piece, shd_render_stats* frame) {
  frame->triangle_count += piece.triangle_count;
  frame->nonfinite_triangle_count += piece.nonfinite_triangle_count;
  frame->outside_triangle_count += piece.outside_triangle_count;
  frame->culled_triangle_count += piece.culled_triangle_count;
  frame->empty_triangle_count += piece.empty_triangle_count;
  frame->rasterized_triangle_count += piece.rasterized_triangle_count;
  frame->clipped_triangle_count += piece.clipped_triangle_count;
  frame->fragment_count += piece.fragment_count;
  frame->nonfinite_fragment_count += piece.nonfinite_fragment_count;
  frame->hidden_sample_count += piece.hidden_sample_count;
  frame->order_conflict_count += piece.order_conflict_count;
  frame->split_count += piece.split_count;
  frame->vertex_seconds += piece.vertex_seconds;
  frame->assembly_seconds += piece.assembly_seconds;
  frame->binning_seconds += piece.binning_seconds;
  frame->tile_seconds += piece.tile_seconds;
}

}  // namespace shd::frame
