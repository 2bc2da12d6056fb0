// SPDX-License-Identifier: MIT
#pragma once
#include "tool/handles.h"

/// A shape of shd/shapes.h with tangents: the teapot with `steps` parts on each side of a patch, a sphere of 4 steps
/// around and 2 steps down, a torus of 4 steps around and 2 steps + 1 around its tube, others of `steps` in each
/// direction. A projection replaces its uv; the longest side of the shape fills the projection's cube.
Mesh make_shape(shd_context* context, shd_shape shape, uint32_t steps, uint32_t mesh_flags,
                shd_uv_projection projection);
