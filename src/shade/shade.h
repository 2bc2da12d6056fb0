// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: shade, (lobes + light -> radiance).
///
/// Input:      raster::Fragments of one draw; its Material; the LightTable of the frame.
/// Output:     Radiance columns: scene-linear colour, premultiplied by a, and the targets that programs write.
/// Units:      positions in world space, irradiance and radiance in the lights' unit.
/// Invariants: lights accumulate in the order of the table; a row depends on its own inputs alone.
///
/// | file          | what                                                                         |
/// |---------------|------------------------------------------------------------------------------|
/// | light_table.h | the lights of a frame                                                        |
/// | cull.h        | kernel: lights whose range reaches a batch                                   |
/// | modulation.h  | what the texture and the shadow of a light leave of it                       |
/// | columns.h     | Lobes, Radiance and scratch columns                                          |
/// | needs.h       | columns that a draw's shading reads                                          |
/// | parameters.h  | values of slots at rows                                                      |
/// | frames.h      | dp/du, dp/dv and tangents of triangles; sides that the eye sees              |
/// | parallax.h    | uv where lines of sight meet heights                                         |
/// | normals.h     | kernels: mapped and bumped normals; exponents and roughness widened          |
/// | surface.h     | those together: what a material says of its surface                          |
/// | illuminate.h  | kernel: light reflected by the lobes of each row                             |
/// | combine.h     | kernels: coefficients times lobes; values from corners to rows               |
/// | show.h        | what models without lights show                                              |
/// | frequency.h   | rows for Gouraud (corners) and flat (centroids) shading                      |
/// | program.h     | programs and procedures of the caller's                                      |
/// | run.h         | one draw's fragments from geometry to radiance, whatever model               |
#pragma once
