// SPDX-License-Identifier: MIT
#include "texture/oracle/bounds/model.h"

#include <algorithm>

#include "image/srgb.h"

namespace shd::texture {
namespace {

/// 2^-bits.
double step_of(uint32_t bits) {
  return 1.0 / static_cast<double>(uint32_t{1} << bits);
}

/// Returns bounds of the decoded number `code` +- error. The curve is convex. Chords bound it from above, and their
/// extensions from below; at code 255 the extension is the tangent, of slope 2.4 / 1.055.
Range decoded(int code, double error) {
  const auto at = [](int c) { return static_cast<double>(image::kSrgb8ToLinear[c]); };
  constexpr double kRounding = 0x1p-24, kLastSlope = 2.4 / 1.055 / 255.0;
  const double value = at(code);
  const double slope_up = code < 255 ? at(code + 1) - value : kLastSlope;
  const double low = value - error * slope_up - kRounding * value;
  const double high = code < 255 ? value + error * slope_up + kRounding * value : 1.0;
  return {std::max(low, 0.0), high};
}

}  // namespace

BoundsModel make_bounds_model(const shd_bounds_desc& desc) {
  BoundsModel model;
  model.level_rules = desc.level_rules;
  model.subtexel = step_of(desc.subtexel_bits);
  model.level_step = step_of(desc.level_bits);
  model.weight = desc.weight_bits ? step_of(desc.weight_bits) : 0.0;
  model.result_step = desc.result_bits ? 0.5 / (1.0 / step_of(desc.result_bits) - 1.0) : 0.0;
  model.coordinate_error = static_cast<double>(desc.coordinate_error);
  model.derivative_error = static_cast<double>(desc.derivative_error);
  model.level_error = static_cast<double>(desc.level_error);
  model.relative_error = static_cast<double>(desc.relative_error);
  for (int code = 0; code < 256; ++code) model.srgb[code] = decoded(code, static_cast<double>(desc.srgb_error));
  return model;
}

shd_bounds_desc preset_of(shd_rules rules) {
  shd_bounds_desc desc = shd_bounds_desc_default();
  switch (rules) {
    case SHD_RULES_D3D11:
      desc.level_rules = SHD_LEVEL_RULE_LENGTHS | SHD_LEVEL_RULE_ELLIPSE;
      desc.subtexel_bits = desc.level_bits = 8;
      break;
    case SHD_RULES_WEBGPU: desc.level_rules |= SHD_LEVEL_RULE_OPENGL; break;
    case SHD_RULES_OPENGL: desc.level_rules = SHD_LEVEL_RULE_LENGTHS | SHD_LEVEL_RULE_OPENGL; break;
    default: break;
  }
  return desc;
}

}  // namespace shd::texture
