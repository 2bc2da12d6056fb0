// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <shd/wrap.h>

namespace shd::texture {

/// Wraps index i on an axis of n texels (Vulkan 1.3 specification, "Wrapping Operation"). Returns -1 for the border
/// colour. This is the scalar twin of wrap-inl.h, for an index of any size.
inline int64_t wrap_index(shd_wrap wrap, int64_t i, int64_t n) {
  const bool inside = i >= 0 && i < n;
  if (inside) return i;
  switch (wrap) {
    case SHD_WRAP_REPEAT: {
      const int64_t rest = i % n;
      return rest < 0 ? rest + n : rest;
    }
    case SHD_WRAP_MIRROR: {
      const int64_t rest = i % (2 * n), period = rest < 0 ? rest + 2 * n : rest;
      return period < n ? period : 2 * n - 1 - period;
    }
    case SHD_WRAP_MIRROR_ONCE: {
      const int64_t folded = i < 0 ? -1 - i : i;
      return folded < n ? folded : n - 1;
    }
    case SHD_WRAP_BORDER: return -1;
    default: return i < 0 ? 0 : n - 1;
  }
}

}  // namespace shd::texture
