// SPDX-License-Identifier: MIT
#include "texture/store/storage.h"

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

}  // namespace shd::texture
