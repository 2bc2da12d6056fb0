// SPDX-License-Identifier: MIT
#include "tool/check/levels.h"

#include <algorithm>
#include <cmath>

namespace {

bool is_nearest(shd_filter filter) {
  return filter == SHD_FILTER_NEAREST || filter == SHD_FILTER_NEAREST_MIP || filter == SHD_FILTER_NEAREST_MIP_LINEAR;
}

bool blends_levels(shd_filter filter) {
  return filter == SHD_FILTER_TRILINEAR || filter == SHD_FILTER_NEAREST_MIP_LINEAR;
}

/// The legal levels of detail of each row: the bounds of a lookup in a texture of the numbers of the levels.
Bounds legal_levels(Textures& textures, const Case& judged) {
  Case probe = judged;
  probe.sampler.filter = !reads_levels(judged.sampler.filter)   ? SHD_FILTER_NEAREST
                         : blends_levels(judged.sampler.filter) ? SHD_FILTER_NEAREST_MIP_LINEAR
                                                                : SHD_FILTER_NEAREST_MIP;
  probe.sampler.wrap_u = probe.sampler.wrap_v = SHD_WRAP_CLAMP;
  probe.sampler.compares = 0;
  probe.bounds.weight_bits = 0;
  probe.bounds.relative_error = 0.0f;
  return bounds_of_lookups(textures.context(), textures.level_numbers(), probe);
}

/// Bounds of all rows on one level, with the shift on this level.
Bounds on_level(Textures& textures, const Case& judged, uint32_t level) {
  Case one = judged;
  one.sampler.filter = is_nearest(judged.sampler.filter) ? SHD_FILTER_NEAREST_MIP : SHD_FILTER_BILINEAR_MIP;
  one.sampler.lod_bias = 0.0f;
  one.sampler.lod_min = one.sampler.lod_max = static_cast<float>(level);
  one.bounds.level_error = 0.0f;
  one.column[kLod].assign(judged.count(), static_cast<float>(level));
  const float width = static_cast<float>(std::max(textures.base().width >> level, 1u));
  const float height = static_cast<float>(std::max(textures.base().height >> level, 1u));
  for (float& u : one.column[kU]) u += judged.shift[0] / width;
  for (float& v : one.column[kV]) v += judged.shift[1] / height;
  return bounds_of_lookups(textures.context(), textures.get(judged.decode), one);
}

/// The lowest or highest value of `bound` over the levels low..high; between two levels it is linear.
template <class Better>
float over_levels(const std::vector<const float*>& bound, size_t i, float low, float high, Better better) {
  const auto at = [&](float lod) {
    const auto fine = std::min(static_cast<size_t>(lod), bound.size() - 1);
    const float share = lod - static_cast<float>(fine);
    if (share <= 0.0f || fine + 1 == bound.size()) return bound[fine][i];
    return bound[fine][i] + share * (bound[fine + 1][i] - bound[fine][i]);
  };
  float best = better(at(low), at(high));
  for (float lod = std::ceil(low); lod < high; lod += 1.0f) best = better(best, at(lod));
  return best;
}

}  // namespace

Bounds bounds_by_level(Textures& textures, const Case& judged) {
  const Bounds lods = legal_levels(textures, judged);
  std::vector<Bounds> levels;
  const float coarsest = *std::max_element(lods.high[0].begin(), lods.high[0].end());
  for (uint32_t level = 0; static_cast<float>(level) < coarsest + 1.0f && level < textures.level_count(); ++level)
    levels.push_back(on_level(textures, judged, level));
  Bounds out;
  for (size_t c = 0; c < 4; ++c) {
    std::vector<const float*> low, high;
    for (const Bounds& level : levels) low.push_back(level.low[c].data()), high.push_back(level.high[c].data());
    for (size_t i = 0; i < judged.count(); ++i) {
      const float fine = std::max(lods.low[0][i], 0.0f), coarse = lods.high[0][i];
      out.low[c].push_back(over_levels(low, i, fine, coarse, [](float a, float b) { return std::min(a, b); }));
      out.high[c].push_back(over_levels(high, i, fine, coarse, [](float a, float b) { return std::max(a, b); }));
    }
  }
  return out;
}
