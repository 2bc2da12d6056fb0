// SPDX-License-Identifier: MIT
#include "io/failure.h"

#include <cstdarg>
#include <cstdio>

namespace shd::io {

namespace {

/// Bytes of the UTF-8 character at `at`, 0 if there is none (RFC 3629, section 4; lone surrogates pass).
size_t utf8_length(const std::string& text, size_t at) {
  const auto lead = static_cast<unsigned char>(text[at]);
  if (lead < 0x80) return lead >= 0x20 && lead != 0x7f ? 1 : 0;
  const size_t length = lead >= 0xc2 && lead <= 0xdf   ? 2
                        : lead >= 0xe0 && lead <= 0xef ? 3
                        : lead >= 0xf0 && lead <= 0xf4 ? 4
                                                       : 0;
  if (length == 0 || at + length > text.size()) return 0;
  for (size_t i = 1; i < length; ++i) {
    if ((static_cast<unsigned char>(text[at + i]) & 0xc0) != 0x80) return 0;
  }
  return length;
}

std::string clean(const std::string& text) {
  std::string out;
  out.reserve(text.size());
  for (size_t i = 0; i < text.size();) {
    const size_t length = utf8_length(text, i);
    if (length == 0) {
      out += text[i] == '\n' || text[i] == '\t' ? ' ' : '?';
      ++i;
    } else {
      out.append(text, i, length);
      i += length;
    }
  }
  return out;
}

}  // namespace

std::string printable(const std::string& text) {
  constexpr size_t kHalf = 120;
  if (text.size() <= 2 * kHalf + 3) return clean(text);
  return clean(text.substr(0, kHalf)) + "..." + clean(text.substr(text.size() - kHalf));
}

void fail(shd_result code, const char* format, ...) {
  char text[1024];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  throw Failure(code, clean(text));
}

}  // namespace shd::io
