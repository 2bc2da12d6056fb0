// SPDX-License-Identifier: MIT
#include "scene/read/text_lines.h"

#include <algorithm>

#include "core/number.h"

namespace shd::scene {
namespace {

void append_utf8(std::string& out, uint32_t code) {
  const auto byte = [&out](uint32_t value) { out.push_back(static_cast<char>(static_cast<unsigned char>(value))); };
  if (code < 0x80) return byte(code);
  if (code < 0x800) {
    byte(0xc0 | code >> 6);
  } else {
    if (code < 0x10000) {
      byte(0xe0 | code >> 12);
    } else {
      byte(0xf0 | code >> 18);
      byte(0x80 | (code >> 12 & 0x3f));
    }
    byte(0x80 | (code >> 6 & 0x3f));
  }
  byte(0x80 | (code & 0x3f));
}

/// Units of two bytes to UTF-8 (Unicode 3.9). A surrogate without its other half becomes the replacement character.
std::string from_utf16(const unsigned char* data, size_t count, bool big) {
  std::string out;
  const auto unit = [data, big](size_t i) {
    return static_cast<uint32_t>(data[2 * i + (big ? 0 : 1)] << 8 | data[2 * i + (big ? 1 : 0)]);
  };
  for (size_t i = 0; i < count; ++i) {
    uint32_t code = unit(i);
    if (code >= 0xd800 && code < 0xe000) {
      const uint32_t low = code < 0xdc00 && i + 1 < count ? unit(i + 1) : 0;
      const bool is_pair = low >= 0xdc00 && low < 0xe000;
      code = is_pair ? 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00) : 0xfffd;
      if (is_pair) ++i;
    }
    append_utf8(out, code);
  }
  return out;
}

bool is_continued(std::string_view line) {
  return !line.empty() && line.back() == '\\' && line.front() != '#' && without_comment(line).size() == line.size();
}

}  // namespace

std::string utf8_of(const Bytes& bytes, size_t size) {
  const size_t count = std::min(bytes.size, size);
  const unsigned char* const data = bytes.data;
  if (count >= 2 && ((data[0] == 0xff && data[1] == 0xfe) || (data[0] == 0xfe && data[1] == 0xff))) {
    return from_utf16(data + 2, count / 2 - 1, data[0] == 0xfe);
  }
  const bool mark = count >= 3 && data[0] == 0xef && data[1] == 0xbb && data[2] == 0xbf;
  return std::string(reinterpret_cast<const char*>(data) + (mark ? 3 : 0), count - (mark ? 3 : 0));
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view without_comment(std::string_view statement) {
  for (size_t i = 1; i < statement.size(); ++i) {
    if (statement[i] == '#' && is_blank(statement[i - 1])) return trimmed(statement.substr(0, i));
  }
  return statement;
}

std::string_view TextLines::take_line() {
  const size_t end = std::min(text_.find_first_of("\r\n", place_), text_.size());
  const std::string_view line(text_.data() + place_, end - place_);
  place_ = end + 1;
  if (end + 1 < text_.size() && text_[end] == '\r' && text_[end + 1] == '\n') ++place_;
  ++line_;
  return trimmed(line);
}

bool TextLines::next(std::string_view* statement) {
  while (place_ < text_.size()) {
    std::string_view line = take_line();
    first_line_ = line_;
    if (continued_ && is_continued(line)) {
      joined_.clear();
      for (; is_continued(line); line = place_ < text_.size() ? take_line() : std::string_view()) {
        joined_.append(line.substr(0, line.size() - 1)).push_back(' ');
      }
      line = trimmed(joined_.append(line));
    }
    *statement = line;
    if (!line.empty() && line.front() != '#') return true;
  }
  return false;
}

std::string_view take_word(std::string_view* rest) {
  size_t end = 0;
  while (end < rest->size() && !is_blank((*rest)[end])) ++end;
  const std::string_view word = rest->substr(0, end);
  while (end < rest->size() && is_blank((*rest)[end])) ++end;
  rest->remove_prefix(end);
  return word;
}

bool take_number(std::string_view* rest, double* out) {
  std::string_view after = *rest;
  if (!core::to_number(take_word(&after), out)) return false;
  *rest = after;
  return true;
}

}  // namespace shd::scene
