// SPDX-License-Identifier: MIT
#include "texture/oracle/bounds/filters.h"

#include <algorithm>
#include <cmath>

namespace shd::texture {
namespace {

Color nearest_at(const BoundsCall& call, const Place& place, uint32_t level) {
  Color out;
  add_nearest_at(plane_of(call, place.layer, level), place, &out);
  return out;
}
Color linear_at(const BoundsCall& call, const Place& place, uint32_t level) {
  Color out;
  add_linear_at(plane_of(call, place.layer, level), place, kHere, &out);
  return out;
}

/// Adds at(level) of every level that may be the nearest one.
template <class At>
void add_nearest_levels(const BoundsCall& call, const Range& levels, At&& at, Color* out) {
  const double last = call.texture.level_count - 1;
  const auto first = static_cast<uint32_t>(std::max(std::ceil(levels.low + 0.5) - 1.0, 0.0));
  const auto end = static_cast<uint32_t>(std::min(std::floor(levels.high + 0.5), last));
  for (uint32_t level = first; level <= end; ++level) out->add(at(level));
}

/// Adds the blends of neighbouring levels. Between two levels a blend is linear in its level, so that its extremes lie
/// at the ends of the range and at the levels within it.
template <class At>
void add_blended_levels(const BoundsCall& call, const Range& levels, At&& at, Color* out) {
  const double last = call.texture.level_count - 1;
  const double low = std::min(std::max(levels.low, 0.0), last), high = std::min(std::max(levels.high, 0.0), last);
  for (double level = std::floor(low); level <= high; level += 1.0) {
    const double from = std::max(low, level) - level, to = std::min(high, level + 1.0) - level;
    const auto number = static_cast<uint32_t>(level);
    const Color fine = at(number);
    if (to == 0.0) {
      out->add(fine);
      continue;
    }
    const Color coarse = at(number + 1);
    out->add(mix(fine, coarse, from));
    out->add(mix(fine, coarse, to));
  }
}

void add_minified(const BoundsCall& call, const Place& place, const BoundsFootprint& footprint, Color* out) {
  const bool probes = call.sampler.filter == SHD_FILTER_ANISOTROPIC;
  const Range levels =
      final_levels(call.texture, call.sampler, call.model, probes ? footprint.probe_lambda : footprint.lambda);
  switch (call.sampler.filter) {
    case SHD_FILTER_NEAREST: return out->add(nearest_at(call, place, 0));
    case SHD_FILTER_BILINEAR: return out->add(linear_at(call, place, 0));
    case SHD_FILTER_NEAREST_MIP:
      return add_nearest_levels(
          call, levels, [&](uint32_t level) { return nearest_at(call, place, level); }, out);
    case SHD_FILTER_BILINEAR_MIP:
      return add_nearest_levels(
          call, levels, [&](uint32_t level) { return linear_at(call, place, level); }, out);
    default:
      return add_blended_levels(
          call, levels,
          [&](uint32_t level) {
            if (call.sampler.filter == SHD_FILTER_NEAREST_MIP_LINEAR) return nearest_at(call, place, level);
            if (!probes) return linear_at(call, place, level);
            Color color;
            add_probes(call, level, place, footprint, &color);
            return color;
          },
          out);
  }
}

/// The filter for magnification of filters of nearest texels is NEAREST by default, and BILINEAR of all others.
bool magnifies_linear(const Sampler& sampler) {
  if (sampler.magnification != SHD_MAGNIFICATION_DEFAULT) return sampler.magnification == SHD_MAGNIFICATION_BILINEAR;
  return sampler.filter != SHD_FILTER_NEAREST && sampler.filter != SHD_FILTER_NEAREST_MIP &&
         sampler.filter != SHD_FILTER_NEAREST_MIP_LINEAR;
}

}  // namespace

void add_filtered(const BoundsCall& call, const Place& place, const BoundsFootprint& footprint, Color* out) {
  Magnified side = {false, true};
  if (call.sampler.magnification != SHD_MAGNIFICATION_DEFAULT) {
    side = magnified(call.sampler, call.model, footprint.lambda);
    if (call.sampler.filter == SHD_FILTER_ANISOTROPIC) side.far = true;
  }
  if (side.near) out->add(magnifies_linear(call.sampler) ? linear_at(call, place, 0) : nearest_at(call, place, 0));
  if (side.far) add_minified(call, place, footprint, out);
}

}  // namespace shd::texture
