// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: occlusion, (points and occluders -> the part of the sky that is open above each point).
///
/// Input:      points with normals in world space; a tracer of the host, or draws.
/// Output:     one value for each point: 1 open .. 0 enclosed, weighted by the cosine to the normal.
/// Units:      world space and world lengths.
/// Invariants: the value of a point depends on the point, the options and the occluders alone, never on other points,
///             batches or workers. Points without a finite position and a normal have the value 1.
///
/// | file          | contents                                                              |
/// |---------------|-----------------------------------------------------------------------|
/// | occlusion.h   | Points and Options                                                    |
/// | ray_batch.h   | kernel: the rays of a point                                           |
/// | trace.h       | occlusion by a tracer of the host                                     |
/// | depth_maps.h  | occlusion by depth maps from many directions                          |
/// | blockers.h    | kernel: points that a depth map shows as open                         |
/// | atlas.h       | the points of the texels of a texture                                 |
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/occlusion.h>

#include "core/context.h"

namespace shd::occlusion {

/// Points on surfaces and their values, packed columns.
struct Points {
  size_t count;
  const float* position[3];
  const float* normal[3];  // any length
  float* value;
};

/// A checked shd_occlusion_desc without its draws.
struct Options {
  uint32_t rays, seed;
  float radius, bias;
  uint32_t map_size;
  shd_tracer tracer;
};

}  // namespace shd::occlusion
