// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace shd::io {

/// A path with one place for a number: %d, %5d or %05d; %% is a percent sign. No printf, because the text may come from
/// a user.
class NumberedPath {
 public:
  /// Throws Failure unless the pattern has one place of at most nine characters.
  explicit NumberedPath(const char* pattern);

  std::string path(uint32_t number) const;

 private:
  std::string before_, after_;
  size_t width_ = 0;
  char padding_ = ' ';
};

}  // namespace shd::io
