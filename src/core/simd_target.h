// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/context.h>

/// The function that HWY_EXPORT(name) compiled for `target`, chosen per context rather than per process:
/// `SHD_DISPATCH(kernel, context.simd)(arguments)`. HWY_EXPORT(name) must be in scope.
#define SHD_DISPATCH(name, target) (*(HWY_DISPATCH_TABLE(name)[(target).index]))

namespace shd::core {

/// One of the targets for which Highway compiled every kernel.
struct SimdTarget {
  size_t index = 0;       // row of Highway's dispatch tables
  const char* name = "";  // static
};

/// The best target for a choice. Throws Failure (SHD_ERROR_UNSUPPORTED) with the names of the targets that can run
/// here.
SimdTarget find_simd_target(shd_simd choice);

/// The lowest target of the build. It runs on every machine that can run the library.
SimdTarget baseline_target();

/// The target of one Highway bit, for tests that loop over hwy::SupportedAndGeneratedTargets().
SimdTarget simd_target_from_bit(int64_t bit);

}  // namespace shd::core
