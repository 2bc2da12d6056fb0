// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "core/failure.h"

namespace shd::scene::gltf {

using Json = nlohmann::json;

/// A value of the JSON text and its place, such as "materials[3].alphaCutoff", for messages. The value may be absent.
/// All functions throw Failure (SHD_ERROR_CORRUPT) for a value of another type or range.
class Part {
 public:
  Part(const Json* json, std::string where) : json_(json), where_(std::move(where)) {}

  explicit operator bool() const { return json_ != nullptr; }
  const std::string& where() const { return where_; }
  const Json* json() const { return json_; }

  /// A member of an object; absent if there is none.
  Part operator[](const char* name) const;
  /// An extension of an object; absent if there is none.
  Part extension(const char* name) const { return (*this)["extensions"][name]; }

  /// Elements of an array; 0 if it is absent.
  size_t size() const;
  Part at(size_t index) const;

  /// The value itself.
  double number(double low = -kMaxFloat, double high = kMaxFloat) const;
  uint64_t integer(uint64_t high = kMaxInteger) const;
  std::string text() const;

  /// Members of an object. A required one throws if it is absent.
  double number(const char* name, double fallback, double low = -kMaxFloat, double high = kMaxFloat) const;
  float number_f(const char* name, float fallback, double low = -kMaxFloat, double high = kMaxFloat) const {
    return static_cast<float>(number(name, static_cast<double>(fallback), low, high));
  }
  uint64_t integer(const char* name, uint64_t fallback, uint64_t high = kMaxInteger) const;
  uint64_t required_integer(const char* name, uint64_t high = kMaxInteger) const;
  std::optional<uint32_t> index(const char* name, size_t count) const;
  bool flag(const char* name) const;
  std::string text(const char* name) const;
  template <class Number, size_t n>
  bool numbers(const char* name, std::array<Number, n>& out) const {
    const Part array = (*this)[name];
    if (!array) return false;
    if (array.size() != n) array.refuse("has " + std::to_string(array.size()) + " numbers, not " + std::to_string(n));
    for (size_t i = 0; i < n; ++i) out[i] = static_cast<Number>(array.at(i).number());
    return true;
  }

  /// Throws Failure: the place, and what is wrong.
  [[noreturn]] void refuse(const std::string& what, shd_result code = SHD_ERROR_CORRUPT) const;

 private:
  static constexpr double kMaxFloat = static_cast<double>(std::numeric_limits<float>::max());
  static constexpr uint64_t kMaxInteger = uint64_t{1} << 53;  // RFC 8259, section 6: exact in a double

  const Json* json_;
  std::string where_;
};

}  // namespace shd::scene::gltf
