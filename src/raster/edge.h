// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geometry/assemble.h"
#include "raster/depth_test.h"
#include "raster/sample_pattern.h"
#include "raster/tile.h"

namespace shd::raster {

/// Edge function of the edge from vertex k of a triangle to the next, in 2^-16 pixel^2. `value` is the value at the top
/// left corner of a tile and includes the top-left rule; a and b are the steps per subpixel to the right and down.
struct EdgeLine {
  int64_t value, a, b;
};

inline EdgeLine make_edge_line(const geometry::ScreenTriangle& t, int k, int32_t left, int32_t top) {
  const int next = k == 2 ? 0 : k + 1;
  const int64_t a = int64_t{t.y[k]} - t.y[next];
  const int64_t b = int64_t{t.x[next]} - t.x[k];
  const int64_t x = int64_t{left} * geometry::kSubpixels, y = int64_t{top} * geometry::kSubpixels;
  const bool owns_boundary = a > 0 || (a == 0 && b > 0);  // left edge, or top edge
  return {a * (x - t.x[k]) + b * (y - t.y[k]) - (owns_boundary ? 0 : 1), a, b};
}

/// An edge function at one sample of each pixel, in whole pixels: the sample of pixel (i, j) of the tile is on the
/// inner side if and only if value + a * i + b * j >= 0. Exact: from pixel to pixel the function changes by 256 a and
/// 256 b, so that division by 256, rounded down, keeps its sign.
struct Edge {
  int64_t value, a, b;
};

inline Edge edge_at(const EdgeLine& line, SamplePoint sample) {
  return {(line.value + line.a * sample.x + line.b * sample.y) >> geometry::kSubpixelBits, line.a, line.b};
}

enum class EdgeSide { kOutside, kInside, kCrossing };

/// The side of an edge on which all samples of a tile lie. Conservative: kCrossing may be returned for the other cases.
inline EdgeSide side_of(const EdgeLine& line, const geometry::SampleExtent& samples) {
  constexpr int64_t kExtent = (kTile - 1) * geometry::kSubpixels;
  const int64_t left = line.a * samples.min_x, right = line.a * (kExtent + samples.max_x);
  const int64_t top = line.b * samples.min_y, bottom = line.b * (kExtent + samples.max_y);
  if (line.value + std::max(left, right) + std::max(top, bottom) < 0) return EdgeSide::kOutside;
  return line.value + std::min(left, right) + std::min(top, bottom) >= 0 ? EdgeSide::kInside : EdgeSide::kCrossing;
}

/// Largest step for which the values of an edge that crosses a tile fit int32, including the offset of a sample in its
/// pixel, in 2^-16 pixel^2.
constexpr int64_t kNarrowStep = int64_t{1} << 22;

/// Depth of a triangle: at vertex 0, per pixel, and its range, all including the bias.
struct DepthSlope {
  double z, dx, dy;
  float low, high;
  int32_t x, y;  // vertex 0, fixed point
};

inline DepthSlope make_depth_slope(const geometry::ScreenTriangle& t, const DepthState& state) {
  const double x1 = static_cast<double>(t.x[1] - t.x[0]), y1 = static_cast<double>(t.y[1] - t.y[0]);
  const double x2 = static_cast<double>(t.x[2] - t.x[0]), y2 = static_cast<double>(t.y[2] - t.y[0]);
  const double z0 = static_cast<double>(t.z[0]);
  const double z1 = static_cast<double>(t.z[1]) - z0, z2 = static_cast<double>(t.z[2]) - z0;
  const double scale = geometry::kSubpixels / (x1 * y2 - x2 * y1);  // per pixel; the area is not 0
  const double dx = (z1 * y2 - z2 * y1) * scale, dy = (z2 * x1 - z1 * x2) * scale;
  const double steepest = std::max(std::fabs(dx), std::fabs(dy));
  const double bias = static_cast<double>(state.bias) + static_cast<double>(state.slope_bias) * steepest;
  const auto biased = [&](float z) {
    return bias == 0 ? z : static_cast<float>(std::min(std::max(static_cast<double>(z) + bias, 0.0), 1.0));
  };
  return {z0 + bias, dx,    dy, biased(std::min({t.z[0], t.z[1], t.z[2]})), biased(std::max({t.z[0], t.z[1], t.z[2]})),
          t.x[0],    t.y[0]};
}

/// Depth as a plane: base + dx * (x - x0) + dy * (y - y0) at a sample of pixel (x, y) of the frame, clamped to
/// [low, high]. The origin is the pixel of vertex 0, so that the value does not depend on the tile.
struct DepthPlane {
  float base, dx, dy, low, high;
  int32_t x0, y0;
};

/// The origin of a depth plane, and the vector from vertex 0 to its top left corner [pixels].
struct DepthOrigin {
  int32_t x, y;
  double step_x, step_y;
};
inline DepthOrigin origin_of(const DepthSlope& slope) {
  const int32_t x = slope.x >> geometry::kSubpixelBits, y = slope.y >> geometry::kSubpixelBits;
  const double to_pixels = 1.0 / geometry::kSubpixels;
  return {x, y, (x * geometry::kSubpixels - slope.x) * to_pixels, (y * geometry::kSubpixels - slope.y) * to_pixels};
}

inline DepthPlane plane_at(const DepthSlope& slope, SamplePoint sample) {
  const DepthOrigin origin = origin_of(slope);
  const double to_pixels = 1.0 / geometry::kSubpixels;
  const double step_x = origin.step_x + sample.x * to_pixels, step_y = origin.step_y + sample.y * to_pixels;
  return {static_cast<float>(slope.z + slope.dx * step_x + slope.dy * step_y),
          static_cast<float>(slope.dx),
          static_cast<float>(slope.dy),
          slope.low,
          slope.high,
          origin.x,
          origin.y};
}

/// Whether the triangle of three edges covers a point of pixel (x, y) of the tile.
inline bool covers(const EdgeLine (&lines)[3], int32_t x, int32_t y, SamplePoint point) {
  const int64_t right = int64_t{x} * geometry::kSubpixels + point.x;
  const int64_t down = int64_t{y} * geometry::kSubpixels + point.y;
  bool inside = true;
  for (const EdgeLine& line : lines) inside &= line.value + line.a * right + line.b * down >= 0;
  return inside;
}

/// Depth at a sample of pixel (x, y) of the frame, bit-equal to the coverage kernels.
inline float depth_at(const DepthPlane& plane, int32_t x, int32_t y) {
  const float row = plane.base + plane.dy * static_cast<float>(y - plane.y0);
  const float z = plane.dx * static_cast<float>(x - plane.x0) + row;
  return z < plane.low ? plane.low : z > plane.high ? plane.high : z;
}

}  // namespace shd::raster
