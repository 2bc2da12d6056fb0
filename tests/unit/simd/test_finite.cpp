// SPDX-License-Identifier: MIT
// Tests for finite values against the standard library, on every target.
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "unit/simd/test_finite.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/finite-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::tests::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// kept[i] = x[i] or 0; vector[i] = 1 if (x[i], 1, x[i]) and its rotations are finite. count is a multiple of the
/// lanes.
void evaluate(const float* x, size_t count, float* kept, float* vector) {
  const hn::ScalableTag<float> d;
  using Vec = simd::HWY_NAMESPACE::Vec3V<hn::Vec<decltype(d)>>;
  const auto one = hn::Set(d, 1.0f);
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto v = hn::LoadU(d, x + i);
    hn::StoreU(simd::HWY_NAMESPACE::FiniteOrZero(d, v), d, kept + i);
    const auto by_x = simd::HWY_NAMESPACE::IsFinite(d, Vec{v, one, one});
    const auto by_y = simd::HWY_NAMESPACE::IsFinite(d, Vec{one, v, one});
    const auto by_z = simd::HWY_NAMESPACE::IsFinite(d, Vec{one, one, v});
    const auto sum = hn::IfThenElseZero(by_x, one) + hn::IfThenElseZero(by_y, one);
    hn::StoreU(sum + hn::IfThenElseZero(by_z, one), d, vector + i);
  }
}

}  // namespace shd::tests::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "support/check.h"
#include "support/targets.h"

namespace shd::tests {
HWY_EXPORT(evaluate);
namespace {

constexpr size_t kCount = 4096;

void test_finite(void**) {
  static float x[kCount], kept[kCount], vector[kCount];
  const float edges[] = {0.0f,   -0.0f,   1.0f,     -FLT_MAX,  FLT_MAX, FLT_MIN,
                         1e-45f, -1e-45f, INFINITY, -INFINITY, NAN,     -NAN};
  for (size_t i = 0; i < kCount; ++i) {
    const uint32_t bits = static_cast<uint32_t>(i) * 0x00100001u;  // every exponent with both signs
    std::memcpy(&x[i], &bits, sizeof bits);
  }
  std::memcpy(x, edges, sizeof edges);
  for_each_target([&](const core::SimdTarget& target, bool) {
    SHD_DISPATCH(evaluate, target)(x, kCount, kept, vector);
    for (size_t i = 0; i < kCount; ++i) {
      const float want = std::isfinite(x[i]) ? x[i] : 0.0f;
      assert_memory_equal(&kept[i], &want, sizeof want);
      assert_true(vector[i] == (std::isfinite(x[i]) ? 3.0f : 0.0f));
    }
  });
}

}  // namespace
}  // namespace shd::tests

int main() {
  const CMUnitTest tests[] = {{"finite", shd::tests::test_finite, nullptr, nullptr, nullptr}};
  return cmocka_run_group_tests_name("unit.simd.finite", tests, nullptr, nullptr);
}
#endif  // HWY_ONCE
