// SPDX-License-Identifier: MIT
#pragma once

#include <exception>

#include <shd/result.h>

#if defined(__GNUC__)
#define SHD_PRINTF(format_index, first) __attribute__((format(printf, format_index, first)))
#else
#define SHD_PRINTF(format_index, first)
#endif

#ifdef NDEBUG
#define SHD_ASSERT(condition) ((void)0)
#else
#include <cassert>
#define SHD_ASSERT(condition) assert(condition)
#endif

namespace shd::core {

/// Stores the text for shd_last_error() on this thread and returns `code`.
shd_result fail(shd_result code, const char* format, ...) noexcept SHD_PRINTF(2, 3);

/// The text of the latest failure on this thread; never null.
const char* last_error() noexcept;

/// A result on its way to abi/guard.h; the text is already stored by fail().
struct Failure : std::exception {
  explicit Failure(shd_result result) : code(result) {}
  const char* what() const noexcept override { return last_error(); }
  shd_result code;
};

/// Throws unless `result` is SHD_OK.
inline void require(shd_result result) {
  if (result != SHD_OK) throw Failure(result);
}

}  // namespace shd::core
