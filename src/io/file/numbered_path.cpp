// SPDX-License-Identifier: MIT
#include "io/file/numbered_path.h"

#include <algorithm>

#include "core/failure.h"
#include "io/file/printable.h"

namespace shd::io {

NumberedPath::NumberedPath(const char* pattern) {
  bool found = false;
  for (const char* c = pattern; *c; ++c) {
    std::string& part = found ? after_ : before_;
    if (*c != '%' || c[1] == '%') {
      c += *c == '%';
      part += *c;
      continue;
    }
    ++c;
    const bool padded = *c == '0';
    if (padded) ++c;
    const bool digit = *c >= '1' && *c <= '9';
    if (digit) width_ = static_cast<size_t>(*c++ - '0');
    if (*c != 'd' || found || (padded && !digit)) {
      core::refuse(SHD_ERROR_INVALID_ARGUMENT, "stack.pattern: \"%s\" does not have one place %%d, %%5d or %%05d",
                   printable(pattern).c_str());
    }
    padding_ = padded ? '0' : ' ';
    found = true;
  }
  if (!found) {
    core::refuse(SHD_ERROR_INVALID_ARGUMENT, "stack.pattern: \"%s\" has no place %%d, %%5d or %%05d",
                 printable(pattern).c_str());
  }
}

std::string NumberedPath::path(uint32_t number) const {
  const std::string digits = std::to_string(number);
  return before_ + std::string(width_ - std::min(width_, digits.size()), padding_) + digits + after_;
}

}  // namespace shd::io
