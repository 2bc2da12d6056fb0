// SPDX-License-Identifier: MIT
#include "film/stream_rows.h"

#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "film/stream_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <hwy/cache_control.h>

HWY_BEFORE_NAMESPACE();
namespace shd::film::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void StreamRows(Rows<const uint32_t> from, size_t width, size_t height, Rows<uint32_t> to) {
  const hn::ScalableTag<uint32_t> d;
  constexpr size_t kLine = 16;  // words
  static_assert(hn::MaxLanes(d) <= kLine, "a vector must not be longer than a line");
  for (; height > 0; --height, from.word += from.stride, to.word += to.stride) {
    size_t x = 0;
    const bool aligned = reinterpret_cast<uintptr_t>(to.word) % (kLine * sizeof(uint32_t)) == 0;
    for (; aligned && x + kLine <= width; x += kLine) {
      for (size_t i = x; i < x + kLine; i += hn::Lanes(d)) hn::Stream(hn::LoadU(d, from.word + i), d, to.word + i);
    }
    std::memcpy(to.word + x, from.word + x, (width - x) * sizeof(uint32_t));
  }
}

}  // namespace shd::film::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::film {

HWY_EXPORT(StreamRows);

void stream_rows(const core::SimdTarget& simd, const Rows<const uint32_t>& from, size_t width, size_t height,
                 const Rows<uint32_t>& to) {
  SHD_DISPATCH(StreamRows, simd)(from, width, height, to);
}

void finish_streams() {
  hwy::FlushStream();
}

}  // namespace shd::film
#endif  // HWY_ONCE
