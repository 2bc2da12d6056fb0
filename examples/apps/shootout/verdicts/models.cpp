// SPDX-License-Identifier: MIT
#include "models.h"

#include <algorithm>
#include <cmath>

namespace shootout {
namespace {

struct Steps {
  double ux, vx, uy, vy;
};

Steps steps_of(const Lookups& q, size_t i, double scale) {
  return {scale * static_cast<double>(q.dudx[i]), scale * static_cast<double>(q.dvdx[i]),
          scale * static_cast<double>(q.dudy[i]), scale * static_cast<double>(q.dvdy[i])};
}

double largest(const Steps& d) {
  return std::max(std::max(std::fabs(d.ux), std::fabs(d.uy)), std::max(std::fabs(d.vx), std::fabs(d.vy)));
}

/// The coarser level is the first one on which the filter is at most a texel wide; its share is 2 width - 1.
double openimageio_level(const Texture& texture, double width, bool one_level) {
  const uint32_t count = level_count(texture);
  for (uint32_t level = 0; level < count; ++level) {
    const double texels = width * level_edge(texture, level);
    if (texels > 1.0) continue;
    if (level == 0 || one_level) return level;
    return level - 1.0 + std::max(2.0 * texels - 1.0, 0.0);
  }
  return count - 1.0;
}

/// The ellipse A x^2 + B x y + C y^2 < kLast of the nearest finer level, in texels of this level, and its bounding box.
struct Ellipse {
  double a, b, c, width, height;
};
constexpr int kLast = 1023;  // last entry of the table of weights exp(-2 i / kLast)

Ellipse ellipse_of(const Steps& d) {
  Ellipse e;
  e.a = d.vx * d.vx + d.vy * d.vy + 1.0;
  e.b = -2.0 * (d.ux * d.vx + d.uy * d.vy);
  e.c = d.ux * d.ux + d.uy * d.uy + 1.0;
  const double f = e.a * e.c - 0.25 * e.b * e.b, det = 4.0 * e.a * e.c - e.b * e.b;
  e.width = 2.0 / det * std::sqrt(det * e.c * f);
  e.height = 2.0 / det * std::sqrt(det * e.a * f);
  for (double* x : {&e.a, &e.b, &e.c}) *x *= kLast / f;
  return e;
}

/// Sums texels of a level under the weights of an ellipse about (x, y).
void add_texels(const Texture& texture, uint32_t level, const Ellipse& e, double x, double y, bool texel_before,
                float* rgba) {
  const auto size = static_cast<int>(level_edge(texture, level));
  const uint8_t* const texels = level_texels(texture, level);
  double sum[4] = {}, total = 0.0;
  const auto wrapped = [&](int i) {
    if (!texel_before) return static_cast<size_t>((i % size + size) % size);
    const float at = static_cast<float>(i) / static_cast<float>(size);
    return static_cast<size_t>((at - std::floor(at)) * static_cast<float>(size));
  };
  const auto first = [](double at, double reach) { return static_cast<int>(std::floor(at - reach)); };
  const auto last = [](double at, double reach) { return static_cast<int>(std::ceil(at + reach)); };
  for (int j = first(y, e.height); j <= last(y, e.height); ++j) {
    for (int i = first(x, e.width); i <= last(x, e.width); ++i) {
      const double u = i - x, v = j - y, q = e.a * u * u + e.b * u * v + e.c * v * v;
      if (q >= kLast + 1) continue;
      const double weight = std::exp(-2.0 * std::floor(q) / kLast);
      const uint8_t* texel = &texels[4 * (wrapped(j) * static_cast<size_t>(size) + wrapped(i))];
      for (int c = 0; c < 4; ++c) sum[c] += weight * texel[c] / 255.0;
      total += weight;
    }
  }
  for (int c = 0; c < 4; ++c) rgba[c] = static_cast<float>(sum[c] / total);
}

}  // namespace

std::vector<float> openimageio_levels(const Texture& texture, const Lookups& q, bool one_level) {
  std::vector<float> lod;
  for (size_t i = 0; i < q.count(); ++i) {
    lod.push_back(static_cast<float>(openimageio_level(texture, largest(steps_of(q, i, 1.0)), one_level)));
  }
  return lod;
}

std::vector<float> llvmpipe_levels(const Texture& texture, const Lookups& q) {
  std::vector<float> lod;
  for (size_t i = 0; i < q.count(); ++i) {
    const Steps d = steps_of(q, i, texture.edge);
    const double rho = std::max(std::hypot(d.ux, d.vx), std::hypot(d.uy, d.vy));
    int exponent;
    const double mantissa = 2.0 * std::frexp(rho * rho, &exponent);
    lod.push_back(static_cast<float>(std::max(0.5 * (exponent - 1 + mantissa - 1.0), 0.0)));
  }
  return lod;
}

std::vector<float> llvmpipe_ellipses(const Texture& texture, const Lookups& q, bool texel_before) {
  std::vector<float> rgba(4 * q.count());
  for (size_t i = 0; i < q.count(); ++i) {
    const Steps base = steps_of(q, i, texture.edge);
    const double shorter = std::min(std::hypot(base.ux, base.vx), std::hypot(base.uy, base.vy));
    const double lod = std::min(std::max(std::floor(std::log2(shorter)), 0.0), level_count(texture) - 1.0);
    const auto level = static_cast<uint32_t>(lod);
    const double scale = std::exp2(-lod), size = texture.edge * scale;
    const Ellipse e = ellipse_of(steps_of(q, i, size));
    const double x = static_cast<double>(q.u[i]) * size - 0.5, y = static_cast<double>(q.v[i]) * size - 0.5;
    add_texels(texture, level, e, x, y, texel_before, &rgba[4 * i]);
  }
  return rgba;
}

}  // namespace shootout
