// SPDX-License-Identifier: MIT
#include "scene/read/gltf_part.h"

#include "scene/text.h"

namespace shd::scene::gltf {

void Part::refuse(const std::string& what, shd_result code) const {
  core::refuse(code, "%s: %s", text_of(where_).c_str(), text_of(what).c_str());
}

Part Part::operator[](const char* name) const {
  const std::string where = where_.empty() ? name : where_ + "." + name;
  if (!json_) return {nullptr, where};
  if (!json_->is_object()) refuse("is not an object");
  const auto found = json_->find(name);
  return {found == json_->end() ? nullptr : &*found, where};
}

size_t Part::size() const {
  if (!json_) return 0;
  if (!json_->is_array()) refuse("is not an array");
  return json_->size();
}

Part Part::at(size_t index) const {
  if (index >= size()) refuse("has no element " + std::to_string(index));
  return {&(*json_)[index], where_ + "[" + std::to_string(index) + "]"};
}

double Part::number(double low, double high) const {
  if (!json_ || !json_->is_number()) refuse("is not a number");
  const double value = json_->get<double>();
  if (!(value >= low && value <= high)) {
    char text[96];
    std::snprintf(text, sizeof text, "%g is not in %g..%g", value, low, high);
    refuse(text);
  }
  return value;
}

uint64_t Part::integer(uint64_t high) const {
  const double value = number(0.0, static_cast<double>(high));
  if (value != static_cast<double>(static_cast<uint64_t>(value))) refuse("is not an integer");
  return static_cast<uint64_t>(value);
}

std::string Part::text() const {
  if (!json_ || !json_->is_string()) refuse("is not a text");
  return json_->get_ref<const std::string&>();
}

double Part::number(const char* name, double fallback, double low, double high) const {
  const Part part = (*this)[name];
  return part ? part.number(low, high) : fallback;
}

uint64_t Part::integer(const char* name, uint64_t fallback, uint64_t high) const {
  const Part part = (*this)[name];
  return part ? part.integer(high) : fallback;
}

uint64_t Part::required_integer(const char* name, uint64_t high) const {
  const Part part = (*this)[name];
  if (!part) part.refuse("is absent");
  return part.integer(high);
}

std::optional<uint32_t> Part::index(const char* name, size_t count) const {
  const Part part = (*this)[name];
  if (!part) return std::nullopt;
  const uint64_t value = part.integer(std::numeric_limits<uint32_t>::max());
  if (value >= count) {
    part.refuse(std::to_string(value) + " is not below the number " + std::to_string(count) + " of such parts");
  }
  return static_cast<uint32_t>(value);
}

bool Part::flag(const char* name) const {
  const Part part = (*this)[name];
  if (part && !part.json_->is_boolean()) part.refuse("is neither true nor false");
  return part && part.json_->get<bool>();
}

std::string Part::text(const char* name) const {
  const Part part = (*this)[name];
  return part ? part.text() : std::string();
}

}  // namespace shd::scene::gltf
