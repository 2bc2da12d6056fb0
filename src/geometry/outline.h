// SPDX-License-Identifier: MIT
#pragma once

#include "geometry/assemble.h"

namespace shd::geometry {

/// assemble() for draws that show edges or vertices: each edge and each vertex becomes a rectangle of two triangles.
/// Every triangle of the mesh counts once, by the highest TriangleOutcome of its pieces. The corners of a line are its
/// two ends moved by the same offset, rounded to the pixel grid. Hence the two halves share their diagonal, and
/// neighbouring triangles draw the same line.
void assemble_outlines(const Assembly& assembly, size_t begin, size_t end, core::Buffer<ScreenTriangle>* out,
                       shd_render_stats* stats);

}  // namespace shd::geometry
