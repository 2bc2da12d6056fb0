// SPDX-License-Identifier: MIT
// Shadow lookups by direct formulas from the depths, point by point, in double.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "light/shadow.h"

namespace shd::ref {

/// A point on a map as defined in light/shadow.h, with the slopes of its surface.
struct ShadowPoint {
  bool inside;
  uint32_t face;
  double x, y, z, texel, dx, dy;
  double shift[2];  // shift of the taps of PCSS along x and y, 0..1
};

/// Hash of a word (Wellons, "Prospecting for Hash Functions", 2018, lowbias32).
inline uint32_t shadow_hash(uint32_t x) {
  x = (x ^ x >> 16) * 0x7feb352du;
  x = (x ^ x >> 15) * 0x846ca68bu;
  return x ^ x >> 16;
}

struct ShadowRef {
  const light::ShadowOptions& options;
  const light::ShadowPlacement& placement;
  const std::vector<float>& depths;  // [face][size][size]

  double at(uint32_t face, int x, int y) const {
    const int size = static_cast<int>(options.size);
    if (x < 0 || y < 0 || x >= size || y >= size) return INFINITY;
    const size_t row = (size_t{face} * options.size + static_cast<size_t>(y)) * options.size;
    return static_cast<double>(depths[row + static_cast<size_t>(x)]);
  }

  ShadowPoint locate(const float p[3], const float* n) const {
    const bool has_normal = n && std::isfinite(n[0]) && std::isfinite(n[1]) && std::isfinite(n[2]);
    double q[3], m[3] = {0, 0, 0};
    for (int k = 0; k < 3; ++k) {
      if (has_normal) m[k] = static_cast<double>(n[k]);
      q[k] = static_cast<double>(p[k]) - static_cast<double>(placement.origin[k]) +
             static_cast<double>(options.normal_offset) * m[k];
      if (!std::isfinite(q[k])) return {};
    }
    ShadowPoint out = {};
    uint32_t bits[3], hash = 0x9e3779b9u;
    std::memcpy(bits, p, sizeof bits);
    for (int k = 2; k >= 0; --k) hash = shadow_hash(hash + bits[k]);
    out.shift[0] = (hash >> 16) / 65536.0;
    out.shift[1] = (hash & 0xffff) / 65536.0;
    light::ShadowAxes axes = placement.axes;
    if (placement.projection == light::ShadowProjection::kCube) {
      int axis = std::fabs(q[0]) > std::fabs(q[1]) ? 0 : 1;
      if (std::fabs(q[2]) >= std::fabs(q[axis])) axis = 2;
      out.face = static_cast<uint32_t>(2 * axis + (q[axis] < 0 ? 1 : 0));
      axes = light::cube_axes(out.face);
    }
    const auto dot = [](const float(&a)[3], const double* b) {
      return static_cast<double>(a[0]) * b[0] + static_cast<double>(a[1]) * b[1] + static_cast<double>(a[2]) * b[2];
    };
    const double z = dot(axes.forward, q), scale = static_cast<double>(placement.scale);
    const bool is_perspective = placement.projection != light::ShadowProjection::kOrthographic;
    if (is_perspective && !(z > 0)) return {};
    const double w = is_perspective ? z : 1.0, a = dot(axes.right, q) / w, b = dot(axes.down, q) / w;
    out.x = 0.5 * options.size + scale * a;
    out.y = 0.5 * options.size + scale * b;
    out.inside = out.x >= 0 && out.y >= 0 && out.x <= options.size && out.y <= options.size;
    out.texel = w / scale;
    double facing = dot(axes.forward, m);
    if (is_perspective) facing += dot(axes.right, m) * a + dot(axes.down, m) * b;
    facing = std::copysign(std::max(std::fabs(facing), 1e-6), facing);
    const auto slope = [&](double component) { return std::min(std::max(-component / facing, -64.0), 64.0); };
    const double sx = has_normal ? slope(dot(axes.right, m)) : 0, sy = has_normal ? slope(dot(axes.down, m)) : 0;
    out.dx = sx * out.texel;
    out.dy = sy * out.texel;
    const double steepness = has_normal ? std::min(std::fabs(sx) + std::fabs(sy), 8.0) + 0.25
                             : options.filter == SHD_SHADOW_FILTER_PCF ? options.taps + 1.0
                                                                       : 2.0;
    out.z = z - (static_cast<double>(options.bias) + static_cast<double>(placement.guard) +
                 static_cast<double>(placement.guard_square) * z * z +
                 static_cast<double>(options.bias_slope) * steepness * out.texel);
    return out;
  }

  double plane(const ShadowPoint& p, int column, int row) const {
    return p.z + p.dx * (column + 0.5 - p.x) + p.dy * (row + 0.5 - p.y);
  }
  double lit(const ShadowPoint& p, int column, int row) const {
    return plane(p, column, row) <= at(p.face, column, row) ? 1.0 : 0.0;
  }
  /// The bilinear mean of four comparisons.
  double blend(const ShadowPoint& p, double x, double y) const {
    const int column = static_cast<int>(std::floor(x - 0.5)), row = static_cast<int>(std::floor(y - 0.5));
    const double fx = x - 0.5 - column, fy = y - 0.5 - row;
    return (1 - fy) * ((1 - fx) * lit(p, column, row) + fx * lit(p, column + 1, row)) +
           fy * ((1 - fx) * lit(p, column, row + 1) + fx * lit(p, column + 1, row + 1));
  }

  double hard(const ShadowPoint& p) const {
    const int last = static_cast<int>(options.size) - 1;
    return lit(p, std::min(static_cast<int>(std::floor(p.x)), last), std::min(static_cast<int>(std::floor(p.y)), last));
  }
  double pcf(const ShadowPoint& p) const {
    double sum = 0;
    for (uint32_t i = 0; i < options.taps; ++i) {
      for (uint32_t j = 0; j < options.taps; ++j) {
        sum += blend(p, p.x + j + 0.5 - 0.5 * options.taps, p.y + i + 0.5 - 0.5 * options.taps);
      }
    }
    return sum / (options.taps * options.taps);
  }

  double chebyshev(double z, double mean, double variance) const {
    z = std::min(z, static_cast<double>(placement.far));
    const double v = std::max(variance, static_cast<double>(options.min_variance)), d = z - mean;
    if (!(d > 0)) return 1;
    const double bleed = static_cast<double>(options.bleed);
    return std::min(std::max((v / (v + d * d) - bleed) / (1 - bleed), 0.0), 1.0);
  }
  /// Adds a texel's depth and its square; empty texels have the far depth.
  void add_moments(uint32_t face, int x, int y, double weight, double (&sum)[3]) const {
    const double d = std::min(at(face, x, y), static_cast<double>(placement.far));
    sum[0] += weight;
    sum[1] += weight * d;
    sum[2] += weight * d * d;
  }
  double variance(const ShadowPoint& p) const {
    const int n = static_cast<int>(options.taps);
    const double x = p.x - 0.5 * n, y = p.y - 0.5 * n;
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    double sum[3] = {0, 0, 0};
    const double fx = x - column, fy = y - row;
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) {
        const double wx = j == 0 ? 1 - fx : j == n ? fx : 1.0, wy = i == 0 ? 1 - fy : i == n ? fy : 1.0;
        add_moments(p.face, column + j, row + i, wx * wy, sum);
      }
    }
    const double mean = sum[1] / sum[0];
    return chebyshev(p.z, mean, std::max(sum[2] / sum[0] - mean * mean, 0.0));
  }
  double summed_area(const ShadowPoint& p) const {
    const double max_width = static_cast<double>(options.size) / light::kMaxRadiusPart;
    const double half = std::min(std::max(0.5 * static_cast<double>(options.filter_size) / p.texel, 0.5), max_width);
    const double size = options.size;
    const auto held = [&](double v) { return std::min(std::max(v, 0.0), size); };
    const double x[2] = {held(p.x - half), held(p.x + half)}, y[2] = {held(p.y - half), held(p.y + half)};
    double sum[3] = {0, 0, 0};
    for (int row = static_cast<int>(y[0]); row < y[1]; ++row) {
      for (int column = static_cast<int>(x[0]); column < x[1]; ++column) {
        const double wx = std::min(x[1], column + 1.0) - std::max(x[0], double(column));
        const double wy = std::min(y[1], row + 1.0) - std::max(y[0], double(row));
        add_moments(p.face, column, row, wx * wy, sum);
      }
    }
    const double mean = sum[1] / sum[0];
    return chebyshev(p.z, mean, std::max(sum[2] / sum[0] - mean * mean, 0.0));
  }

  /// Half the width of a penumbra in texels.
  double half_width(const ShadowPoint& p, double blocker) const {
    double width = 0.5 * static_cast<double>(options.light_size) * std::max(p.z - blocker, 0.0);
    if (placement.projection != light::ShadowProjection::kOrthographic) {
      width /= std::max(blocker, static_cast<double>(placement.near));
    }
    return std::min(width / p.texel, static_cast<double>(options.size) / light::kMaxRadiusPart);
  }
  /// Tap (column, row) of n x n in the square -1..1: one in each cell, in the canonical arrangement of multi-jittered
  /// samples, shifted and wrapped within its cell.
  void tap(const ShadowPoint& p, uint32_t column, uint32_t row, double (&out)[2]) const {
    const double n = options.taps;
    out[0] = 2.0 * (column + std::fmod((row + 0.5) / n + p.shift[0], 1.0)) / n - 1.0;
    out[1] = 2.0 * (row + std::fmod((column + 0.5) / n + p.shift[1], 1.0)) / n - 1.0;
  }
  /// Mean depth of the blockers; infinity if there is none. A blocker that a ray to the light cannot meet counts only
  /// if there is no other.
  double mean_blocker(const ShadowPoint& p) const {
    const uint32_t n = options.taps;
    const double search = std::max(half_width(p, static_cast<double>(placement.near)), 1.0);
    const bool is_perspective = placement.projection != light::ShadowProjection::kOrthographic;
    double sum[2] = {0, 0}, count[2] = {0, 0};  // all blockers, and those that a ray to the light meets
    for (uint32_t i = 0; i < n; ++i) {
      for (uint32_t j = 0; j < n; ++j) {
        double t[2];
        tap(p, j, i, t);
        const double x = search * t[0] * t[0] * t[0], y = search * t[1] * t[1] * t[1];
        const int column = static_cast<int>(std::floor(p.x + x)), row = static_cast<int>(std::floor(p.y + y));
        const double depth = at(p.face, column, row);
        if (!(depth < plane(p, column, row))) continue;
        const double width = 0.5 * static_cast<double>(options.light_size) * (p.z - depth) / p.texel;
        const bool meets = std::max(std::fabs(x), std::fabs(y)) - 2.0 <= (is_perspective ? width / depth : width);
        for (int k = 0; k <= (meets ? 1 : 0); ++k) {
          sum[k] += depth;
          count[k] += 1;
        }
      }
    }
    const int k = count[1] > 0 ? 1 : 0;
    return count[k] > 0 ? sum[k] / count[k] : INFINITY;
  }
  double pcss(const ShadowPoint& p) const {
    const uint32_t n = options.taps;
    const double blocker = mean_blocker(p);
    if (std::isinf(blocker)) return 1;
    const double half = half_width(p, blocker);
    double lit_sum = 0;
    for (uint32_t i = 0; i < n; ++i) {
      for (uint32_t j = 0; j < n; ++j) {
        double t[2];
        tap(p, j, i, t);
        lit_sum += blend(p, p.x + half * t[0], p.y + half * t[1]);
      }
    }
    return lit_sum / (n * n);
  }

  double visibility(const ShadowPoint& p) const {
    if (!p.inside) return 1;
    switch (options.filter) {
      case SHD_SHADOW_FILTER_PCF: return pcf(p);
      case SHD_SHADOW_FILTER_VARIANCE: return variance(p);
      case SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE: return summed_area(p);
      case SHD_SHADOW_FILTER_PCSS: return pcss(p);
      default: return hard(p);
    }
  }
};

}  // namespace shd::ref
