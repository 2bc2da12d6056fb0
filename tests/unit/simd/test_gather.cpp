// SPDX-License-Identifier: MIT
// Pairs of neighbouring words against plain reads, on every target, for floats and integers.
#include <cstddef>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "unit/simd/test_gather.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/gather-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::tests::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class T>
HWY_INLINE void Gather(const T* base, const int32_t* index, size_t count, T* left, T* right) {
  const hn::ScalableTag<T> d;
  const hn::RebindToSigned<decltype(d)> di;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    auto first = hn::Zero(d), second = hn::Zero(d);
    simd::HWY_NAMESPACE::GatherPairs(d, base, hn::LoadU(di, index + i), &first, &second);
    hn::StoreU(first, d, left + i);
    hn::StoreU(second, d, right + i);
  }
}

void GatherFloats(const float* base, const int32_t* index, size_t count, float* left, float* right) {
  Gather(base, index, count, left, right);
}
void GatherIntegers(const int32_t* base, const int32_t* index, size_t count, int32_t* left, int32_t* right) {
  Gather(base, index, count, left, right);
}

}  // namespace shd::tests::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "support/check.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {
HWY_EXPORT(GatherFloats);
HWY_EXPORT(GatherIntegers);
namespace {

constexpr size_t kCount = 256, kWords = 1000;

/// Indices on both sides of the base, in any order, with the first and the last pair among them.
void test_pairs(void**) {
  static float floats[kWords], left[kCount], right[kCount];
  static int32_t integers[kWords], index[kCount], left_integer[kCount], right_integer[kCount];
  Random random = {5};
  for (size_t i = 0; i < kWords; ++i) {
    floats[i] = random.real(-1.0, 1.0);
    integers[i] = random.whole(-1000000, 1000000);
  }
  const int32_t half = kWords / 2;
  for (int32_t& k : index) k = random.whole(-half, half - 2);
  index[0] = -half;
  index[1] = half - 2;
  for_each_target([&](const core::SimdTarget& target, bool) {
    SHD_DISPATCH(GatherFloats, target)(floats + half, index, kCount, left, right);
    SHD_DISPATCH(GatherIntegers, target)(integers + half, index, kCount, left_integer, right_integer);
    for (size_t i = 0; i < kCount; ++i) {
      const int32_t at = half + index[i];
      assert_true(left[i] == floats[at] && right[i] == floats[at + 1]);
      assert_true(left_integer[i] == integers[at] && right_integer[i] == integers[at + 1]);
    }
  });
}

}  // namespace
}  // namespace shd::tests

int main() {
  const CMUnitTest tests[] = {{"pairs", shd::tests::test_pairs, nullptr, nullptr, nullptr}};
  return cmocka_run_group_tests_name("unit.simd.gather", tests, nullptr, nullptr);
}
#endif  // HWY_ONCE
