// SPDX-License-Identifier: MIT
/// @file
/// Texts to numbers. This header needs no library.
#pragma once

#include <charconv>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>

namespace shd::core {

/// The number that a whole word is, in the syntax of strtod() in the C locale without hexadecimals; infinite if it is
/// too large. False if the word is no number.
inline bool to_number(std::string_view word, double* out) {
  const bool has_plus = !word.empty() && word.front() == '+';
  if (has_plus) word.remove_prefix(1);
  if (word.empty() || (has_plus && (word.front() == '+' || word.front() == '-'))) return false;
#ifdef __cpp_lib_to_chars
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size()) return false;
  if (error == std::errc::result_out_of_range) {
    const size_t exponent = word.find_first_of("eE");
    const bool small = exponent != std::string_view::npos ? word.substr(exponent + 1, 1) == "-"
                                                          : word.find_first_of("123456789") > word.find('.');
    value = small ? 0 : std::numeric_limits<double>::infinity();
  } else if (error != std::errc()) {
    return false;
  }
#else
  // libc++ has no from_chars() for fractions, and its strtod() in Emscripten has no locales.
  if (word.find_first_of("xX \t\n\v\f\r") != std::string_view::npos) return false;
  const std::string text(word);
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (end != text.c_str() + text.size()) return false;
#endif
  *out = value;
  return true;
}

}  // namespace shd::core
