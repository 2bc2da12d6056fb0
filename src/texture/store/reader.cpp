// SPDX-License-Identifier: MIT
#include "texture/store/reader.h"

#include "texture/store/storage.h"

namespace shd::texture {

const uint8_t* TexelReader::in_unit(uint32_t first, uint32_t width, uint32_t x, uint32_t y) {
  const UnitShape unit = texture_.layout.unit;
  const uint32_t number = first + (y >> unit.shift_y) * units_along(width, unit.shift_x) + (x >> unit.shift_x);
  const uint32_t in_x = x & ((1u << unit.shift_x) - 1), in_y = y & ((1u << unit.shift_y) - 1);
  return functions_of(texture_.store).texel(texture_, number, in_x, in_y, &memory_);
}

}  // namespace shd::texture
