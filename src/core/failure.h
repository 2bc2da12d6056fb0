// SPDX-License-Identifier: MIT
/// @file
/// Errors that are thrown. In all three libraries `fail` stores a text and returns a result, `refuse` throws a Failure,
/// and a guard (core/guard.h) turns exceptions into results. This header needs no library.
#pragma once

#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <exception>

#include <shd/result.h>

#if defined(__GNUC__)
#define SHD_PRINTF(format_index, first) __attribute__((format(printf, format_index, first)))
#else
#define SHD_PRINTF(format_index, first)
#endif

namespace shd::core {

/// Size of an error text in bytes, including its terminator; longer texts are truncated.
constexpr size_t kErrorTextSize = 1024;

/// A result as an exception. It owns its text, because the worker process of libshd_io has no shd_last_error().
class Failure : public std::exception {
 public:
  Failure(shd_result result, const char* text) noexcept : code(result) {
    std::snprintf(text_, sizeof text_, "%s", text);
  }
  const char* what() const noexcept override { return text_; }

  shd_result code;

 private:
  char text_[kErrorTextSize];
};

/// Throws a Failure.
[[noreturn]] inline void refuse(shd_result code, const char* format, ...) SHD_PRINTF(2, 3);
[[noreturn]] inline void refuse(shd_result code, const char* format, ...) {
  char text[kErrorTextSize];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  throw Failure(code, text);
}

}  // namespace shd::core
