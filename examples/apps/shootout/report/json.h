// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace shootout {

/// Writes JSON (RFC 8259) value by value. Numbers that are not finite become null.
class Json {
 public:
  Json& begin_object() { return open('{'); }
  Json& begin_array() { return open('['); }
  Json& end_object() { return close('}'); }
  Json& end_array() { return close(']'); }
  Json& key(const std::string& name);
  Json& value(const std::string& text);
  Json& value(const char* text) { return value(std::string(text)); }
  Json& value(double number, int digits = 6);
  template <class T>
  Json& member(const std::string& name, const T& v) {
    key(name);
    return value(v);
  }
  Json& member(const std::string& name, double number, int digits) {
    key(name);
    return value(number, digits);
  }
  const std::string& text() const { return text_; }

 private:
  Json& open(char bracket);
  Json& close(char bracket);
  void separate();

  std::string text_;
  bool first_ = true;
};

}  // namespace shootout
