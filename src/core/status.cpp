// SPDX-License-Identifier: MIT
#include "core/status.h"

#include <cerrno>
#include <cstdarg>
#include <cstdio>

namespace shd::core {
namespace {

constexpr size_t kTextSize = 1024;
thread_local char t_text[kTextSize];

}  // namespace

shd_result fail(shd_result code, const char* format, ...) noexcept {
  const int saved_errno = errno;
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(t_text, kTextSize, format, arguments);
  va_end(arguments);
  errno = saved_errno;
  return code;
}

const char* last_error() noexcept {
  return t_text;
}

}  // namespace shd::core
