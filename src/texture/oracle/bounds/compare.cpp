// SPDX-License-Identifier: MIT
#include "texture/oracle/bounds/compare.h"

#include "data/compare.h"
#include "texture/format/formats.h"

namespace shd::texture {

Range reference_range(const Texture& texture, const Lookups& in, size_t i) {
  const auto reference =
      static_cast<double>(clamped_reference(texture.component, in.reference ? in.reference[i] : 0.0f));
  if (std::isnan(reference)) return unbounded();
  const double size = std::fabs(reference);
  switch (texture.component) {
    case image::Component::kUnorm8: return widened({reference, reference}, 0.5 / 255.0);
    case image::Component::kUnorm16: return widened({reference, reference}, 0.5 / 65535.0);
    case image::Component::kSrgb8: return widened({reference, reference}, 0x1p-23 * size);
    case image::Component::kFloat16: {
      // Half a unit in the last place. Magnitudes from 65520 on round to infinity.
      const Range rounded = widened({reference, reference}, std::fmax(0x1p-11 * size, 0x1p-25));
      return {reference <= -65520.0 ? -HUGE_VAL : rounded.low, reference >= 65520.0 ? HUGE_VAL : rounded.high};
    }
    default: break;
  }
  return {reference, reference};
}

Range compared_range(const Sampler& sampler, const Range& reference, const Range& texel) {
  const data::Comparison comparison = data::comparison_of(sampler.compare);
  const auto is_unbounded = [](const Range& range) { return range.low == -HUGE_VAL && range.high == HUGE_VAL; };
  Range out;
  if (is_unbounded(reference) || is_unbounded(texel)) {  // either may be NaN, which makes all but ALWAYS false
    for (const bool result : {comparison.less, comparison.equal, comparison.greater, comparison.unordered()}) {
      out.add(result);
    }
    return out;
  }
  if (reference.low < texel.high) out.add(comparison.less);
  if (reference.low <= texel.high && texel.low <= reference.high) out.add(comparison.equal);
  if (reference.high > texel.low) out.add(comparison.greater);
  return out;
}

}  // namespace shd::texture
