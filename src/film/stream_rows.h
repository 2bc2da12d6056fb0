// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/simd_target.h"

namespace shd::film {

/// Rows of words: `stride` words lie between the beginnings of two rows.
template <class T>
struct Rows {
  T* word;
  size_t stride;
};

/// Copies rows to a framebuffer whose planes are larger than the caches. Whole cache lines are written past the caches:
/// ordinary stores would read them first. Call finish_streams() before another thread reads them.
void stream_rows(const core::SimdTarget& simd, const Rows<const uint32_t>& from, size_t width, size_t height,
                 const Rows<uint32_t>& to);

/// Makes the rows visible to threads that this thread synchronises with.
void finish_streams();

}  // namespace shd::film
