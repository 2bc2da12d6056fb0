// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: film, (radiance -> linear image).
///
/// Input:      scene-linear radiance, depth and auxiliary columns of shaded fragments, tile by tile.
/// Output:     the planes of a Framebuffer, row 0 on top; copies of planes in the caller's columns and images.
/// Units:      colour scene-linear, premultiplied by alpha; depth 0 near .. 1 far; raster positions in pixels.
/// Invariants: film/ stores and blends; frame/ decides what is drawn, and when. A pixel is the plain average of its
///             samples; if all samples are equal, the pixel keeps their bits. Reading changes nothing. Integer formats
///             clamp to 0..1, map NaN to 0 and round to nearest; float formats keep NaN and infinities.
///
/// | file             | contents                                                              |
/// |------------------|-----------------------------------------------------------------------|
/// | framebuffer.h    | Framebuffer: the planes and targets of one image                      |
/// | planes.h         | the list of planes: type, empty value and source of each              |
/// | readback.h       | planes to columns; colour to interleaved images                       |
/// | tile_area.h      | the pixels of one tile in the framebuffer: clear, load and store      |
/// | tile_planes.h    | planes in which a tile is drawn, and their encoding                   |
/// | tile_color.h     | colours of the samples of one tile: resolve                           |
/// | copy_runs.h      | kernel: columns to the pixels of runs                                 |
/// | stream_rows.h    | kernel: rows to the framebuffer, past the caches                      |
/// | expanded_color.h | planes in place of interleaved pixels, for frames in several passes   |
/// | sample_store.h   | samples of all tiles, kept between the passes of a frame              |
/// | blend.h          | blend arithmetic: a source colour over its destination                |
/// | unordered.h      | order-independent blends: weighted sums, and sorted lists of samples  |
/// | aovs.h           | auxiliary planes of shaded fragments                                  |
/// | dilate.h         | values of texels continued beyond the edges of charts                 |
#pragma once
