// SPDX-License-Identifier: MIT
#include "core/status.h"

#include <cstdarg>
#include <cstdio>

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

const char* last_error() noexcept {
  return t_text;
}

}  // namespace shd::core
