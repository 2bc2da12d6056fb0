// SPDX-License-Identifier: MIT
#pragma once

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <exception>

#include <shd/extension.h>

#if defined(__GNUC__)
#define SHD_EXTENSION_PRINTF(format_index, first) __attribute__((format(printf, format_index, first)))
#else
#define SHD_EXTENSION_PRINTF(format_index, first)
#endif

/// Errors of libraries that reach libshd through its public functions only.
namespace shd::extension {

/// Stores the text for shd_last_error() on this thread, as one line, and returns `code`.
inline shd_result fail_list(shd_result code, const char* format, va_list arguments) noexcept {
  const int saved_errno = errno;
  char text[1024];
  std::vsnprintf(text, sizeof text, format, arguments);
  for (char* c = text; *c; ++c) {
    if (static_cast<unsigned char>(*c) < 0x20) *c = ' ';
  }
  errno = saved_errno;
  return shd_report_error(code, text);
}

inline shd_result fail(shd_result code, const char* format, ...) noexcept SHD_EXTENSION_PRINTF(2, 3);
inline shd_result fail(shd_result code, const char* format, ...) noexcept {
  va_list arguments;
  va_start(arguments, format);
  fail_list(code, format, arguments);
  va_end(arguments);
  return code;
}

/// A result on its way to guard(); the text is already stored.
struct Failure : std::exception {
  explicit Failure(shd_result result) : code(result) {}
  const char* what() const noexcept override { return shd_last_error(); }
  shd_result code;
};

/// fail(), then throws.
[[noreturn]] inline void refuse(shd_result code, const char* format, ...) SHD_EXTENSION_PRINTF(2, 3);
[[noreturn]] inline void refuse(shd_result code, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  fail_list(code, format, arguments);
  va_end(arguments);
  throw Failure(code);
}

/// Throws unless `result` is SHD_OK.
inline void require(shd_result result) {
  if (result != SHD_OK) throw Failure(result);
}

}  // namespace shd::extension
