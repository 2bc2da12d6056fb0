// SPDX-License-Identifier: MIT
#pragma once
#include <charconv>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "command/program.h"

namespace command {

/// The name of a value of an enum on the command line.
template <class Value>
struct Name {
  std::string name;
  Value value;
};

/// Any text.
Values text(std::string& out);

/// The name of a file, which is not empty.
Values file(std::string& out);

/// A switch that sets `out` to `value`.
Values flag(bool& out, bool value = true);

/// "a, b or c".
std::string join(const std::vector<std::string>& names, const char* last = " or ");

/// Cuts a text at a separator.
std::vector<std::string> split(const std::string& text, char separator);

/// Whether a text, such as the name of a file, has this ending and something in front of it.
bool ends_with(const std::string& text, const std::string& end);

/// The digits of a number that --help or an error shows.
std::string digits(double number);

/// Reads a whole text as one number. Returns false for any other text, and for numbers that are not finite.
template <class T>
bool read_number(const std::string& text, T& out) {
  const char* const begin = text.data() + (text.size() > 1 && text[0] == '+' && text[1] != '-');
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(begin, end, out);
  if constexpr (std::is_floating_point_v<T>) {
    if (!std::isfinite(out)) return false;
  }
  return error == std::errc() && stop == end;
}

/// Numbers with a separator between them, or none if the text is another.
std::optional<std::vector<float>> read_numbers(const std::string& text, char separator = ',');

/// A number in low..high, in `unit`; a whole number for the types of such.
template <class T>
Values number(T& out, double low, double high, const std::string& unit = "") {
  const bool whole = std::is_integral_v<T>;
  Values values;
  values.wanted = (whole ? "a whole number " : "a number ") + digits(low) + ".." + digits(high) + unit;
  values.initial = digits(static_cast<double>(out));
  values.read = [&out, low, high](const std::string& text) {
    T value{};
    const bool fits = read_number(text, value) && value >= static_cast<T>(low) && value <= static_cast<T>(high);
    if (fits) out = value;
    return fits;
  };
  return values;
}

template <class T>
Values number(std::optional<T>& out, double low, double high, const std::string& unit = "") {
  T value{};
  Values values = number(value, low, high, unit);
  values.initial = "";
  values.read = [&out, low, high](const std::string& text) { return number(out.emplace(), low, high).read(text); };
  return values;
}

/// One of the names of a table. `out` has their type, or is an optional one.
template <class Out, class Value>
Values named(Out& out, const std::vector<Name<Value>>& table) {
  Values values;
  for (const Name<Value>& row : table) {
    values.names.push_back(row.name);
    if constexpr (std::is_same_v<Out, Value>) {
      if (row.value == out) values.initial = row.name;
    }
  }
  values.wanted = "one of " + join(values.names);
  values.read = [&out, table](const std::string& text) {
    for (const Name<Value>& row : table) {
      if (text == row.name) return out = row.value, true;
    }
    return false;
  };
  return values;
}

template <class Out, class Value, size_t kCount>
Values named(Out& out, const Name<Value> (&table)[kCount]) {
  return named(out, std::vector<Name<Value>>(table, table + kCount));
}

/// One of these texts.
Values one_of(std::string& out, const std::vector<std::string>& names);

/// Sides such as 640x480, each 1..high.
Values size(std::initializer_list<std::reference_wrapper<uint32_t>> sides, uint32_t high);

/// The same values with another text for an absent option.
inline Values initially(Values values, const std::string& initial) {
  values.initial = initial;
  return values;
}

/// The same values, which also set `given`.
inline Values marked(Values values, bool& given) {
  values.read = [read = values.read, &given](const std::string& text) { return given = true, read(text); };
  return values;
}

}  // namespace command
