// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: shade, (lobes + light -> radiance).
///
/// Input:      raster::Fragments of one draw; its Material; the LightTable of the frame.
/// Output:     Radiance columns: scene-linear colour, premultiplied by a, and the targets that programs write.
/// Units:      positions in world space, irradiance and radiance in the lights' unit.
/// Invariants: lights accumulate in the order of the table; a point depends only on its own inputs; no file depends on
///             the set of models: kernels are templates over the structs in the table of material/models-inl.h.
///
/// Points are the positions where lobes are evaluated: the fragments (Phong), the corners (Gouraud) or the centroids
/// (flat) of triangles. A batch is the set of fragments that one worker shades in one call.
///
/// | file             | contents                                                                     |
/// |------------------|------------------------------------------------------------------------------|
/// | light_table.h    | the lights of a frame                                                        |
/// | cull.h           | kernel: lights whose range reaches a batch                                   |
/// | modulation.h     | factors of the cookie and the shadow of a light                              |
/// | columns.h        | Radiance and scratch columns                                                 |
/// | needs.h          | columns that the shading of a draw reads                                     |
/// | parameters.h     | values of slots at points                                                    |
/// | tangent_frames.h | dp/du, dp/dv and tangents of triangles; two-sided normals                    |
/// | parallax.h       | texture coordinates where lines of sight intersect a height field            |
/// | normals.h        | kernels: mapped and bumped normals                                           |
/// | surface.h        | tangents, normals and lobe shapes of a material at points                    |
/// | illuminate.h     | kernels: shape of the model's lobes, and their sums over lights              |
/// | reflection.h     | blur of mirror reflections over pixels                                       |
/// | surround.h       | kernels: lobes in the light of an environment                                |
/// | combine.h        | kernels: coefficients times lobes; values of points at their fragments       |
/// | frequency.h      | points for Gouraud (corners) and flat (centroids) shading                    |
/// | program.h        | programs and procedures of the caller                                        |
/// | one_texture.h    | colours that are one lookup, from geometry to radiance                       |
/// | run.h            | a batch of fragments of one draw, from geometry to radiance                  |
#pragma once
