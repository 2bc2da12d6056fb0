// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "core/printable.h"

namespace shd::scene {

/// A string of a file, made printable and short enough for a message.
inline std::string text_of(const std::string& text) {
  std::string copy = text.substr(0, std::min(text.find('\0'), size_t{400}));
  core::make_printable(copy.data(), copy.size());
  return copy;
}

/// A copy with small letters in place of A to Z.
inline std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

}  // namespace shd::scene
