// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "texture/format/bc/decode.h"

namespace shd::texture {

/// A block of one channel: two endpoints of 8 bits, then 16 indices of three bits (RGTC).
struct CodeBlock {
  uint32_t first, second;  // endpoints as bytes
  uint64_t indices;        // three bits for each texel

  explicit CodeBlock(const uint8_t* block) {
    const uint64_t bits = bits_at<8>(block);
    first = static_cast<uint32_t>(bits & 255);
    second = static_cast<uint32_t>(bits >> 8 & 255);
    indices = bits >> 16;
  }
};

/// Sets the palette of endpoints a and b: six values between them if `sevenths`, else four values between them,
/// `low` and `high`. of(weighted sum, divisor) makes an entry.
template <class Number, class Entry, class Of>
void fill_palette(bool sevenths, Number a, Number b, Entry low, Entry high, const Of& of, Entry (&palette)[8]) {
  if (sevenths) {
    palette[0] = of(7 * a, Number{7});
    palette[1] = of(7 * b, Number{7});
    for (int i = 1; i < 7; ++i) palette[i + 1] = of((7 - i) * a + i * b, Number{7});
    return;
  }
  palette[0] = of(5 * a, Number{5});
  palette[1] = of(5 * b, Number{5});
  for (int i = 1; i < 5; ++i) palette[i + 1] = of((5 - i) * a + i * b, Number{5});
  palette[6] = low;
  palette[7] = high;
}

}  // namespace shd::texture
