// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "scene/read/files.h"

namespace shd::scene {

/// A text file as UTF-8 without its byte order mark. Texts in UTF-16 are converted; `size` limits the bytes that are
/// read. Text without a byte order mark is taken as it is.
std::string utf8_of(const Bytes& bytes, size_t size = SIZE_MAX);

/// Statements of a text: lines that do not begin with #. Lines end with LF, CR or both.
class TextLines {
 public:
  /// With `continued`, a backslash at the end continues a line.
  explicit TextLines(const std::string& text, bool continued = true) : text_(text), continued_(continued) {}
  /// The next statement that is not empty, without the blanks around it. It stays until the next call. False at the
  /// end.
  bool next(std::string_view* statement);
  /// Number of the line at which the statement begins, from 1.
  uint64_t line() const { return first_line_; }

 private:
  std::string_view take_line();

  const std::string& text_;
  bool continued_;
  std::string joined_;
  size_t place_ = 0;
  uint64_t line_ = 0, first_line_ = 0;
};

/// Blank characters between words.
inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\0';
}

std::string_view trimmed(std::string_view text);

/// The part of a statement before a # that follows a blank, trimmed. Names may have such a #.
std::string_view without_comment(std::string_view statement);

/// Takes the first word off `rest`, and the blanks behind it; empty if there is none.
std::string_view take_word(std::string_view* rest);

/// Takes a word off `rest` if it is a number.
bool take_number(std::string_view* rest, double* out);

}  // namespace shd::scene
