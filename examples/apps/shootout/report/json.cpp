// SPDX-License-Identifier: MIT
#include "json.h"

#include <cmath>
#include <cstdio>

namespace shootout {

void Json::separate() {
  if (!first_) text_ += ',';
  first_ = false;
}

Json& Json::open(char bracket) {
  separate();
  text_ += bracket;
  first_ = true;
  return *this;
}

Json& Json::close(char bracket) {
  text_ += bracket;
  first_ = false;
  return *this;
}

Json& Json::key(const std::string& name) {
  value(name);
  text_ += ':';
  first_ = true;
  return *this;
}

Json& Json::value(const std::string& text) {
  separate();
  text_ += '"';
  for (const char c : text) {
    // "<" is escaped because the text lies inside a script element of HTML.
    if (c == '"' || c == '\\' || c == '<' || static_cast<unsigned char>(c) < 0x20) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(static_cast<unsigned char>(c)));
      text_ += escape;
    } else {
      text_ += c;
    }
  }
  text_ += '"';
  return *this;
}

Json& Json::value(double number, int digits) {
  separate();
  char text[40] = "null";
  if (std::isfinite(number)) std::snprintf(text, sizeof text, "%.*g", digits, number);
  text_ += text;
  return *this;
}

}  // namespace shootout
