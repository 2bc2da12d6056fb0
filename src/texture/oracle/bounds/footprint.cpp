// SPDX-License-Identifier: MIT
#include "texture/oracle/bounds/footprint.h"

#include <algorithm>
#include <cmath>

namespace shd::texture {
namespace {

/// log2 x for x >= 0, by the series of the inverse hyperbolic tangent, so that it has the same bits on every machine.
/// |error| <= 1e-14 |log2 x| + 1e-14 before it is rounded to a multiple of 2^-40. The rounding makes the logarithms of
/// 2^(k/2) exact: they are on the grid of levels.
double log2_of(double x) {
  if (x == 0.0) return -HUGE_VAL;
  if (!std::isfinite(x)) return HUGE_VAL;
  int exponent;
  const double m = std::frexp(x, &exponent) * 1.4142135623730951;  // 0.7..1.42
  const double z = (m - 1.0) / (m + 1.0), square = z * z;
  double sum = 0.0;
  for (int k = 23; k >= 1; k -= 2) sum = 1.0 / k + square * sum;
  const double log2 = exponent - 0.5 + 2.8853900817779268 * z * sum;  // 2 / ln 2
  return std::floor(log2 * 0x1p40 + 0.5) * 0x1p-40;
}

double length_of(const Vector2& v) {
  const double largest = std::max(std::fabs(v.u), std::fabs(v.v));
  if (largest == 0.0 || !std::isfinite(largest)) return largest;
  const double u = v.u / largest, w = v.v / largest;
  return largest * std::sqrt(u * u + w * w);
}

/// Singular values of the matrix of derivatives in texels, and the longer half axis of its ellipse. The smaller value
/// is |det| / longer, which does not cancel.
struct Ellipse {
  double longer, shorter;
  Vector2 axis;
};

Ellipse ellipse_of(const Vector2& x, const Vector2& y) {
  const double scale = std::max(length_of(x), length_of(y));
  if (scale == 0.0) return {0.0, 0.0, {0.0, 0.0}};
  const double xu = x.u / scale, xv = x.v / scale, yu = y.u / scale, yv = y.v / scale;
  // J J^T = [a b; b c]
  const double a = xu * xu + yu * yu, b = xu * xv + yu * yv, c = xv * xv + yv * yv;
  const double root = std::sqrt(0.25 * (a - c) * (a - c) + b * b), square = 0.5 * (a + c) + root;
  const double longer = std::sqrt(square), shorter = std::fabs(xu * yv - xv * yu) / longer;
  // The eigenvector has two forms; the longer one has no cancellation.
  const Vector2 first = {b, square - a}, second = {square - c, b};
  const Vector2 direction = a > c ? second : first;
  const double length = length_of(direction);
  const Vector2 unit = length > 0.0 ? Vector2{direction.u / length, direction.v / length} : Vector2{1.0, 0.0};
  return {longer * scale, shorter * scale, {unit.u * longer * scale, unit.v * longer * scale}};
}

/// Legal sizes of a footprint, and the shorter sizes of its probes, in texels.
struct Sizes {
  Range size, probe;
  double ratio = 1.0;  // largest ratio of the axes

  void add(double longest, double shortest, double least_shorter, double cap) {
    size.add({shortest, longest});
    probe.add({std::max(least_shorter, shortest / cap), longest});
    ratio = std::max(ratio, least_shorter > 0.0 ? longest / least_shorter : cap);
  }
};

double largest_part(const Vector2& v) {
  return std::max(std::fabs(v.u), std::fabs(v.v));
}
double sum_of_parts(const Vector2& v) {
  return std::fabs(v.u) + std::fabs(v.v);
}

void add_opengl(const Vector2& x, const Vector2& y, double cap, Sizes* sizes) {
  const double u = std::max(std::fabs(x.u), std::fabs(y.u)), v = std::max(std::fabs(x.v), std::fabs(y.v));
  sizes->size.add({std::max(u, v), u + v});
  const double longer = std::max(length_of(x), length_of(y)), shorter = std::min(length_of(x), length_of(y));
  const double ratio = shorter > 0.0 ? std::min(longer / shorter * (1.0 + 1e-6), cap) : longer > 0.0 ? cap : 1.0;
  sizes->probe.add({std::max(u, v) / std::ceil(ratio), u + v});
  sizes->ratio = std::max(sizes->ratio, ratio);
}

constexpr double kLeastErrorFiner = 0.7711054127039704;  // 2^-3/8

void add_profile(const Sampler& sampler, const Ellipse& e, bool mip_levels, double cap, Sizes* sizes) {
  if (sampler.profile != SHD_PROFILE_LEAST_ERROR) return sizes->add(e.longer, e.longer, e.shorter, cap);
  const double rms = std::sqrt(0.5 * (e.longer * e.longer + e.shorter * e.shorter)) * kLeastErrorFiner;
  sizes->size.add(mip_levels ? rms : e.longer);
  const double ratio = e.shorter > 0.0 ? e.longer / e.shorter : cap, width = e.longer / std::min(ratio, cap);
  sizes->probe.add({std::sqrt(0.5 * (width * width + e.shorter * e.shorter)) * kLeastErrorFiner, e.longer});
  sizes->ratio = std::max(sizes->ratio, ratio);
}

bool has_mip_levels(const Sampler& sampler) {
  return sampler.filter != SHD_FILTER_NEAREST && sampler.filter != SHD_FILTER_BILINEAR;
}

uint32_t rules_of(const Sampler& sampler, const BoundsModel& model) {
  if (!(model.level_rules & SHD_LEVEL_RULE_PROFILE)) return model.level_rules;
  switch (sampler.profile) {
    case SHD_PROFILE_VULKAN: return model.level_rules | SHD_LEVEL_RULE_LENGTHS;
    case SHD_PROFILE_D3D11: return model.level_rules | SHD_LEVEL_RULE_ELLIPSE;
    default: return model.level_rules;
  }
}

/// An axis for probes, unless the list has it already.
void add_axis(const Vector2& texels, const Texture& texture, BoundsFootprint* out) {
  if (out->axis_count == 3) return;
  out->axis[out->axis_count++] = {texels.u / texture.width, texels.v / texture.height};
}

/// The columns that may be the longer one: both if their lengths differ by less than their approximations.
void add_longer_columns(const Vector2& x, const Vector2& y, bool approximate, const Texture& texture,
                        BoundsFootprint* out) {
  const auto low = [&](const Vector2& v) { return approximate ? largest_part(v) : length_of(v) * (1.0 - 1e-6); };
  const auto high = [&](const Vector2& v) { return approximate ? 1.41421357 * sum_of_parts(v) : length_of(v); };
  if (high(x) >= low(y)) add_axis(x, texture, out);
  if (high(y) >= low(x)) add_axis(y, texture, out);
}

/// Relative difference of half axes up to which the direction of the longer one is not certain.
constexpr double kRound = 1e-3;

void find_axes_of(const Vector2& x, const Vector2& y, const Ellipse& e, uint32_t rules, const Texture& texture,
                  BoundsFootprint* out) {
  if (rules & (SHD_LEVEL_RULE_ELLIPSE | SHD_LEVEL_RULE_PROFILE)) {
    add_axis(e.axis, texture, out);
    out->round = e.longer <= e.shorter * (1.0 + kRound);
  }
  if (rules & (SHD_LEVEL_RULE_LENGTHS | SHD_LEVEL_RULE_VULKAN | SHD_LEVEL_RULE_OPENGL)) {
    add_longer_columns(x, y, rules & (SHD_LEVEL_RULE_VULKAN | SHD_LEVEL_RULE_OPENGL), texture, out);
  }
}

Sizes sizes_of(const Vector2& x, const Vector2& y, const Ellipse& e, uint32_t rules, const Sampler& sampler) {
  const double cap = static_cast<double>(sampler.max_anisotropy);
  Sizes sizes;
  if (rules & SHD_LEVEL_RULE_LENGTHS) {
    const double a = length_of(x), b = length_of(y);
    sizes.add(std::max(a, b), std::max(a, b), std::min(a, b), cap);
  }
  if (rules & SHD_LEVEL_RULE_ELLIPSE) {
    // Direct3D 11 uses the derivatives as they are where they are parallel.
    const bool parallel = e.shorter <= 1e-6 * e.longer;
    sizes.add(e.longer, parallel ? std::max(length_of(x), length_of(y)) : e.longer, e.shorter, cap);
  }
  if (rules & SHD_LEVEL_RULE_VULKAN) {
    const double low = std::max(largest_part(x), largest_part(y));
    const double high = 1.4142135623730951 * std::max(sum_of_parts(x), sum_of_parts(y));
    sizes.add(high, low, std::min(largest_part(x), largest_part(y)), cap);
  }
  if (rules & SHD_LEVEL_RULE_OPENGL) add_opengl(x, y, cap, &sizes);
  const bool own = sampler.profile == SHD_PROFILE_LEAST_ERROR || sampler.profile == SHD_PROFILE_EXACT;
  if (rules & SHD_LEVEL_RULE_PROFILE && own) add_profile(sampler, e, has_mip_levels(sampler), cap, &sizes);
  return sizes;
}

Range lambda_of(const Range& size, const BoundsModel& model) {
  return {log2_of(size.low * (1.0 - model.derivative_error)) - model.level_error,
          log2_of(size.high * (1.0 + model.derivative_error)) + model.level_error};
}

bool is_finite(const Vector2& v) {
  return std::isfinite(v.u) && std::isfinite(v.v);
}

}  // namespace

BoundsFootprint bounds_footprint(const Texture& texture, const Sampler& sampler, const BoundsModel& model,
                                 const Steps& steps, const double* given_lod) {
  BoundsFootprint out = {};
  if (given_lod) {
    out.lambda = out.probe_lambda = widened({*given_lod, *given_lod}, model.level_error);
    return out;
  }
  const auto in_texels = [&](const Vector2& v) { return Vector2{v.u * texture.width, v.v * texture.height}; };
  const Vector2 x = in_texels(steps.x), y = in_texels(steps.y);
  if (!is_finite(x) || !is_finite(y)) {
    out.lambda = out.probe_lambda = {HUGE_VAL, HUGE_VAL};
    out.everywhere = true;
    return out;
  }
  const uint32_t rules = rules_of(sampler, model);
  const Ellipse e = ellipse_of(x, y);
  const Sizes sizes = sizes_of(x, y, e, rules, sampler);
  out.lambda = lambda_of(sizes.size, model);
  out.probe_lambda = lambda_of(sizes.probe, model);
  const double spread = (1.0 + model.derivative_error) / (1.0 - model.derivative_error);
  const double ratio = sizes.ratio * spread * (1.0 + 1e-6);
  const double probes = std::ceil(std::min(ratio, static_cast<double>(sampler.max_anisotropy)));
  out.reach = 0.5 * (1.0 - 1.0 / probes) * (1.0 + model.derivative_error);
  find_axes_of(x, y, e, rules, texture, &out);
  return out;
}

Range final_levels(const Texture& texture, const Sampler& sampler, const BoundsModel& model, const Range& lambda) {
  const double last = texture.level_count - 1, step = model.level_step;
  const double low = std::min(static_cast<double>(sampler.lod_min), last);
  const double high = std::min(static_cast<double>(sampler.lod_max), last);
  const auto clamp = [&](double x) { return std::min(std::max(x, low), high); };
  const double bias = static_cast<double>(sampler.lod_bias);
  return {std::floor(clamp(lambda.low + bias) / step) * step, std::ceil(clamp(lambda.high + bias) / step) * step};
}

Magnified magnified(const Sampler& sampler, const BoundsModel& model, const Range& lambda) {
  const auto clamp = [&](double x) {
    return std::min(std::max(x + static_cast<double>(sampler.lod_bias), static_cast<double>(sampler.lod_min)),
                    static_cast<double>(sampler.lod_max));
  };
  return {clamp(lambda.low) - model.level_step <= 0.0 && !(sampler.lod_min > static_cast<float>(model.level_step)),
          clamp(lambda.high) + model.level_step > 0.0 && sampler.lod_max > 0.0f};
}

}  // namespace shd::texture
