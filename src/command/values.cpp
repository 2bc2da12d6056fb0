// SPDX-License-Identifier: MIT
#include "command/values.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace command {

Values text(std::string& out) {
  return {"", {}, out, [&out](const std::string& value) { return out = value, true; }};
}

Values file(std::string& out) {
  const auto read = [&out](const std::string& value) { return out = value, !value.empty(); };
  return {"the name of a file", {}, out, read, true};
}

Values flag(bool& out, bool value) {
  return {"", {}, "", [&out, value](const std::string&) { return out = value, true; }};
}

std::string join(const std::vector<std::string>& names, const char* last) {
  std::string all;
  for (size_t i = 0; i < names.size(); ++i) all += (i == 0 ? "" : i + 1 < names.size() ? ", " : last) + names[i];
  return all;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string digits(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", number);
  if (number == std::floor(number) && std::strtod(text, nullptr) != number)
    std::snprintf(text, sizeof text, "%.0f", number);
  std::string all = text;
  const size_t exponent = all.find('e');
  if (exponent == std::string::npos) return all;
  return all.substr(0, exponent + 1) + std::to_string(std::atoi(text + exponent + 1));
}

std::optional<std::vector<float>> read_numbers(const std::string& text, char separator) {
  std::vector<float> numbers;
  for (const std::string& part : split(text, separator)) {
    if (!read_number(part, numbers.emplace_back())) return std::nullopt;
  }
  return numbers;
}

Values one_of(std::string& out, const std::vector<std::string>& names) {
  const auto read = [&out, names](const std::string& text) {
    if (std::find(names.begin(), names.end(), text) == names.end()) return false;
    return out = text, true;
  };
  return {"one of " + join(names), names, out, read};
}

Values size(std::initializer_list<std::reference_wrapper<uint32_t>> sides, uint32_t high) {
  const std::vector<std::reference_wrapper<uint32_t>> out = sides;
  Values values;
  values.wanted = std::string("WIDTHxHEIGHT") + (out.size() > 2 ? "xDEPTH" : "") + ", each 1.." + digits(high);
  for (const uint32_t side : out) values.initial += (values.initial.empty() ? "" : "x") + std::to_string(side);
  if (out.front() == 0) values.initial = "";
  values.read = [out, high](const std::string& text) {
    const std::vector<std::string> parts = split(text, 'x');
    if (parts.size() != out.size()) return false;
    for (size_t i = 0; i < out.size(); ++i) {
      if (!number(out[i].get(), 1, high).read(parts[i])) return false;
    }
    return true;
  };
  return values;
}

}  // namespace command
