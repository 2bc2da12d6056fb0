// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstring>

#include "scene/read/gltf_document.h"

namespace shd::scene::gltf {
namespace {

constexpr uint32_t kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123, kUnsignedInt = 5125;

uint32_t components_of(const Part& accessor) {
  static constexpr struct {
    const char* name;
    uint32_t components;
  } kTypes[] = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
  const std::string type = accessor.text("type");
  for (const auto& row : kTypes) {
    if (type == row.name) return row.components;
  }
  accessor.refuse("type \"" + type + "\" is not supported");
}

/// `count` elements of `size` bytes, `stride` apart, from `offset` of a view on.
const unsigned char* elements_of(const Part& part, Bytes view, uint64_t offset, uint64_t count, uint64_t stride,
                                 uint64_t size) {
  if (count == 0) return view.data;
  if (offset > view.size || size > view.size - offset || (count - 1) > (view.size - offset - size) / stride) {
    part.refuse(std::to_string(count) + " elements, the first at byte " + std::to_string(offset) +
                ", lie outside the " + std::to_string(view.size) + " bytes of their buffer view");
  }
  return view.data + offset;
}

template <class Number>
double number_at(const unsigned char* at) {
  Number number;
  std::memcpy(&number, at, sizeof number);
  return static_cast<double>(number);
}

double plain_component(const unsigned char* at, uint32_t type) {
  switch (type) {
    case kByte: return number_at<int8_t>(at);
    case kUnsignedByte: return number_at<uint8_t>(at);
    case kShort: return number_at<int16_t>(at);
    case kUnsignedShort: return number_at<uint16_t>(at);
    case kUnsignedInt: return number_at<uint32_t>(at);
    default: return number_at<float>(at);
  }
}

/// The largest value of a normalised type, which becomes 1.
double unit_of(uint32_t type) {
  switch (type) {
    case kByte: return 127.0;
    case kUnsignedByte: return 255.0;
    case kShort: return 32767.0;
    case kUnsignedShort: return 65535.0;
    case kUnsignedInt: return 4294967295.0;
    default: return 1.0;
  }
}

size_t rows_of(const Accessor& accessor, const std::vector<uint32_t>* rows) {
  return rows ? rows->size() : accessor.count;
}

/// Calls `put(component's address)` for all components of the rows.
template <class Put>
void visit(const Accessor& accessor, const std::vector<uint32_t>* rows, Put put) {
  const size_t size = component_size(accessor.component_type);
  for (size_t i = 0; i < rows_of(accessor, rows); ++i) {
    const unsigned char* const at = accessor.data + (rows ? (*rows)[i] : i) * accessor.stride;
    for (uint32_t c = 0; c < accessor.components; ++c) put(at + c * size);
  }
}

/// Section 3.6.2.3: some elements differ. Makes a packed copy of all.
void apply_sparse(Document& document, const Part& sparse, Accessor& accessor) {
  const size_t size = component_size(accessor.component_type) * accessor.components;
  std::vector<unsigned char>& copy = make_bytes(document, static_cast<uint64_t>(accessor.count) * size);
  for (size_t i = 0; accessor.data && i < accessor.count; ++i) {
    std::memcpy(copy.data() + i * size, accessor.data + i * accessor.stride, size);
  }
  accessor.data = copy.data();
  accessor.stride = size;
  const uint64_t count = sparse.required_integer("count", accessor.count);
  const size_t views = document.root["bufferViews"].size();
  const Part indices = sparse["indices"], values = sparse["values"];
  const std::optional<uint32_t> index_view = indices.index("bufferView", views);
  const std::optional<uint32_t> value_view = values.index("bufferView", views);
  const auto type = static_cast<uint32_t>(indices.required_integer("componentType", 1u << 16));
  const size_t width = component_size(type);
  if (!index_view || !value_view || width == 0 || type == kFloat) sparse.refuse("has no indices or no values");
  const unsigned char* index =
      elements_of(indices, view_bytes(document, *index_view), indices.integer("byteOffset", 0), count, width, width);
  const unsigned char* value =
      elements_of(values, view_bytes(document, *value_view), values.integer("byteOffset", 0), count, size, size);
  for (uint64_t i = 0; i < count; ++i, index += width, value += size) {
    const double row = plain_component(index, type);
    if (!(row >= 0.0 && row < static_cast<double>(accessor.count))) indices.refuse("an index is out of range");
    std::memcpy(copy.data() + static_cast<size_t>(row) * size, value, size);
  }
}

}  // namespace

size_t component_size(uint64_t type) {
  switch (type) {
    case kByte:
    case kUnsignedByte: return 1;
    case kShort:
    case kUnsignedShort: return 2;
    case kUnsignedInt:
    case kFloat: return 4;
    default: return 0;
  }
}

Accessor open_accessor(Document& document, const Part& reference) {
  const Part accessors = document.root["accessors"];
  const uint64_t index = reference.integer();
  if (index >= accessors.size()) {
    reference.refuse(std::to_string(index) + " is not below the number " + std::to_string(accessors.size()) +
                     " of accessors");
  }
  const Part from = accessors.at(static_cast<size_t>(index));
  Accessor accessor;
  accessor.component_type = static_cast<uint32_t>(from.required_integer("componentType", 1u << 16));
  const size_t width = component_size(accessor.component_type);
  if (width == 0) from.refuse("componentType " + std::to_string(accessor.component_type) + " is not of glTF 2.0");
  accessor.components = components_of(from);
  accessor.normalized = from.flag("normalized") && accessor.component_type != kFloat;
  accessor.count = static_cast<size_t>(from.required_integer("count", std::numeric_limits<uint32_t>::max()));
  const size_t size = width * accessor.components;
  accessor.stride = size;
  const Part views = document.root["bufferViews"];
  if (const std::optional<uint32_t> view = from.index("bufferView", views.size())) {
    accessor.stride = static_cast<size_t>(views.at(*view).integer("byteStride", size, 252));
    if (accessor.stride < size) views.at(*view).refuse("its byteStride is smaller than an element");
    accessor.data = elements_of(from, view_bytes(document, *view), from.integer("byteOffset", 0), accessor.count,
                                accessor.stride, size);
  }
  if (const Part sparse = from["sparse"]) apply_sparse(document, sparse, accessor);
  return accessor;
}

std::vector<float> read_floats(const Accessor& accessor, const std::vector<uint32_t>* rows) {
  std::vector<float> out;
  if (!accessor.data) {
    out.resize(rows_of(accessor, rows) * accessor.components);
    return out;
  }
  out.reserve(rows_of(accessor, rows) * accessor.components);
  const uint32_t type = accessor.component_type;
  if (type == kFloat) {
    visit(accessor, rows, [&](const unsigned char* at) {
      float value;
      std::memcpy(&value, at, sizeof value);
      out.push_back(value);
    });
    return out;
  }
  const double unit = accessor.normalized ? unit_of(type) : 1.0;
  const double low = accessor.normalized ? -1.0 : -4294967296.0;
  visit(accessor, rows, [&](const unsigned char* at) {
    out.push_back(static_cast<float>(std::max(plain_component(at, type) / unit, low)));
  });
  return out;
}

std::vector<uint32_t> read_integers(const Accessor& accessor, const std::vector<uint32_t>* rows) {
  std::vector<uint32_t> out;
  if (!accessor.data) {
    out.resize(rows_of(accessor, rows) * accessor.components);
    return out;
  }
  out.reserve(rows_of(accessor, rows) * accessor.components);
  visit(accessor, rows, [&](const unsigned char* at) {
    const double value = plain_component(at, accessor.component_type);
    out.push_back(value >= 0.0 && value <= 4294967295.0 ? static_cast<uint32_t>(value) : 0xffffffffu);
  });
  return out;
}

}  // namespace shd::scene::gltf
