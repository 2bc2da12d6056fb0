// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace shd::shapes {

/// Control points of the Utah teapot, z up, lid on, as Martin Newell measured it ("The Utilization of Procedure
/// Models in Digital Image Synthesis", 1975), with the bottom that Frank Crow added ("The Origins of the Teapot",
/// IEEE Computer Graphics and Applications 7(1), 1987, table of 306 points and 32 patches).
constexpr int kTeapotPointCount = 306;
constexpr int kTeapotPatchCount = 32;
extern const double kTeapotPoints[kTeapotPointCount][3];

/// Bicubic Bezier patches: [4 down][4 around] numbers of points, counted from 1 as published.
extern const uint16_t kTeapotPatches[kTeapotPatchCount][16];

}  // namespace shd::shapes
