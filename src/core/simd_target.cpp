// SPDX-License-Identifier: MIT
#include "core/simd_target.h"

#include <cstdio>

#include <hwy/highway.h>

#include "core/failure.h"
#include "core/simd_name.h"

namespace shd::core {
namespace {

#ifdef HWY_SSE2
constexpr int64_t kSse2 = HWY_SSE2;
static_assert(kSse2 == 1LL << 14, "src/cmake/ShdTargets.cmake keeps this bit");
#else
constexpr int64_t kSse2 = 0;  // Highway up to 1.0.3 has no such target
#endif

#ifdef HWY_NEON_WITHOUT_AES
constexpr int64_t kNeon = HWY_NEON | HWY_NEON_WITHOUT_AES;  // the latter is the baseline of 64-bit ARM
#else
constexpr int64_t kNeon = HWY_NEON;
#endif

/// The Highway targets of an instruction set that a caller can choose.
struct Row {
  shd_simd choice;
  int64_t bits;
};

constexpr Row kRows[] = {
    {SHD_SIMD_SCALAR, HWY_SCALAR | HWY_EMU128},
    {SHD_SIMD_SSE2, kSse2},
    {SHD_SIMD_SSSE3, HWY_SSSE3},
    {SHD_SIMD_SSE4, HWY_SSE4},
    {SHD_SIMD_AVX2, HWY_AVX2},
    {SHD_SIMD_AVX512, HWY_AVX3},
    {SHD_SIMD_NEON, kNeon},
    {SHD_SIMD_WASM, HWY_WASM},
};

constexpr bool has_choice(int64_t targets) {
  for (const Row& row : kRows) targets &= ~row.bits;
  return targets == 0;
}
static_assert(has_choice(HWY_TARGETS), "a compiled target has no shd_simd: see src/cmake/ShdTargets.cmake");

/// Targets that are compiled in and can run on this machine. Highway caches hwy::SupportedTargets().
int64_t available_targets() {
#if (HWY_TARGETS & (HWY_TARGETS - 1)) == 0
  return HWY_TARGETS;  // nothing to detect, and no function of libhwy is needed
#else
  int64_t targets = hwy::SupportedTargets() & HWY_TARGETS;
  return targets ? targets : HWY_STATIC_TARGET;
#endif
}

}  // namespace

SimdTarget simd_target_from_bit(int64_t bit) {
  SimdTarget target;
  target.name = simd_target_name(bit);
#if (HWY_TARGETS & (HWY_TARGETS - 1)) != 0
  target.index = simd_target_index(bit);
#endif
  return target;
}

SimdTarget baseline_target() {
  return simd_target_from_bit(HWY_STATIC_TARGET);
}

SimdTarget find_simd_target(shd_simd choice) {
  const int64_t available = available_targets();
  int64_t wanted = available;  // the lowest bit is the best target
  if (choice == SHD_SIMD_BASELINE) {
    wanted = HWY_STATIC_TARGET;
  } else if (choice != SHD_SIMD_BEST) {
    wanted = 0;
    for (const Row& row : kRows) {
      if (row.choice == choice) wanted = row.bits & available;
    }
  }
  if (wanted == 0) {
    char names[128] = "";
    size_t used = 0;
    for (int64_t rest = available; rest != 0 && used < sizeof names; rest &= rest - 1) {
      const char* name = simd_target_name(rest & -rest);
      used += static_cast<size_t>(std::snprintf(names + used, sizeof names - used, " %s", name));
    }
    refuse(SHD_ERROR_UNSUPPORTED, "context.simd: %d cannot run here; available:%s", static_cast<int>(choice), names);
  }
  return simd_target_from_bit(wanted & -wanted);
}

}  // namespace shd::core
