// SPDX-License-Identifier: MIT
// The header of a PLY file, and its rows: text, and binary of both byte orders.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "scene/read/ply.h"
#include "scene/read/text_lines.h"
#include "scene/text.h"

namespace shd::scene {
namespace ply {
namespace {

struct TypeRow {
  std::string_view name, other_name;
  PlyType type;
  size_t size;   // bytes
  double scale;  // greatest integer
};

constexpr TypeRow kTypes[] = {
    {"char", "int8", PlyType::kInt8, 1, 127},         {"uchar", "uint8", PlyType::kUint8, 1, 255},
    {"short", "int16", PlyType::kInt16, 2, 32767},    {"ushort", "uint16", PlyType::kUint16, 2, 65535},
    {"int", "int32", PlyType::kInt32, 4, 2147483647}, {"uint", "uint32", PlyType::kUint32, 4, 4294967295},
    {"float", "float32", PlyType::kFloat, 4, 1},      {"double", "float64", PlyType::kDouble, 8, 1},
};

const TypeRow& row_of(PlyType type) {
  return kTypes[static_cast<size_t>(type)];
}

PlyType type_of(std::string_view word) {
  for (const TypeRow& row : kTypes) {
    if (word == row.name || word == row.other_name) return row.type;
  }
  core::refuse(SHD_ERROR_CORRUPT, "PLY: \"%s\" is no type", text_of(std::string(word)).c_str());
}

[[noreturn]] void refuse_rows(const PlyElement& element, uint64_t row, const char* what) {
  core::refuse(SHD_ERROR_CORRUPT, "PLY: row %llu of element \"%s\": %s", static_cast<unsigned long long>(row),
               text_of(element.name).c_str(), what);
}

void add_element(std::string_view rest, PlyFile& file) {
  PlyElement element;
  element.name = std::string(take_word(&rest));
  double count = 0;
  if (!take_number(&rest, &count) || !(count >= 0 && count < 0x1p32 - 1) || count != std::floor(count)) {
    core::refuse(SHD_ERROR_CORRUPT, "PLY: element \"%s\" has no count", text_of(element.name).c_str());
  }
  element.count = static_cast<uint64_t>(count);
  file.elements.push_back(std::move(element));
}

void add_property(std::string_view rest, PlyFile& file) {
  if (file.elements.empty()) core::refuse(SHD_ERROR_CORRUPT, "PLY: a property before the first element");
  PlyProperty property;
  std::string_view word = take_word(&rest);
  property.list = word == "list";
  if (property.list) {
    property.count_type = type_of(take_word(&rest));
    word = take_word(&rest);
  }
  property.type = type_of(word);
  property.name = std::string(rest);
  file.elements.back().properties.push_back(std::move(property));
}

void set_format(std::string_view rest, PlyFile& file) {
  const std::string_view word = take_word(&rest);
  if (word == "binary_little_endian") {
    file.format = PlyFile::Format::kLittleEndian;
  } else if (word == "binary_big_endian") {
    file.format = PlyFile::Format::kBigEndian;
  } else if (word != "ascii") {
    core::refuse(SHD_ERROR_UNSUPPORTED, "PLY: format \"%s\", not ascii, binary_little_endian or binary_big_endian",
                 text_of(std::string(word)).c_str());
  }
}

/// Place behind the line end_header, or 0.
size_t end_of_header(const Bytes& bytes) {
  constexpr std::string_view kEnd = "end_header";
  const std::string_view text(reinterpret_cast<const char*>(bytes.data), bytes.size);
  for (size_t at = text.find(kEnd); at != std::string_view::npos; at = text.find(kEnd, at + 1)) {
    size_t end = at + kEnd.size();
    if (at == 0 || (text[at - 1] != '\n' && text[at - 1] != '\r')) continue;
    while (end < text.size() && (text[end] == ' ' || text[end] == '\t')) ++end;
    if (end == text.size()) return end;
    if (text[end] != '\n' && text[end] != '\r') continue;
    return text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n' ? end + 2 : end + 1;
  }
  return 0;
}

/// Values of a text: a row is a line.
class TextRows {
 public:
  explicit TextRows(const std::string& text) : lines_(text, false) {}
  bool begin() {
    while (lines_.next(&rest_)) {
      if (rest_ != "comment" && rest_.substr(0, 8) != "comment ") return true;
    }
    return false;
  }
  bool take(PlyType, double* out) { return take_number(&rest_, out); }
  bool has(uint64_t count, PlyType) const { return count <= rest_.size(); }
  bool end() const { return rest_.empty(); }

 private:
  TextLines lines_;
  std::string_view rest_;
};

/// Values of a binary file.
class BinaryRows {
 public:
  BinaryRows(const unsigned char* data, size_t size, bool big) : data_(data), left_(size), big_(big) {}
  bool begin() const { return true; }
  bool take(PlyType type, double* out) {
    const size_t size = row_of(type).size;
    if (size > left_) return false;
    uint64_t bits = 0;
    for (size_t i = 0; i < size; ++i) bits |= uint64_t{data_[big_ ? size - 1 - i : i]} << 8 * i;
    *out = value_of(type, bits);
    data_ += size;
    left_ -= size;
    return true;
  }
  bool has(uint64_t count, PlyType type) const { return count <= left_ / row_of(type).size; }
  bool end() const { return true; }

 private:
  template <class From, class To>
  static double copy_bits(From from) {
    To to;
    static_assert(sizeof to == sizeof from, "one size");
    std::memcpy(&to, &from, sizeof to);
    return static_cast<double>(to);
  }
  static double value_of(PlyType type, uint64_t bits) {
    switch (type) {
      case PlyType::kInt8: return copy_bits<uint8_t, int8_t>(static_cast<uint8_t>(bits));
      case PlyType::kInt16: return copy_bits<uint16_t, int16_t>(static_cast<uint16_t>(bits));
      case PlyType::kInt32: return copy_bits<uint32_t, int32_t>(static_cast<uint32_t>(bits));
      case PlyType::kFloat: return copy_bits<uint32_t, float>(static_cast<uint32_t>(bits));
      case PlyType::kDouble: return copy_bits<uint64_t, double>(bits);
      case PlyType::kUint8:
      case PlyType::kUint16:
      case PlyType::kUint32: break;
    }
    return static_cast<double>(bits);
  }

  const unsigned char* data_;
  size_t left_;
  bool big_;
};

template <class Rows>
void read_row(const PlyElement& element, uint64_t row, Rows& rows, std::vector<PlyProperty>& properties) {
  for (PlyProperty& property : properties) {
    double number = 0;
    uint64_t count = 1;
    if (property.list) {
      if (!rows.take(property.count_type, &number)) refuse_rows(element, row, "a list without a length");
      if (!(number >= 0 && number <= 0x1p53) || !rows.has(static_cast<uint64_t>(number), property.type)) {
        refuse_rows(element, row, "a list is longer than the file");
      }
      count = static_cast<uint64_t>(number);
    }
    for (uint64_t i = 0; i < count; ++i) {
      if (!rows.take(property.type, &number)) refuse_rows(element, row, "too few numbers");
      if (property.wanted) property.values.push_back(number);
    }
    if (property.list && property.wanted) property.ends.push_back(property.values.size());
  }
}

template <class Rows>
void read_rows(const Source& source, Rows rows, PlyFile& file, Warnings& warnings) {
  for (PlyElement& element : file.elements) {
    if (element.properties.empty()) continue;
    for (uint64_t row = 0; row < element.count; ++row) {
      if (row % 4096 == 0) source.deadline.check();
      if (!rows.begin()) refuse_rows(element, row, "the file ends before it");
      read_row(element, row, rows, element.properties);
      if (!rows.end()) warnings.add("PLY: rows of element \"" + text_of(element.name) + "\" have further numbers");
    }
  }
}

}  // namespace
}  // namespace ply

PlyProperty* PlyElement::want(std::initializer_list<std::string_view> names, bool list) {
  for (PlyProperty& property : properties) {
    if (property.list != list || std::find(names.begin(), names.end(), property.name) == names.end()) continue;
    property.wanted = true;
    return &property;
  }
  return nullptr;
}

PlyElement* PlyFile::element(std::string_view name) {
  const auto has_name = [name](const PlyElement& element) { return element.name == name; };
  const auto at = std::find_if(elements.begin(), elements.end(), has_name);
  return at == elements.end() ? nullptr : &*at;
}

double ply_scale(PlyType type) {
  return ply::row_of(type).scale;
}

PlyFile parse_ply_header(const Source& source) {
  PlyFile file;
  file.data = ply::end_of_header(source.bytes);
  if (file.data == 0) core::refuse(SHD_ERROR_CORRUPT, "PLY: the header has no end");
  const std::string text = utf8_of(source.bytes, file.data);
  TextLines lines(text, false);
  std::string_view rest;
  while (lines.next(&rest)) {
    const std::string_view word = take_word(&rest);
    if (word == "format") ply::set_format(rest, file);
    if (word == "element") ply::add_element(rest, file);
    if (word == "property") ply::add_property(rest, file);
    if (word == "comment" && take_word(&rest) == "TextureFile" && !rest.empty()) file.textures.emplace_back(rest);
  }
  return file;
}

void read_ply_rows(const Source& source, PlyFile& file, Warnings& warnings) {
  const unsigned char* const data = source.bytes.data + file.data;
  const size_t size = source.bytes.size - file.data;
  if (file.format == PlyFile::Format::kText) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    ply::read_rows(source, ply::TextRows(text), file, warnings);
  } else {
    ply::read_rows(source, ply::BinaryRows(data, size, file.format == PlyFile::Format::kBigEndian), file, warnings);
  }
}

}  // namespace shd::scene
