// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "texture/texture.h"

namespace shd::texture {

/// Lookups of a block, some of which are filtered in another way. Their copies take 6 KB of stack.
constexpr size_t kPart = 48;

/// Packed copies of some lookups of a block, and their results.
struct Gathered {
  float floats[kFloatColumns][kPart];
  uint32_t integers[kIntegerColumns][kPart];
  float results[kOutputColumns][kPart];
  uint32_t coarser[kPart];

  template <class T>
  static const T* gather(const T* column, const uint16_t* rows, size_t count, T* to) {
    if (!column) return nullptr;
    for (size_t i = 0; i < count; ++i) to[i] = column[rows[i]];
    return to;
  }

  Lookups load(const Lookups& in, const uint16_t* rows, size_t count) {
    Lookups some = in;
    some.count = count;
    for (size_t c = 0; c < kFloatColumns; ++c) some.real(c) = gather(in.real(c), rows, count, floats[c]);
    for (size_t c = 0; c < kIntegerColumns; ++c) some.integer(c) = gather(in.integer(c), rows, count, integers[c]);
    return some;
  }
  Texels wanted(const Texels& out) {
    Texels to;
    for (size_t c = 0; c < kOutputColumns; ++c) to.column(c) = out.column(c) ? results[c] : nullptr;
    to.coarser = out.coarser ? coarser : nullptr;
    return to;
  }
  void scatter(const uint16_t* rows, size_t count, const Texels& out) const {
    for (size_t c = 0; c < kOutputColumns; ++c) {
      if (!out.column(c)) continue;
      for (size_t i = 0; i < count; ++i) out.column(c)[rows[i]] = results[c][i];
    }
    for (size_t i = 0; out.coarser && i < count; ++i) out.coarser[rows[i]] = coarser[i];
  }
};

}  // namespace shd::texture
