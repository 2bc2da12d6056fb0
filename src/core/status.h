// SPDX-License-Identifier: MIT
#pragma once

#include <shd/result.h>

#include "core/failure.h"

#ifdef NDEBUG
#define SHD_ASSERT(condition) ((void)0)
#else
#include <cassert>
#define SHD_ASSERT(condition) assert(condition)
#endif

/// Ends a path that no call takes: the values that lead to it are refused when an object is created.
#define SHD_UNREACHABLE() (SHD_ASSERT(false), __builtin_unreachable())

namespace shd::core {

/// Stores the text for shd_last_error() on this thread and returns `code`.
shd_result fail(shd_result code, const char* format, ...) noexcept SHD_PRINTF(2, 3);

/// Puts the formatted place, of at most 159 bytes, before the text of the last failure and returns `code`.
shd_result fail_within(shd_result code, const char* format, ...) noexcept SHD_PRINTF(2, 3);

/// The text of the latest failure on this thread; never null.
const char* last_error() noexcept;

}  // namespace shd::core
