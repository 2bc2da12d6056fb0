// SPDX-License-Identifier: MIT
#pragma once

#include <cstdarg>
#include <cstdio>
#include <cstring>

#include <shd/extension.h>

#include "core/errno_scope.h"
#include "core/failure.h"
#include "core/printable.h"

namespace shd::extension {

using core::Failure;
using core::refuse;

/// Stores the text for shd_last_error() on this thread, as one line of UTF-8, and returns `code`.
inline shd_result fail(shd_result code, const char* format, ...) noexcept SHD_PRINTF(2, 3);
inline shd_result fail(shd_result code, const char* format, ...) noexcept {
  const core::ErrnoScope host_errno;
  char text[core::kErrorTextSize];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  core::make_printable(text, std::strlen(text));
  return shd_report_error(code, text);
}

/// Throws Failure unless `result` is SHD_OK. `result` must come from a function of libshd that stores a text.
inline void require(shd_result result) {
  if (result != SHD_OK) throw Failure(result, shd_last_error());
}

}  // namespace shd::extension
