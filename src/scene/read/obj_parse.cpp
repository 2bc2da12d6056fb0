// SPDX-License-Identifier: MIT
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "core/number.h"
#include "scene/read/obj.h"
#include "scene/read/text_lines.h"
#include "scene/text.h"

namespace shd::scene {
namespace {

constexpr float kNoColor = std::numeric_limits<float>::quiet_NaN();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr uint64_t kStatementsPerCheck = 4096;
constexpr size_t kMaxOddNames = 32;  // unknown statements that warnings name

/// State of one pass over the statements.
struct Parser {
  const Limits& limits;
  Warnings& warnings;
  ObjFile file;
  std::string name;  // name of the object or group
  int32_t material = kNone;
  uint32_t group = kNoStatement;
  int32_t part = kNone;                                        // kNone = changed since the last face
  std::map<std::pair<std::string, int32_t>, int32_t> part_of;  // by name and material
  std::map<std::string, int32_t, std::less<>> material_of;
  std::map<std::string, uint64_t, std::less<>> left_out;  // statements that are not drawn
  uint64_t triangles = 0, odd_lines = 0, bad_faces = 0;
  uint64_t bad_columns = 0;  // texture coordinates and normals of corners that do not exist
  std::string first_odd, first_bad_part;
};

/// v x y z [w], or v x y z r g b [a]. A line that is none of them still counts as a vertex.
bool parse_position(Parser& parser, std::string_view rest) {
  double numbers[8];
  size_t count = 0;
  while (count < 8 && take_number(&rest, &numbers[count])) ++count;
  const bool good = rest.empty() && (count == 3 || count == 4 || count == 6 || count == 7);
  ObjFile& file = parser.file;
  for (size_t c = 0; c < 3; ++c) file.positions.push_back(good ? numbers[c] : kNan);
  check_limit("vertices", file.positions.size() / 3, "max_vertices", parser.limits.vertices);
  if (good && count >= 6) {
    file.colors.resize(file.positions.size() - 3, kNoColor);
    for (size_t c = 3; c < 6; ++c) file.colors.push_back(static_cast<float>(numbers[c]));
  } else if (!file.colors.empty()) {
    file.colors.resize(file.positions.size(), kNoColor);
  }
  if (good && count == 7 && numbers[6] != 1 && numbers[6] != 255) {
    parser.warnings.add("alpha of the colours of vertices is left out");
  }
  return good;
}

/// Numbers of which the last `optional` ones default to 0. Numbers behind `size` are those of further dimensions. False
/// if one is missing, or is not finite.
bool parse_numbers(std::string_view rest, size_t size, size_t optional, std::vector<float>& out) {
  size_t count = 0;
  double number = 0;
  bool finite = true;
  while (take_number(&rest, &number)) {
    finite = finite && std::isfinite(static_cast<float>(number));
    if (count++ < size) out.push_back(static_cast<float>(number));
  }
  const bool good = rest.empty() && count + optional >= size && finite;
  for (; count < size; ++count) out.push_back(0);
  return good;
}

/// An index of the file, from 1, or from -1 downwards for the last rows, as a row. False if it is no number; the row is
/// kNone if there is none.
bool parse_index(std::string_view* text, size_t size, int32_t* row) {
  int64_t index = 0;
  if (!text->empty() && text->front() == '+') text->remove_prefix(1);
  const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), index);
  if (error == std::errc::invalid_argument) return false;
  if (error != std::errc()) index = 0;  // beyond 64 bits
  text->remove_prefix(static_cast<size_t>(end - text->data()));
  const int64_t at = index < 0 ? static_cast<int64_t>(size) + index : index - 1;
  *row = at >= 0 && at < static_cast<int64_t>(size) ? static_cast<int32_t>(at) : kNone;
  return true;
}

enum class Parse { kGood, kMissing, kOdd };

/// v, v/vt, v//vn or v/vt/vn. A texture coordinate or normal that does not exist leaves the corner without one.
Parse parse_corner(Parser& parser, std::string_view word, ObjCorner* corner) {
  const ObjFile& file = parser.file;
  const size_t sizes[3] = {file.positions.size() / 3, file.uvs.size() / 2, file.normals.size() / 3};
  int32_t* const rows[3] = {&corner->position, &corner->uv, &corner->normal};
  for (size_t i = 0; i < 3; ++i) {
    const bool absent = i > 0 && (word.empty() || word.front() == '/');
    if (!absent) {
      if (!parse_index(&word, sizes[i], rows[i])) return Parse::kOdd;
      if (i > 0 && *rows[i] == kNone) ++parser.bad_columns;
    }
    if (word.empty()) break;
    if (word.front() != '/' || i == 2) return Parse::kOdd;
    word.remove_prefix(1);
  }
  return corner->position == kNone ? Parse::kMissing : Parse::kGood;
}

int32_t part_of(Parser& parser) {
  const auto next = static_cast<int32_t>(parser.file.parts.size());
  const auto [at, is_new] = parser.part_of.try_emplace({parser.name, parser.material}, next);
  if (is_new) parser.file.parts.push_back({parser.name, parser.material});
  return at->second;
}

bool parse_face(Parser& parser, std::string_view rest) {
  ObjFile& file = parser.file;
  ObjFace face;
  face.first = file.corners.size();
  bool missing = false;
  while (!rest.empty()) {
    ObjCorner corner;
    const Parse parsed = parse_corner(parser, take_word(&rest), &corner);
    if (parsed == Parse::kOdd) {
      file.corners.resize(face.first);
      return false;
    }
    missing = missing || parsed == Parse::kMissing;
    file.corners.push_back(corner);
  }
  face.count = static_cast<uint32_t>(file.corners.size() - face.first);
  if (face.count < 3 || missing) {
    file.corners.resize(face.first);
    if (missing && parser.bad_faces++ == 0) parser.first_bad_part = parser.name;
    return missing;
  }
  parser.triangles += face.count - 2;
  check_limit("triangles", parser.triangles, "max_triangles", parser.limits.triangles);
  if (parser.part == kNone) parser.part = part_of(parser);
  face.part = static_cast<uint32_t>(parser.part);
  face.group = parser.group;
  file.faces.push_back(face);
  return true;
}

bool parse_group(Parser& parser, std::string_view rest) {
  double number = 0;
  if (rest == "off" || rest == "null") {
    parser.group = kNoGroup;
  } else if (rest == "on") {
    parser.group = 1;
  } else if (core::to_number(rest, &number) && number >= 0 && number < 4e9) {
    parser.group = static_cast<uint32_t>(number);
  } else {
    return false;
  }
  return true;
}

bool set_part(Parser& parser, std::string_view name, int32_t material) {
  parser.name = std::string(name);
  parser.material = material;
  parser.part = kNone;
  return true;
}

bool use_material(Parser& parser, std::string_view name) {
  const auto next = static_cast<int32_t>(parser.file.material_names.size());
  const auto [at, is_new] = parser.material_of.try_emplace(std::string(name), next);
  if (is_new) parser.file.material_names.emplace_back(name);
  return set_part(parser, std::string(parser.name), at->second);
}

/// Counts a statement that is not drawn. Files of another kind have any number of words.
bool leave_out(Parser& parser, std::string_view word) {
  auto at = parser.left_out.find(word);
  if (at == parser.left_out.end()) {
    const bool is_full = parser.left_out.size() >= kMaxOddNames;
    at = parser.left_out.emplace(is_full ? "others" : std::string(word), 0).first;
  }
  ++at->second;
  return true;
}

/// Reads a statement. False if it is not understood.
bool parse_statement(Parser& parser, std::string_view statement) {
  std::string_view rest = statement;
  const std::string_view word = take_word(&rest);
  const std::string_view values = without_comment(rest);
  if (word == "v") return parse_position(parser, values);
  if (word == "vt") return parse_numbers(values, 2, 1, parser.file.uvs);
  if (word == "vn") return parse_numbers(values, 3, 0, parser.file.normals);
  if (word == "f" || word == "fo") return parse_face(parser, values);
  if (word == "s") return parse_group(parser, values);
  if (word == "o" || word == "g") return set_part(parser, rest, parser.material);
  if (word == "usemtl") return use_material(parser, rest);
  if (word == "mtllib") {
    parser.file.libraries.emplace_back(rest);
    return true;
  }
  return leave_out(parser, word);
}

void add_warnings(Parser& parser) {
  for (const auto& [word, count] : parser.left_out) {
    const std::string times = std::to_string(count) + (count == 1 ? " statement \"" : " statements \"");
    const char* const what = word == "l" ? "lines are left out" : word == "p" ? "points are left out" : "left out";
    parser.warnings.add(times + text_of(word) + "\": " + what);
  }
  if (parser.odd_lines) {
    std::string text = parser.first_odd;
    if (parser.odd_lines > 1) text += ", and " + std::to_string(parser.odd_lines - 1) + " further ones";
    parser.warnings.add(text);
  }
  if (parser.bad_faces) {
    parser.warnings.add("mesh \"" + text_of(parser.first_bad_part) + "\": " + std::to_string(parser.bad_faces) +
                        " faces with indices out of range");
  }
  if (parser.bad_columns) {
    parser.warnings.add("texture coordinates or normals with indices out of range at " +
                        std::to_string(parser.bad_columns) + " corners of faces");
  }
}

}  // namespace

ObjFile parse_obj(const Source& source, const std::string& text, Warnings& warnings) {
  Parser parser{source.limits, warnings, {}, {}, kNone, kNoStatement, kNone, {}, {}, {}, 0, 0, 0, 0, {}, {}};
  TextLines lines(text);
  std::string_view statement;
  for (uint64_t i = 0; lines.next(&statement); ++i) {
    if (i % kStatementsPerCheck == 0) source.deadline.check();
    if (parse_statement(parser, statement)) continue;
    if (parser.odd_lines++ == 0) {
      const std::string shown(statement.substr(0, 60));
      parser.first_odd = "line " + std::to_string(lines.line()) + ": \"" + text_of(shown) + "\" is not understood";
    }
  }
  add_warnings(parser);
  return std::move(parser.file);
}

}  // namespace shd::scene
