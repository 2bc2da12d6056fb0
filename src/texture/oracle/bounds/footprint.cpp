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

double length_of(const Vector& v) {
  double largest = 0.0, squares = 0.0;
  for (const double x : v.part) largest = std::max(largest, std::fabs(x));
  if (largest == 0.0 || !std::isfinite(largest)) return largest;
  for (const double x : v.part) squares += x / largest * (x / largest);
  return largest * std::sqrt(squares);
}

double dot(const Vector& a, const Vector& b) {
  return a.part[0] * b.part[0] + a.part[1] * b.part[1] + a.part[2] * b.part[2];
}

Vector cross(const Vector& a, const Vector& b) {
  const auto part = [&](int i, int j) { return a.part[i] * b.part[j] - a.part[j] * b.part[i]; };
  return {{part(1, 2), part(2, 0), part(0, 1)}};
}

/// Returns s a + t b.
Vector combined(double s, const Vector& a, double t, const Vector& b) {
  const auto part = [&](int i) { return s * a.part[i] + t * b.part[i]; };
  return {{part(0), part(1), part(2)}};
}

/// Singular values of the matrix of derivatives in texels, and the longer half axis of its ellipse. The smaller value
/// is the area of the parallelogram of the derivatives / longer, which does not cancel.
struct Ellipse {
  double longer, shorter;
  Vector axis;
};

Ellipse ellipse_of(const Vector& given_x, const Vector& given_y) {
  const double scale = std::max(length_of(given_x), length_of(given_y));
  if (scale == 0.0) return {0.0, 0.0, {}};
  const Vector x = combined(1.0 / scale, given_x, 0.0, given_y), y = combined(0.0, given_x, 1.0 / scale, given_y);
  // J^T J = [a b; b c]
  const double a = dot(x, x), b = dot(x, y), c = dot(y, y);
  const double root = std::sqrt(0.25 * (a - c) * (a - c) + b * b), square = 0.5 * (a + c) + root;
  const double longer = std::sqrt(square), shorter = length_of(cross(x, y)) / longer;
  // The eigenvector has two forms; the longer one has no cancellation.
  const double p = a > c ? square - c : b, q = a > c ? b : square - a, length = std::sqrt(p * p + q * q);
  const Vector axis = length > 0.0 ? combined(p / length, given_x, q / length, given_y) : given_x;
  return {longer * scale, shorter * scale, axis};
}

/// Legal sizes of a footprint, and the shorter sizes of its probes, in texels. `error` is that of every length.
struct Sizes {
  double error;
  Range size, probe;
  double ratio = 1.0;  // largest ratio of the axes

  double less(double x) const { return std::max(x - error, 0.0); }

  void add(double longest, double shortest, double least_shorter, double cap) {
    size.add({less(shortest), longest + error});
    probe.add({std::max(less(least_shorter), less(shortest) / cap), longest + error});
    ratio = std::max(ratio, less(least_shorter) > 0.0 ? (longest + error) / less(least_shorter) : cap);
  }
};

double largest_part(const Vector& v) {
  return std::max(std::max(std::fabs(v.part[0]), std::fabs(v.part[1])), std::fabs(v.part[2]));
}
double sum_of_parts(const Vector& v) {
  return std::fabs(v.part[0]) + std::fabs(v.part[1]) + std::fabs(v.part[2]);
}

void add_opengl(const Vector& x, const Vector& y, double cap, Sizes* sizes) {
  Vector m;
  for (int c = 0; c < 3; ++c) m.part[c] = std::max(std::fabs(x.part[c]), std::fabs(y.part[c]));
  const double least = sizes->less(largest_part(m)), most = sum_of_parts(m) + sizes->error;
  sizes->size.add({least, most});
  const double longer = std::max(length_of(x), length_of(y)) + sizes->error;
  const double shorter = sizes->less(std::min(length_of(x), length_of(y)));
  const double ratio = shorter > 0.0 ? std::min(longer / shorter * (1.0 + 1e-6), cap) : longer > 0.0 ? cap : 1.0;
  sizes->probe.add({least / std::ceil(ratio), most});
  sizes->ratio = std::max(sizes->ratio, ratio);
}

constexpr double kLeastErrorFiner = 0.7711054127039704;  // 2^-3/8

void add_profile(const Sampler& sampler, const Ellipse& e, bool mip_levels, double cap, Sizes* sizes) {
  if (sampler.profile != SHD_PROFILE_LEAST_ERROR) return sizes->add(e.longer, e.longer, e.shorter, cap);
  const double rms = std::sqrt(0.5 * (e.longer * e.longer + e.shorter * e.shorter));
  if (mip_levels) {
    sizes->size.add({sizes->less(rms) * kLeastErrorFiner, (rms + sizes->error) * kLeastErrorFiner});
  } else {
    sizes->size.add({sizes->less(e.longer), e.longer + sizes->error});
  }
  const double longer = sizes->less(e.longer), shorter = sizes->less(e.shorter);
  const double ratio = shorter > 0.0 ? longer / shorter : cap, width = longer / std::min(ratio, cap);
  sizes->probe.add({std::sqrt(0.5 * (width * width + shorter * shorter)) * kLeastErrorFiner, e.longer + sizes->error});
  sizes->ratio = std::max(sizes->ratio, shorter > 0.0 ? (e.longer + sizes->error) / shorter : cap);
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

/// Relative difference of half axes up to which the direction of the longer one is not certain.
constexpr double kRound = 1e-3;

/// Lists the axes along which probes may lie.
class AxisList {
 public:
  AxisList(const Texture& texture, double error, BoundsFootprint* out)
      : size_{static_cast<double>(texture.width), static_cast<double>(texture.height),
              static_cast<double>(std::max(texture.depth, 1u))},
        error_(error),
        out_(*out) {}

  void add_ellipse(const Ellipse& e) {
    add(e.axis);
    out_.round = e.longer <= (e.shorter + error_) * (1.0 + kRound) + error_;
    // An error turns the longer axis by an angle of about its quotient by the difference of both axes.
    if (error_ > 0.0 && !out_.round) out_.slop = 2.0 * error_ * e.longer / (e.longer - e.shorter);
  }

  /// Adds the columns that may be the longer one: both if their lengths differ by less than their approximations.
  void add_longer_columns(const Vector& x, const Vector& y, bool approximate) {
    const auto low = [&](const Vector& v) { return approximate ? largest_part(v) : length_of(v) * (1.0 - 1e-6); };
    const auto high = [&](const Vector& v) { return approximate ? 1.41421357 * sum_of_parts(v) : length_of(v); };
    if (high(x) + error_ >= low(y) - error_) add(x);
    if (high(y) + error_ >= low(x) - error_) add(y);
  }

 private:
  void add(const Vector& texels) {
    Vector& axis = out_.axis[out_.axis_count++];
    for (int c = 0; c < 3; ++c) axis.part[c] = texels.part[c] / size_[c];
  }

  const double size_[3], error_;
  BoundsFootprint& out_;
};

void find_axes_of(const Vector& x, const Vector& y, const Ellipse& e, uint32_t rules, AxisList axes) {
  if (rules & (SHD_LEVEL_RULE_ELLIPSE | SHD_LEVEL_RULE_PROFILE)) axes.add_ellipse(e);
  if (rules & (SHD_LEVEL_RULE_LENGTHS | SHD_LEVEL_RULE_VULKAN | SHD_LEVEL_RULE_OPENGL)) {
    axes.add_longer_columns(x, y, rules & (SHD_LEVEL_RULE_VULKAN | SHD_LEVEL_RULE_OPENGL));
  }
}

Sizes sizes_of(const Vector& x, const Vector& y, double error, const Ellipse& e, uint32_t rules,
               const Sampler& sampler) {
  const double cap = static_cast<double>(sampler.max_anisotropy);
  Sizes sizes = {error, {}, {}};
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

bool is_finite(const Vector& v) {
  return std::isfinite(v.part[0]) && std::isfinite(v.part[1]) && std::isfinite(v.part[2]);
}

}  // namespace

BoundsFootprint bounds_footprint(const Texture& texture, const Sampler& sampler, const BoundsModel& model,
                                 const Steps& steps, const double* given_lod) {
  BoundsFootprint out = {};
  if (given_lod) {
    out.lambda = out.probe_lambda = widened({*given_lod, *given_lod}, model.level_error);
    return out;
  }
  const auto in_texels = [&](const Vector& v) {
    return Vector{{v.part[0] * texture.width, v.part[1] * texture.height, v.part[2] * texture.depth}};
  };
  const Vector x = in_texels(steps.x), y = in_texels(steps.y);
  // Errors of four components change a length, a sum of parts or a singular value by at most 2 sqrt(2) errors.
  const double error = 3.0 * std::max(steps.error_x, steps.error_y) * std::max(texture.width, texture.height);
  if (!is_finite(x) || !is_finite(y)) {
    out.lambda = out.probe_lambda = {HUGE_VAL, HUGE_VAL};
    out.everywhere = true;
    return out;
  }
  const uint32_t rules = rules_of(sampler, model);
  const Ellipse e = ellipse_of(x, y);
  const Sizes sizes = sizes_of(x, y, error, e, rules, sampler);
  out.lambda = lambda_of(sizes.size, model);
  out.probe_lambda = lambda_of(sizes.probe, model);
  const double spread = (1.0 + model.derivative_error) / (1.0 - model.derivative_error);
  const double ratio = sizes.ratio * spread * (1.0 + 1e-6);
  const double probes = std::ceil(std::min(ratio, static_cast<double>(sampler.max_anisotropy)));
  out.reach = 0.5 * (1.0 - 1.0 / probes) * (1.0 + model.derivative_error);
  out.slop = 2.0 * error;
  find_axes_of(x, y, e, rules, AxisList(texture, error, &out));
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
