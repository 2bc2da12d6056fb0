// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: raster, (triangles -> Fragments).
///
/// Input:      geometry::ScreenTriangle in groups, in the order they were submitted; geometry::Vertices for attributes.
/// Output:     Fragments: the visible point of each covered pixel of one tile, sorted by triangle.
/// Units:      raster positions in pixels, origin at the top left corner of the picture, y down, centres at +1/2.
/// Invariants: 8 subpixel bits; a pixel belongs to a triangle if its centre is inside, or on a left or top edge
///             (Direct3D 11.3 functional specification, 3.4.2.1); depth passes when less, ties keep the first
///             submitted; a value depends on its pixel and triangle alone, never on the tile, the batch or the worker.
///
/// | file          | what                                                                    |
/// |---------------|-------------------------------------------------------------------------|
/// | tile.h        | the tile: depth and the nearest triangle of each pixel                  |
/// | bin.h         | which triangles touch which tile                                        |
/// | edge.h        | edge functions and the depth plane of one triangle                      |
/// | coverage.h    | kernel: edge functions, depth test                                      |
/// | fragments.h   | the Fragments table, and the sort of a tile's pixels into it            |
/// | interpolate.h | kernel: perspective-correct attributes with derivatives                 |
#pragma once
