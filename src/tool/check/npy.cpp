// SPDX-License-Identifier: MIT
#include "tool/check/npy.h"

#include <charconv>
#include <cstdint>
#include <cstring>

#include "command/failure.h"
#include "image/half.h"
#include "tool/check/table.h"

namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
  throw Failure(kExitInput, path + ": " + what);
}

/// Returns the text of the header, and where the data begin.
std::string header_of(const std::string& path, const std::string& bytes, size_t* begin) {
  if (bytes.size() < 12) refuse(path, "shorter than the header of .npy");
  uint32_t length = 0;
  const bool one = bytes[6] == 1;
  std::memcpy(&length, bytes.data() + 8, one ? 2 : 4);
  *begin = (one ? 10 : 12) + size_t{length};
  if (*begin > bytes.size() || length > 65536) refuse(path, "the header of .npy ends beyond the file");
  return bytes.substr(one ? 10 : 12, length);
}

NpyField field_of(const std::string& path, const std::string& name, const std::string& type, size_t offset) {
  for (const char* const known : {"<f2", "<f4", "<f8", "|u1", "<u2"}) {
    if (type == known) return {name, type[1], static_cast<size_t>(type[2] - '0'), offset};
  }
  refuse(path, "type " + type + " is not one of <f2 <f4 <f8 |u1 <u2");
}

/// Returns the place behind a key of the header and the spaces after it, or npos.
size_t behind(const std::string& header, const char* key) {
  const size_t at = header.find(key);
  return at == std::string::npos ? at : header.find_first_not_of(' ', at + std::strlen(key));
}

/// Reads a text in quotes at a place, and moves the place behind it. Returns whether there is one.
bool read_quoted(const std::string& header, size_t* at, std::string* out) {
  const size_t begin = header.find_first_not_of(' ', *at);
  if (begin == std::string::npos || header[begin] != '\'') return false;
  const size_t end = header.find('\'', begin + 1);
  if (end == std::string::npos) return false;
  *out = header.substr(begin + 1, end - begin - 1);
  *at = end + 1;
  return true;
}

/// Reads ('name', 'type') at the place of its bracket, and moves the place on.
bool read_pair(const std::string& header, size_t* at, std::string* name, std::string* type) {
  ++*at;
  if (!read_quoted(header, at, name) || *at == header.size() || header[*at] != ',') return false;
  ++*at;
  return read_quoted(header, at, type);
}

std::vector<NpyField> fields_of(const std::string& path, const std::string& header) {
  size_t at = behind(header, "'descr':"), offset = 0;
  std::string name, type;
  if (at != std::string::npos && read_quoted(header, &at, &type)) return {field_of(path, "", type, 0)};
  std::vector<NpyField> fields;
  for (at = header.find('(', at); at != std::string::npos; at = header.find('(', at)) {
    if (!read_pair(header, &at, &name, &type)) continue;
    fields.push_back(field_of(path, name, type, offset));
    offset += fields.back().size;
  }
  if (fields.empty()) refuse(path, "the header of .npy has no type");
  return fields;
}

std::vector<size_t> shape_of(const std::string& path, const std::string& header) {
  const size_t begin = behind(header, "'shape':"), end = header.find(')', begin);
  const bool closed = begin != std::string::npos && end != std::string::npos && header[begin] == '(';
  if (!closed) refuse(path, "the header of .npy has no shape");
  const std::string text = header.substr(begin + 1, end - begin - 1);
  if (text.find_first_not_of("0123456789, ") != std::string::npos) refuse(path, "the header of .npy has no shape");
  std::vector<size_t> shape;
  for (const std::string& size : split(text)) {
    if (size.empty()) continue;
    const auto read = std::from_chars(size.data(), size.data() + size.size(), shape.emplace_back());
    if (read.ec != std::errc()) refuse(path, "the shape is too large");
  }
  return shape;
}

template <class T>
T load(const char* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

}  // namespace

Npy parse_npy(const std::string& path, const std::string& bytes) {
  size_t begin;
  const std::string header = header_of(path, bytes, &begin);
  if (header.find("'fortran_order': False") == std::string::npos) refuse(path, "the array is not in row-major order");
  Npy out = {fields_of(path, header), shape_of(path, header), 0, 1, bytes.data() + begin};
  for (const NpyField& field : out.fields) out.element_size += field.size;
  const size_t most = (bytes.size() - begin) / out.element_size;
  for (const size_t size : out.shape) {
    if (size != 0 && out.count > most / size) refuse(path, "the file is shorter than its array");
    out.count *= size;
  }
  if (out.count * out.element_size != bytes.size() - begin) refuse(path, "the file is longer than its array");
  return out;
}

double npy_value(const Npy& array, const NpyField& field, size_t i) {
  const char* const from = array.data + i * array.element_size + field.offset;
  if (field.kind == 'u') return field.size == 1 ? load<uint8_t>(from) : load<uint16_t>(from);
  if (field.size == 2) return static_cast<double>(shd::image::half_to_float(load<uint16_t>(from)));
  return field.size == 4 ? static_cast<double>(load<float>(from)) : load<double>(from);
}

Table read_npy_table(const std::string& path, const std::string& bytes, const std::vector<std::string>& names) {
  const Npy array = parse_npy(path, bytes);
  Table table;
  if (!array.fields.front().name.empty()) {
    for (const NpyField& field : array.fields) {
      if (table.find(field.name)) refuse(path, "two columns have the name " + field.name);
      std::vector<float> column(array.count);
      for (size_t i = 0; i < array.count; ++i) column[i] = static_cast<float>(npy_value(array, field, i));
      table.columns.push_back({field.name, std::move(column)});
    }
    return table;
  }
  if (array.shape.size() != 2 || array.shape[1] != names.size()) {
    refuse(path, "the shape is not [rows][" + std::to_string(names.size()) + "], one column for each of --columns");
  }
  for (size_t c = 0; c < names.size(); ++c) {
    std::vector<float> column(array.shape[0]);
    for (size_t i = 0; i < column.size(); ++i) {
      column[i] = static_cast<float>(npy_value(array, array.fields.front(), i * names.size() + c));
    }
    table.columns.push_back({names[c], std::move(column)});
  }
  return table;
}
