// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: raster, (triangles -> Fragments).
///
/// Input:      geometry::ScreenTriangle in groups, in submission order; geometry::Vertices for attributes.
/// Output:     Fragments: one point per pixel and visible triangle of one tile, in runs of one triangle; or the samples
///             that one triangle covers.
/// Units:      raster positions in pixels, origin at the top left corner of the picture, y down, centres at +1/2.
/// Invariants: 8 subpixel bits; a sample belongs to a triangle if it is inside, or on a left or top edge (Direct3D 11.3
///             functional specification, 3.4.2.1); triangles are depth-tested in submission order, or painted in the
///             order of the visibility method; a value depends on its sample and triangle alone, never on the tile,
///             the batch or the worker.
///
/// | file               | contents                                                              |
/// |--------------------|-----------------------------------------------------------------------|
/// | sample_pattern.h   | sample positions in a pixel                                           |
/// | tile.h             | the tile: depth and the visible triangle of each sample               |
/// | bin.h              | the triangles that touch each tile                                    |
/// | sort_triangle.h    | SortTriangle, for sorting by depth: order of two triangles, splits    |
/// | sort_grid.h        | grid of the sort triangles that may overlap on the screen             |
/// | painter.h          | the painter's algorithm, and a count of its errors                    |
/// | newell.h           | the order of Newell, Newell and Sancha                                |
/// | edge.h             | edge functions and the depth plane of one triangle                    |
/// | depth_test.h       | DepthState, and the depth comparisons                                 |
/// | triangle_setup.h   | one triangle over one tile: edges, depth and pixels                   |
/// | coverage.h         | kernels: triangles into a tile's depths and slots, or into a mask     |
/// | traverse-inl.h     | the covered samples of a triangle, vector by vector                   |
/// | small_triangles-inl.h | triangles of at most 8 x 8 pixels, set up one per lane             |
/// | wide_coverage.h    | coverage of triangles whose edges do not fit int32                    |
/// | depth_bounds-inl.h | hierarchical depth, for the kernels of coverage.h                     |
/// | nearest.h          | conservative coverage: the nearest triangle of each texel             |
/// | tile_words.h       | kernels over the words of a tile: where slots change; clearing        |
/// | fragments.h        | the Fragments table, and the sort of a tile's pixels into it          |
/// | append_rows.h      | kernel: rows of fragments for runs of pixels                          |
/// | spans-inl.h        | rows of one triangle in a table of fragments                          |
/// | interpolate.h      | kernel: perspective-correct attributes with derivatives               |
/// | texture_places.h   | kernel: texture coordinates of the pixels of one triangle in one cell |
/// | planes.h           | attributes of one triangle as planes over one cell of the picture     |
/// | planes-inl.h       | their values at vectors of pixels, with derivatives                   |
/// | lit_rows-inl.h     | interpolation of the columns of most lit materials, for long spans    |
/// | varyings.h         | kernel: outputs of vertex programs, in three interpolations           |
/// | attribute-inl.h    | barycentric interpolation, for interpolate.h and varyings.h           |
#pragma once
