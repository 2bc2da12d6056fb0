// SPDX-License-Identifier: MIT
#include "peer_texels.h"

#include <algorithm>
#include <cmath>

namespace shootout {
namespace {

/// Derivatives of one lookup in texels of the level that the filter reads.
struct Axes {
  double ux, vx, uy, vy;
};

/// The level is log2 of the shorter axis, rounded as `round` does.
Axes axes_on_level(const Lookups& q, size_t i, double edge, double most, double (*round)(double)) {
  const auto texels = [&](const std::vector<float>& column) { return edge * static_cast<double>(column[i]); };
  Axes axes = {texels(q.dudx), texels(q.dvdx), texels(q.dudy), texels(q.dvdy)};
  const double x = std::hypot(axes.ux, axes.vx), y = std::hypot(axes.uy, axes.vy);
  const double shorter = std::max({std::min(x, y), std::max(x, y) / most, 1.0});
  const double scale = std::exp2(-round(std::log2(shorter)));
  for (double* value : {&axes.ux, &axes.vx, &axes.uy, &axes.vy}) *value *= scale;
  return axes;
}

/// Texels inside the ellipse, a lower bound on the reads. Mesa 22.3 averages nearest texels of one level inside
/// Heckbert's ellipse ("Fundamentals of Texture Mapping and Image Warping", 1989, p. 59), whose half axes are those of
/// the pixel, lengthened by 1 as variance: an area of pi sqrt(F).
double ellipse_texels(const Axes& p) {
  const double a = p.vx * p.vx + p.vy * p.vy + 1.0, b = -2.0 * (p.ux * p.vx + p.uy * p.vy);
  const double c = p.ux * p.ux + p.uy * p.uy + 1.0;
  return 3.14159265358979323846 * std::sqrt(a * c - b * b / 4.0);
}

/// Texels of bilinear probes. Mesa 25 averages as many probes along the longer axis as its length on the finer of two
/// levels has texels, but at most 16, after the example of the Vulkan specification ("Texel Anisotropic Filtering").
/// The length of an axis is its larger component there.
double probe_texels(const Axes& p) {
  const double x = std::max(std::fabs(p.ux), std::fabs(p.vx)), y = std::max(std::fabs(p.uy), std::fabs(p.vy));
  return 4.0 * std::clamp(std::ceil(std::max(x, y)), 1.0, 16.0);
}

}  // namespace

double mesa_texels(const Setting& setting, const Lookups& q, size_t i, double edge, double most) {
  if (setting.mesa < 25.0) return ellipse_texels(axes_on_level(q, i, edge, most, std::round));
  return probe_texels(axes_on_level(q, i, edge, most, std::floor));
}

}  // namespace shootout
