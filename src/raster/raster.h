// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: raster, (triangles -> Fragments).
///
/// Input:      geometry::ScreenTriangle in groups, in the order they were submitted; geometry::Vertices for attributes.
/// Output:     Fragments: the visible point of each triangle in each pixel of one tile that shows it, in runs of one
///             triangle; or the samples that one triangle covers.
/// Units:      raster positions in pixels, origin at the top left corner of the picture, y down, centres at +1/2.
/// Invariants: 8 subpixel bits; a sample belongs to a triangle if it is inside, or on a left or top edge (Direct3D 11.3
///             functional specification, 3.4.2.1); triangles meet the depths of a tile in the order they were
///             submitted, or painted; a value depends on its sample and triangle alone, never on the tile, the batch or
///             the worker.
///
/// | file               | what                                                                  |
/// |--------------------|-----------------------------------------------------------------------|
/// | sample_pattern.h   | where in a pixel its samples lie                                      |
/// | tile.h             | the tile: depth and the visible triangle of each sample               |
/// | bin.h              | which triangles touch which tile                                      |
/// | sort_triangle.h    | SortTriangle, for sorting by depth: order of two triangles, splits    |
/// | sort_grid.h        | which sort triangles may meet on the screen                           |
/// | painter.h          | the painter's algorithm, and what it gets wrong                       |
/// | newell.h           | the order of Newell, Newell and Sancha                                |
/// | edge.h             | edge functions and the depth plane of one triangle                    |
/// | depth_test.h       | DepthState, and which depths pass a comparison                        |
/// | triangle_setup.h   | one triangle over one tile: edges, depth and pixels                   |
/// | coverage.h         | kernels: triangles into a tile's depths and slots, or into a mask     |
/// | traverse-inl.h     | the covered samples of a triangle, vector by vector                   |
/// | wide_coverage.h    | coverage of triangles whose edges do not fit int32                    |
/// | depth_bounds-inl.h | hierarchical depth, for the kernels of coverage.h                     |
/// | changes.h          | kernel: where neighbouring samples show other triangles               |
/// | fragments.h        | the Fragments table, and the sort of a tile's pixels into it          |
/// | interpolate.h      | kernel: perspective-correct attributes with derivatives               |
/// | varyings.h         | kernel: what vertex programs hand on, in three interpolations         |
/// | attribute-inl.h    | a value between those of three vertices, for those two                |
#pragma once
