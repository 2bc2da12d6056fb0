// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

#include <shd/result.h>

namespace shd::io {

/// A result and its text on their way to the ABI.
struct Failure : std::runtime_error {
  Failure(shd_result result, const std::string& text) : std::runtime_error(text), code(result) {}
  shd_result code;
};

/// Throws Failure; the text is made one line and printable.
[[noreturn]] void fail(shd_result code, const char* format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

/// `text` fit for a message: UTF-8 stays, control and stray bytes become '?', the middle of a long one is cut.
std::string printable(const std::string& text);

}  // namespace shd::io
