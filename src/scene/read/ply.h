// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "scene/read/read.h"
#include "scene/read/warnings.h"

/// Declarations that the ply*.cpp files share. The format: Turk, "The PLY Polygon File Format", 1994. The names of
/// colours, texture coordinates and textures are those of later programs.
namespace shd::scene {

enum class PlyType : uint8_t { kInt8, kUint8, kInt16, kUint16, kInt32, kUint32, kFloat, kDouble };

/// A property of an element, as a column: one value a row, or a list a row.
struct PlyProperty {
  std::string name;
  PlyType type = PlyType::kFloat, count_type = PlyType::kUint8;
  bool list = false;
  bool wanted = false;         // otherwise values and ends stay empty
  std::vector<double> values;  // one row after another
  std::vector<uint64_t> ends;  // list: end of each row's values
};

struct PlyElement {
  std::string name;
  uint64_t count = 0;  // rows
  std::vector<PlyProperty> properties;

  /// The first property that has one of the names and is a list or not, marked as wanted; null if there is none.
  PlyProperty* want(std::initializer_list<std::string_view> names, bool list = false);
};

struct PlyFile {
  enum class Format { kText, kLittleEndian, kBigEndian };
  Format format = Format::kText;
  size_t data = 0;  // place of the first row in the file
  std::vector<PlyElement> elements;
  std::vector<std::string> textures;  // names of the comments TextureFile

  PlyElement* element(std::string_view name);
};

PlyFile parse_ply_header(const Source& source);

/// Reads the wanted properties of all elements.
void read_ply_rows(const Source& source, PlyFile& file, Warnings& warnings);

/// The greatest value of an integer; 1 for numbers with a fraction.
double ply_scale(PlyType type);

}  // namespace shd::scene
