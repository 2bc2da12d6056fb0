// SPDX-License-Identifier: MIT
#include "io/file/printable.h"

#include "core/printable.h"

namespace shd::io {
namespace {

std::string clean(std::string text) {
  core::make_printable(text.data(), text.size());
  return text;
}

}  // namespace

std::string printable(const std::string& text) {
  constexpr size_t kHalf = 120;
  if (text.size() <= 2 * kHalf + 3) return clean(text);
  return clean(text.substr(0, kHalf)) + "..." + clean(text.substr(text.size() - kHalf));
}

}  // namespace shd::io
