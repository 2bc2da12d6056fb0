// SPDX-License-Identifier: MIT
#include "tool/check/bounds.h"

#include <algorithm>
#include <cmath>

#include "command/failure.h"
#include "image/srgb.h"
#include "tool/check/levels.h"

Sampler make_sampler(shd_context* context, const Case& judged) {
  shd_sampler_desc desc = judged.sampler;
  desc.profile = judged.rules == SHD_RULES_D3D11 ? SHD_PROFILE_D3D11 : SHD_PROFILE_VULKAN;
  Sampler sampler;
  check(shd_sampler_create(context, &desc, sampler.out()), "sampler", kExitUsage);
  return sampler;
}

Bounds bounds_of_lookups(shd_context* context, const shd_texture* texture, const Case& judged) {
  Bounds out;
  const Sampler sampler = make_sampler(context, judged);
  const shd_lookups lookups = lookups_of(judged);
  shd_texels lower = shd_texels_default(), upper = shd_texels_default();
  for (size_t c = 0; c < 4; ++c) {
    out.low[c].resize(lookups.count);
    out.high[c].resize(lookups.count);
    lower.channel[c].data = out.low[c].data();
    upper.channel[c].data = out.high[c].data();
  }
  check(shd_texture_bounds(texture, sampler.get(), &lookups, &judged.bounds, &lower, &upper), "bounds", kExitUsage);
  return out;
}

namespace {

float curved(float bound, Curve curve) {
  if (!std::isfinite(bound)) return bound;
  const double x = static_cast<double>(bound);
  return static_cast<float>(curve == Curve::kDecoded ? shd::image::srgb_to_linear(x) : shd::image::linear_to_srgb(x));
}

/// Applies the curve to r, g and b, and the rounding of the results after it.
void finish(const Case& judged, float step, Bounds* bounds) {
  for (size_t c = 0; c < 4; ++c) {
    for (size_t i = 0; i < bounds->low[c].size(); ++i) {
      float &low = bounds->low[c][i], &high = bounds->high[c][i];
      if (judged.curve != Curve::kNone && c < 3) low = curved(low, judged.curve), high = curved(high, judged.curve);
      low -= step;
      high += step;
    }
  }
}

}  // namespace

Bounds find_bounds(Textures& textures, const Case& judged) {
  if (judged.count() == 0) return {};
  const bool in_library = is_stored(judged.decode) && judged.curve == Curve::kNone && !judged.is_shifted();
  if (in_library) return bounds_of_lookups(textures.context(), textures.get(judged.decode), judged);
  // The last step rounds the results, so the library must not.
  Case exact = judged;
  exact.bounds.result_bits = 0;
  Bounds out = judged.is_shifted() ? bounds_by_level(textures, exact)
                                   : bounds_of_lookups(textures.context(), textures.get(judged.decode), exact);
  const uint32_t bits = is_unorm(textures.base()) || judged.sampler.compares ? judged.bounds.result_bits : 0;
  finish(judged, bits ? 0.5f / (std::exp2(static_cast<float>(bits)) - 1.0f) : 0.0f, &out);
  return out;
}

float excess(const Case& judged, const Bounds& bounds, size_t place, size_t channel) {
  const float value = judged.result[channel][place];
  const float low = bounds.low[channel][place], high = bounds.high[channel][place];
  if (std::isnan(value)) return std::isinf(low) && std::isinf(high) ? 0.0f : INFINITY;
  return value < low ? low - value : value > high ? value - high : 0.0f;
}

int worst_channel(const Case& judged, const Bounds& bounds, size_t place) {
  int worst = -1;
  float farthest = 0.0f;
  for (size_t c = 0; c < 4; ++c) {
    if (judged.result[c].empty()) continue;
    const float away = excess(judged, bounds, place, c);
    if (away > farthest) {
      farthest = away;
      worst = static_cast<int>(c);
    }
  }
  return worst;
}
