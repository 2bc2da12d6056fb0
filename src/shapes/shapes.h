// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: shapes, vertices and triangles of common shapes.
///
/// Input:      a checked shd_shape_desc whose used segments are not zero.
/// Output:     columns of vertices and indices, as described in shd/shapes.h.
/// Invariants: nothing is allocated. Computed in double and rounded once; vertices at the same position have the same
///             bits. counts_of() gives the number of vertices and triangles that are written.
///
/// | file            | contents                                            |
/// |-----------------|-----------------------------------------------------|
/// | sink.h          | the columns, each of which may be absent            |
/// | grid.h          | rows and columns of quadrilaterals as triangles     |
/// | sphere.cpp      | spheres by longitude and latitude                   |
/// | box.cpp         | boxes of six grids                                  |
/// | plane.cpp       | rectangles                                          |
/// | torus.cpp       | tori                                                |
/// | teapot.cpp      | the Utah teapot                                     |
/// | teapot_data.h   | its control points                                  |
#pragma once

#include <cstdint>

#include <shd/shapes.h>

#include "shapes/sink.h"

namespace shd::shapes {

/// Vertices and triangles of a shape.
struct Counts {
  uint64_t vertices, triangles;
};

Counts count_sphere(const shd_shape_desc& desc);
Counts count_box(const shd_shape_desc& desc);
Counts count_plane(const shd_shape_desc& desc);
Counts count_torus(const shd_shape_desc& desc);
Counts count_teapot(const shd_shape_desc& desc);

void fill_sphere(const shd_shape_desc& desc, Sink& out);
void fill_box(const shd_shape_desc& desc, Sink& out);
void fill_plane(const shd_shape_desc& desc, Sink& out);
void fill_torus(const shd_shape_desc& desc, Sink& out);
void fill_teapot(const shd_shape_desc& desc, Sink& out);

}  // namespace shd::shapes
