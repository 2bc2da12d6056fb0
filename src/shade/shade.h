// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: shade, (lobes + light -> radiance).
///
/// Input:      raster::Fragments of one draw; its Material; the LightTable of the frame.
/// Output:     Radiance columns: scene-linear colour, premultiplied by a, and the targets that programs write.
/// Units:      positions in world space, irradiance and radiance in the lights' unit.
/// Invariants: lights accumulate in the order of the table; a row depends on its own inputs alone.
///
/// | file         | what                                                                        |
/// |--------------|-----------------------------------------------------------------------------|
/// | light_table.h | the lights of a frame                                                      |
/// | columns.h    | Lobes and Radiance columns                                                  |
/// | illuminate.h | kernel: light reflected by the diffuse and specular lobe of each row        |
/// | combine.h    | kernels: coefficients and texture times lobes; values from corners to rows  |
/// | frequency.h  | rows for Gouraud (corners) and flat (centroids) shading                     |
/// | run.h        | one draw's fragments from geometry to radiance, whatever model and frequency |
#pragma once
