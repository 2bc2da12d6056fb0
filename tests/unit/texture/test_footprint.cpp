// SPDX-License-Identifier: MIT
// Axes of the footprint, width and blur against doubles, on every target and bit for bit between them.
#include <cmath>
#include <cstdint>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "unit/texture/test_footprint.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/domain/footprint-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// j: columns dudx, dvdx, dudy, dvdy; out: lambda, length, roundness, u, v, then the widened derivatives. Counts are
/// multiples of the lanes.
void EvaluateFootprint(const Sampler& sampler, const float* const* j, size_t count, float* const* out) {
  using D = hn::CappedTag<float, 16>;
  const D d;
  for (size_t i = 0; i < count; i += hn::Lanes(d)) {
    Derivatives<D> derivatives = {hn::LoadU(d, j[0] + i), hn::LoadU(d, j[1] + i), hn::LoadU(d, j[2] + i),
                                  hn::LoadU(d, j[3] + i)};
    if (widens(sampler)) Widen(d, sampler, &derivatives);
    const Footprint<D> f = FootprintOf(d, derivatives, 1.0f, 1.0f);
    hn::StoreU(f.lambda, d, out[0] + i);
    hn::StoreU(f.length, d, out[1] + i);
    hn::StoreU(f.roundness, d, out[2] + i);
    hn::StoreU(f.u, d, out[3] + i);
    hn::StoreU(f.v, d, out[4] + i);
    hn::StoreU(derivatives.dudx, d, out[5] + i);
    hn::StoreU(derivatives.dvdx, d, out[6] + i);
    hn::StoreU(derivatives.dudy, d, out[7] + i);
    hn::StoreU(derivatives.dvdy, d, out[8] + i);
  }
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "fixture.h"
#include "ref/footprint_ref.h"

namespace shd::texture {
HWY_EXPORT(EvaluateFootprint);
namespace {

constexpr size_t kColumns = 9;
constexpr size_t kCount = 8192;
float g_j[4][kCount], g_out[kColumns][kCount], g_first[kColumns][kCount];

/// Evaluates on every target into g_out; all bits must be equal.
void evaluate(const shd_sampler_desc& desc) {
  const float* in[] = {g_j[0], g_j[1], g_j[2], g_j[3]};
  float* out[kColumns];
  for (size_t c = 0; c < kColumns; ++c) out[c] = g_out[c];
  const Sampler sampler = make_sampler(desc);
  bool first = true;
  fixture::for_each_target([&](int64_t target) {
    SHD_DISPATCH(EvaluateFootprint, core::simd_target_from_bit(target))(sampler, in, kCount, out);
    if (first) std::memcpy(g_first, g_out, sizeof g_out);
    first = false;
    assert_memory_equal(g_first, g_out, sizeof g_out);
  });
}

struct case_t {
  const char* name;
  int low, high;   // exponents of the derivatives
  float flatness;  // distance of the second column from the first, 0 = independent
  float width_x, width_y, blur_u, blur_v;
};
const case_t k_cases[] = {
    {"footprint/texels", -4, 12, 0, 1, 1, 0, 0},
    {"footprint/tiny", -110, -90, 0, 1, 1, 0, 0},
    {"footprint/huge", 90, 99, 0, 1, 1, 0, 0},
    {"footprint/mixed", -100, 99, 0, 1, 1, 0, 0},
    {"footprint/nearly_parallel", -4, 12, 1e-3f, 1, 1, 0, 0},
    {"footprint/wide_x", -4, 12, 0, 4, 1, 0, 0},
    {"footprint/no_width", -4, 12, 0, 0, 0, 0, 0},
    {"footprint/narrow_y", -4, 12, 0, 1, 0.01f, 0, 0},
    {"footprint/blur", -8, 2, 0, 1, 1, 0.5f, 0.25f},
    {"footprint/blur_u", -8, 2, 0, 1, 1, 1, 0},
    {"footprint/blur_v_width", -8, 2, 0, 0.5f, 3, 0, 1},
    {"footprint/blur_of_huge", 90, 99, 0, 1, 1, 1, 1},
    {"footprint/blur_of_tiny", -110, -90, 0, 1, 1, 0.001f, 1},
    {"footprint/blur_parallel", -8, 2, 1e-3f, 1, 1, 0.01f, 0.01f},
};

void test_case(void** state) {
  const auto& c = *static_cast<const case_t*>(*state);
  fixture::Random random{7};
  for (size_t i = 0; i < kCount; ++i) {
    for (auto& column : g_j) {
      const auto exponent = c.low + static_cast<int>(random.next() >> 16) % (c.high - c.low);
      column[i] = std::ldexp(random.real(-1, 1), exponent);
    }
    if (c.flatness > 0) {
      const float factor = random.real(-2, 2);
      g_j[2][i] = factor * g_j[0][i] * (1 + c.flatness * random.real(-1, 1));
      g_j[3][i] = factor * g_j[1][i];
    }
  }
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.width_x = c.width_x;
  desc.width_y = c.width_y;
  desc.blur_u = c.blur_u;
  desc.blur_v = c.blur_v;
  evaluate(desc);
  for (size_t i = 0; i < kCount; ++i) {
    const auto in = [&](size_t k) { return static_cast<double>(g_j[k][i]); };
    const auto got = [&](size_t k) { return static_cast<double>(g_out[k][i]); };
    const ref::Covariance want = ref::covariance({in(0), in(1), in(2), in(3)}, desc, 1, 1);
    const ref::Ellipse e = ref::ellipse(want);
    // The widened derivatives have the requested covariance.
    const double square = e.a * e.a;
    shd_assert_close(c.name, i, got(5) * got(5) + got(7) * got(7), want.uu, 1e-6 * square, 0);
    shd_assert_close(c.name, i, got(5) * got(6) + got(7) * got(8), want.uv, 1e-6 * square, 0);
    shd_assert_close(c.name, i, got(6) * got(6) + got(8) * got(8), want.vv, 1e-6 * square, 0);
    if (e.a < 0x1p-126) continue;
    shd_assert_close(c.name, i, got(0), fmax(log2(e.a), -32), 2e-6, 5e-7);
    shd_assert_close(c.name, i, got(1), e.a, 0, 1e-6);
    const bool widened = memcmp(g_j, g_out[5], sizeof g_j) != 0;
    const double b = widened ? ref::ellipse(ref::Jacobian{got(5), got(6), got(7), got(8)}).b
                             : ref::ellipse(ref::Jacobian{in(0), in(1), in(2), in(3)}).b;
    shd_assert_close(c.name, i, got(2), b / e.a, 1e-6, 0);
    shd_assert_close(c.name, i, got(3) * got(3) + got(4) * got(4), 1, 1e-6, 0);
    // The sine of the angle between the axes, if one axis is longer.
    const double cross = got(3) * e.v - got(4) * e.u;
    const double round = got(2) * got(2);
    if (round < 0.9) shd_assert_close(c.name, i, cross, 0, 1e-6 / (1 - round), 0);
  }
}

/// Zero, denormal and infinite derivatives in every position.
void test_special(void**) {
  const float values[] = {0, 1e-45f, -1e-38f, 1e-30f, 1, -1e20f, 1e30f, 3.4e38f, INFINITY};
  constexpr size_t kValues = sizeof values / sizeof values[0];
  for (size_t i = 0; i < kCount; ++i) {
    size_t k = i;
    for (auto& column : g_j) {
      column[i] = values[k % kValues];
      k /= kValues;
    }
  }
  const shd_sampler_desc plain = shd_sampler_desc_default();
  shd_sampler_desc wide = plain;
  wide.width_x = 64;
  wide.width_y = 0;
  wide.blur_u = 1;
  for (const shd_sampler_desc& desc : {plain, wide}) {
    evaluate(desc);
    for (size_t i = 0; i < kCount; ++i) {
      for (size_t c = 0; c < 5; ++c) assert_true(std::isfinite(g_out[c][i]));
      for (const auto& column : g_out) assert_false(std::isnan(column[i]));
      assert_true(g_out[0][i] >= -32 && g_out[0][i] <= 129);
      assert_true(g_out[2][i] >= 0 && g_out[2][i] <= 1);
      bool infinite = false;
      for (size_t c = 5; c < 9; ++c) infinite |= std::isinf(g_out[c][i]);
      if (infinite) assert_true(g_out[0][i] == 126 && g_out[2][i] == 1);
    }
  }
}

}  // namespace
}  // namespace shd::texture

int main() {
  using namespace shd::texture;
  CMUnitTest tests[32];
  size_t n = 0;
  for (const case_t& c : k_cases) tests[n++] = {c.name, test_case, nullptr, nullptr, const_cast<case_t*>(&c)};
  tests[n++] = {"footprint/special", test_special, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.footprint", tests, n, nullptr, nullptr);
}
#endif
