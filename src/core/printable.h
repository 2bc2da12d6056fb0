// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace shd::core {

/// Length in bytes of the printable UTF-8 character at `text`, of which `size` bytes are readable; 0 if there is none
/// (RFC 3629, section 4; lone surrogates are accepted).
inline size_t printable_length(const char* text, size_t size) {
  const auto lead = static_cast<unsigned char>(*text);
  if (lead < 0x80) return lead >= 0x20 && lead != 0x7f ? 1 : 0;
  const size_t length = lead >= 0xc2 && lead <= 0xdf   ? 2
                        : lead >= 0xe0 && lead <= 0xef ? 3
                        : lead >= 0xf0 && lead <= 0xf4 ? 4
                                                       : 0;
  if (length == 0 || length > size) return 0;
  for (size_t i = 1; i < length; ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) return 0;
  }
  return length;
}

/// Turns `size` bytes into one line of UTF-8: line ends and tabs become spaces, other control and invalid bytes '?'.
inline void make_printable(char* text, size_t size) noexcept {
  for (size_t i = 0; i < size;) {
    const size_t length = printable_length(text + i, size - i);
    if (length == 0) text[i] = text[i] == '\n' || text[i] == '\t' ? ' ' : '?';
    i += length == 0 ? 1 : length;
  }
}

}  // namespace shd::core
