// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/context.h>

/// The function that HWY_EXPORT(name) compiled for `target`, chosen per context rather than per process:
/// `SHD_DISPATCH(kernel, context.simd)(arguments)`. Use where HWY_EXPORT(name) is in scope.
#define SHD_DISPATCH(name, target) (*(HWY_DISPATCH_TABLE(name)[(target).index]))

namespace shd::core {

/// One of the targets that Highway compiled every kernel for.
struct SimdTarget {
  size_t index = 0;       // row of Highway's dispatch tables
  const char* name = "";  // static
};

/// Resolves a choice; SHD_ERROR_UNSUPPORTED names what can run here.
shd_result find_simd_target(shd_simd choice, SimdTarget* out);

/// The one that the compiler's options ask for, which runs wherever the library does.
SimdTarget baseline_target();

/// The same for one Highway target bit, for tests that loop over hwy::SupportedAndGeneratedTargets().
SimdTarget simd_target_from_bit(int64_t bit);

}  // namespace shd::core
