// SPDX-License-Identifier: MIT
#pragma once

#include "texture/texture.h"

namespace shd::texture {

/// Lookups that are worked on together: their columns stay in the first-level cache.
constexpr size_t kBlock = 256;

template <class T>
T* part_of(T* column, size_t first) {
  return column ? column + first : nullptr;
}

/// Elements first..first + count - 1.
inline Lookups part_of(const Lookups& in, size_t first, size_t count) {
  return {count,
          in.u + first,
          in.v + first,
          part_of(in.dudx, first),
          part_of(in.dvdx, first),
          part_of(in.dudy, first),
          part_of(in.dvdy, first),
          part_of(in.lod, first),
          part_of(in.layer, first),
          part_of(in.random, first)};
}
inline Texels part_of(const Texels& out, size_t first) {
  Texels part;
  for (size_t c = 0; c < kOutputColumns; ++c) part.column(c) = part_of(out.column(c), first);
  return part;
}

}  // namespace shd::texture
