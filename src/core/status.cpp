// SPDX-License-Identifier: MIT
#include "core/status.h"

#include <cstdarg>
#include <cstdio>
#include <cstring>

#include "core/errno_scope.h"

namespace shd::core {
namespace {

thread_local char t_text[kErrorTextSize];

}  // namespace

shd_result fail(shd_result code, const char* format, ...) noexcept {
  const ErrnoScope host_errno;
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(t_text, sizeof t_text, format, arguments);
  va_end(arguments);
  return code;
}

shd_result fail_within(shd_result code, const char* format, ...) noexcept {
  const ErrnoScope host_errno;
  char place[160];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(place, sizeof place, format, arguments);
  va_end(arguments);
  const size_t length = std::strlen(place), room = sizeof t_text - length - 1;
  std::memmove(t_text + length, t_text, room);
  std::memcpy(t_text, place, length);
  t_text[sizeof t_text - 1] = '\0';
  return code;
}

const char* last_error() noexcept {
  return t_text;
}

}  // namespace shd::core
