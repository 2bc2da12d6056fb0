// SPDX-License-Identifier: MIT
#include "light/shadow_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/status.h"

namespace shd::light {
namespace {

constexpr double kMaxCoordinate = 1e18;
constexpr double kMinExtent = 1e-26;
constexpr double kMinNearPart = 1.0 / 256;  // minimum of near / far for fitted planes
constexpr double kRounding = 0x1p-20;       // relative error from positions to depths
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The smallest m 2^k >= value with an integer m in 8..16.
double rounded_up(double value) {
  int exponent;
  const double mantissa = std::frexp(value, &exponent);
  return std::ldexp(std::ceil(mantissa * 16.0) / 16.0, exponent);
}

void store(const double (&from)[3], float (&to)[3]) {
  for (int k = 0; k < 3; ++k) to[k] = static_cast<float>(from[k]);
}

}  // namespace

void ShadowFit::Interval::add(double value) {
  low = std::fmin(low, value);
  high = std::fmax(high, value);
}

ShadowFit::ShadowFit(const Light& light)
    : light_(light),
      is_cube_(light.kind == SHD_LIGHT_KIND_POINT ||
               (light.kind == SHD_LIGHT_KIND_SPOT && !(static_cast<double>(light.outer_tangent) <= kMaxSpotTangent))),
      across_{{kInfinity, -kInfinity}, {kInfinity, -kInfinity}},
      depth_{kInfinity, -kInfinity} {
  for (int k = 0; k < 3; ++k) {
    axes_.right[k] = light.right[k];
    axes_.down[k] = 0.0f - light.up[k];
    axes_.forward[k] = 0.0f - light.to_light[k];
  }
}

double ShadowFit::along(const float (&axis)[3], const double corner[3]) const {
  double sum = 0.0;
  for (int k = 0; k < 3; ++k) sum += static_cast<double>(axis[k]) * corner[k];
  return sum;
}

void ShadowFit::add(const double (&corners)[8][3]) {
  double low[3] = {kInfinity, kInfinity, kInfinity}, high[3] = {-kInfinity, -kInfinity, -kInfinity};
  for (const double(&corner)[3] : corners) {
    double q[3];
    for (int k = 0; k < 3; ++k) {
      largest_ = std::fmax(largest_, std::fabs(corner[k]));
      q[k] =
          light_.kind == SHD_LIGHT_KIND_DIRECTIONAL ? corner[k] : corner[k] - static_cast<double>(light_.position[k]);
      low[k] = std::fmin(low[k], q[k]);
      high[k] = std::fmax(high[k], q[k]);
    }
    if (is_cube_) continue;
    depth_.add(along(axes_.forward, q));
    if (is_limited_) continue;
    across_[0].add(along(axes_.right, q));
    across_[1].add(along(axes_.down, q));
  }
  if (!is_cube_) return;
  double nearest = 0.0;
  for (int k = 0; k < 3; ++k) {
    nearest = std::fmax(nearest, std::fmax(low[k], 0.0 - high[k]));
    depth_.add(std::fmax(high[k], 0.0 - low[k]));
  }
  depth_.add(nearest);
}

void ShadowFit::limit(const float low[3], const float high[3]) {
  is_limited_ = true;
  across_[0] = across_[1] = {kInfinity, -kInfinity};
  for (int i = 0; i < 8; ++i) {
    double corner[3];
    for (int k = 0; k < 3; ++k) {
      corner[k] = static_cast<double>(i >> k & 1 ? high[k] : low[k]);
      largest_ = std::fmax(largest_, std::fabs(corner[k]));
    }
    across_[0].add(along(axes_.right, corner));
    across_[1].add(along(axes_.down, corner));
  }
}

void ShadowFit::set_planes(float near, float far) {
  has_planes_ = true;
  near_ = static_cast<double>(near);
  far_ = static_cast<double>(far);
}

ShadowPlacement ShadowFit::place(const ShadowOptions& options) const {
  double largest = largest_;
  for (int k = 0; k < 3; ++k) largest = std::fmax(largest, std::fabs(static_cast<double>(light_.position[k])));
  if (!(largest <= kMaxCoordinate)) {
    core::refuse(SHD_ERROR_INVALID_ARGUMENT, "shadow_render.draws: bounds of %g exceed %g", largest, kMaxCoordinate);
  }
  ShadowPlacement placement = {};
  placement.kind = light_.kind;
  placement.axes = axes_;
  placement.face_count = is_cube_ ? 6 : 1;
  if (light_.kind == SHD_LIGHT_KIND_DIRECTIONAL) {
    place_directional(options, &placement);
  } else {
    place_around(options, &placement);
  }
  return placement;
}

/// Places a square of texels whose size and position are quantised, so that the grid stays fixed while the bounds move.
void ShadowFit::place_directional(const ShadowOptions& options, ShadowPlacement* out) const {
  const double inner =
      0.5 * options.size - filter_radius(options) - 1.0;  // largest distance of the bounds from the middle [texels]
  double middle[2] = {0.0, 0.0}, half = 0.0;
  for (int k = 0; k < 2; ++k) {
    if (across_[k].is_empty()) continue;
    middle[k] = 0.5 * (across_[k].low + across_[k].high);
    half = std::fmax(half, 0.5 * (across_[k].high - across_[k].low));
  }
  half = std::fmax(half, std::fmax(largest_ * 1e-4, kMinExtent));
  const double texel = rounded_up(half / inner);
  double near = has_planes_ ? near_ : depth_.low, far = has_planes_ ? far_ : depth_.high;
  if (!(near <= far)) near = far = 0.0;
  const double range = std::fmax(far - near, std::fmax(largest_ * 1e-4, kMinExtent));
  const double depth = 0.5 * (near + far), margin = has_planes_ ? 0.0 : range / 256.0;
  double origin[3];
  for (int k = 0; k < 3; ++k) {
    origin[k] = std::floor(middle[0] / texel + 0.5) * texel * static_cast<double>(axes_.right[k]) +
                std::floor(middle[1] / texel + 0.5) * texel * static_cast<double>(axes_.down[k]) +
                depth * static_cast<double>(axes_.forward[k]);
  }
  out->projection = ShadowProjection::kOrthographic;
  store(origin, out->origin);
  out->scale = static_cast<float>(1.0 / texel);
  out->near = static_cast<float>(near - depth - margin);
  out->far = static_cast<float>(far - depth + margin);
  out->guard = static_cast<float>(kRounding * (largest_ + 4.0 * half + range));
}

void ShadowFit::place_around(const ShadowOptions& options, ShadowPlacement* out) const {
  const double tangent = is_cube_ ? 1.0 : static_cast<double>(light_.outer_tangent);
  double near = near_, far = far_;
  if (!has_planes_) {
    far = depth_.high > 0.0 ? 1.01 * depth_.high : 1.0;
    far = std::fmax(far, kMinExtent);
    near = std::fmax(far * kMinNearPart, 0.99 * depth_.low < far ? 0.99 * depth_.low : 0.0);
  }
  out->projection = is_cube_ ? ShadowProjection::kCube : ShadowProjection::kPerspective;
  for (int k = 0; k < 3; ++k) out->origin[k] = light_.position[k];
  out->scale = static_cast<float>((0.5 * options.size - filter_radius(options)) / tangent);
  out->near = static_cast<float>(near);
  out->far = static_cast<float>(far);
  out->guard = static_cast<float>(kRounding * largest_);
  out->guard_square = static_cast<float>(2.0 * kRounding / near);
}

}  // namespace shd::light
