// SPDX-License-Identifier: MIT
#include "texture/store/storage.h"

#include <algorithm>

namespace shd::texture {

uint64_t lay_out(const UnitShape& unit, Texture* texture) {
  Layout& layout = texture->layout;
  layout.unit = unit;
  uint64_t units = 0;
  for (uint32_t level = 0; level < kMaxLevels; ++level) {
    layout.offset[level] = static_cast<uint32_t>(units);
    if (level >= texture->level_count) continue;
    const uint32_t slices = texture->depth != 0 ? level_size(texture->depth, level) : 1;
    units += uint64_t{slice_units(*texture, level)} * slices;
  }
  layout.layer_units = static_cast<uint32_t>(units);
  return units;
}

UnitPlace place_of_unit(const Texture& texture, uint32_t unit) {
  const Layout& layout = texture.layout;
  const uint32_t in_layer = unit % layout.layer_units;
  const uint32_t* const end = layout.offset + texture.level_count;
  const auto level = static_cast<uint32_t>(std::upper_bound(layout.offset, end, in_layer) - layout.offset) - 1;
  const uint32_t in_level = in_layer - layout.offset[level], slice = slice_units(texture, level);
  if (texture.depth != 0) return {in_level / slice, level, in_level % slice};
  return {unit / layout.layer_units, level, in_level};
}

}  // namespace shd::texture
