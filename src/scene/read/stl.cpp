// SPDX-License-Identifier: MIT
// STL (3D Systems, "StereoLithography Interface Specification", 1989), text and binary, with the colours that VisCAM
// and Materialise Magics store in the attribute bytes of binary facets. assimp 5.2 takes VisCAM's colours for Magics'
// and the reverse.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "scene/read/colors.h"
#include "scene/read/polygon.h"
#include "scene/read/positions.h"
#include "scene/read/read.h"
#include "scene/read/text_lines.h"
#include "scene/read/warnings.h"
#include "scene/text.h"

namespace shd::scene {
namespace {

constexpr size_t kHeaderSize = 84, kFacetSize = 50;
constexpr float kGrey = 0.6f;

/// One solid: each facet has its own vertices.
struct Solid {
  std::string name;
  std::vector<double> positions;
  std::vector<float> normals, colors;  // by vertex
};

struct StlRead {
  const Source& source;
  Model& model;
  Warnings& warnings;
  uint64_t triangles = 0;
};

uint32_t u32_at(const unsigned char* p) {
  return static_cast<uint32_t>(p[0]) | static_cast<uint32_t>(p[1]) << 8 | static_cast<uint32_t>(p[2]) << 16 |
         static_cast<uint32_t>(p[3]) << 24;
}

float float_at(const unsigned char* p) {
  const uint32_t bits = u32_at(p);
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// Appends a triangle. Returns false if a position is not finite.
bool append_facet(StlRead& read, const Point corners[3], const float normal[3], Solid& solid) {
  for (size_t i = 0; i < 3; ++i) {
    for (const double c : corners[i]) {
      if (!(std::fabs(c) < 1e37)) return false;
    }
  }
  check_limit("triangles", ++read.triangles, "max_triangles", read.source.limits.triangles);
  check_limit("vertices", 3 * read.triangles, "max_vertices", read.source.limits.vertices);
  const bool good = std::isfinite(normal[0]) && std::isfinite(normal[1]) && std::isfinite(normal[2]) &&
                    (normal[0] != 0 || normal[1] != 0 || normal[2] != 0);
  if (!good) read.warnings.add("normals of length 0 or not finite: those of the facets are used");
  for (size_t i = 0; i < 3; ++i) {
    solid.positions.insert(solid.positions.end(), corners[i].begin(), corners[i].end());
    for (size_t c = 0; c < 3; ++c) solid.normals.push_back(good ? normal[c] : 0.0f);
  }
  return true;
}

void warn_of_bad(StlRead& read, const Solid& solid, uint64_t bad) {
  if (bad == 0) return;
  read.warnings.add("mesh \"" + text_of(solid.name) + "\": " + std::to_string(bad) +
                    " faces with positions that are not finite");
}

void add_solid(StlRead& read, Solid&& solid) {
  if (solid.positions.empty()) {
    read.warnings.add("mesh \"" + text_of(solid.name) + "\": it has no triangles");
    return;
  }
  Geometry geometry;
  geometry.name = text_of(solid.name);
  for (uint32_t i = 0; i < solid.positions.size() / 3; ++i) geometry.indices.push_back(i);
  set_positions(geometry, solid.positions);
  geometry.normal = std::move(solid.normals);
  geometry.color = std::move(solid.colors);
  Placement placement;
  placement.geometry = static_cast<uint32_t>(read.model.geometries.size());
  read.model.geometries.push_back(std::move(geometry));
  read.model.placements.push_back(std::move(placement));
  check_limit("instances", read.model.placements.size(), "max_instances", read.source.limits.instances);
}

/// Colours of a binary file.
struct StlColors {
  bool magics = false;   // the header has COLOR=, and bit 15 of a facet means that it has no colour of its own
  bool present = false;  // some facet or the header has a colour
  unsigned char rgba[4] = {0, 0, 0, 255};
};

/// Position of a word in the header, or null.
const unsigned char* find_in_header(const Bytes& bytes, const char* word) {
  const size_t size = std::strlen(word);
  for (size_t i = 0; i + size <= 80; ++i) {
    if (std::memcmp(bytes.data + i, word, size) == 0) return bytes.data + i + size;
  }
  return nullptr;
}

uint32_t attribute_at(const Bytes& bytes, size_t facet) {
  const unsigned char* const p = bytes.data + kHeaderSize + kFacetSize * facet + 48;
  return static_cast<uint32_t>(p[0] | p[1] << 8);
}

StlColors colors_of(const Bytes& bytes, size_t facets) {
  StlColors colors;
  const unsigned char* const rgba = find_in_header(bytes, "COLOR=");
  if (rgba && rgba + 4 <= bytes.data + 80) {
    colors.magics = colors.present = true;
    std::memcpy(colors.rgba, rgba, 4);
  }
  for (size_t i = 0; i < facets && !colors.present; ++i) colors.present = (attribute_at(bytes, i) & 0x8000) != 0;
  return colors;
}

/// Appends the linear colour of a facet for its three vertices. Five bits a channel: Magics begins with red, VisCAM
/// with blue.
void append_facet_color(const StlColors& colors, uint32_t attribute, std::vector<float>& out) {
  float rgb[3] = {kGrey, kGrey, kGrey};
  const bool own = ((attribute & 0x8000) != 0) != colors.magics;
  for (uint32_t c = 0; c < 3; ++c) {
    const uint32_t shift = colors.magics ? 5 * c : 10 - 5 * c;
    if (own) rgb[c] = linear_of_srgb(static_cast<float>(attribute >> shift & 31) / 31.0f);
    if (!own && colors.magics) rgb[c] = linear_of_srgb(static_cast<float>(colors.rgba[c]) / 255.0f);
  }
  for (int i = 0; i < 3; ++i) out.insert(out.end(), {rgb[0], rgb[1], rgb[2], 1.0f});
}

/// Number of facets by the header.
size_t facets_of(const Bytes& bytes) {
  return bytes.size < kHeaderSize ? 0 : u32_at(bytes.data + 80);
}

/// Number of facets in the file. Some programs do not come back to write it into the header, or write more behind.
size_t count_facets(StlRead& read) {
  const size_t given = facets_of(read.source.bytes), room = (read.source.bytes.size - kHeaderSize) / kFacetSize;
  const bool open = given == 0 || given == UINT32_MAX;
  if (!open && given > room) {
    core::refuse(SHD_ERROR_CORRUPT, "STL: the file ends in facet %zu of %zu", room, given);
  }
  const size_t facets = open ? room : given;
  if (open && facets > 0) {
    read.warnings.add("STL: the header has no number of facets; " + std::to_string(facets) + " fit into the file");
  } else if (const size_t rest = read.source.bytes.size - kHeaderSize - kFacetSize * facets) {
    read.warnings.add("STL: " + std::to_string(rest) + " bytes behind the last facet are left out");
  }
  return facets;
}

void read_binary(StlRead& read, Surface& surface) {
  const Bytes& bytes = read.source.bytes;
  const size_t facets = count_facets(read);
  check_limit("triangles", facets, "max_triangles", read.source.limits.triangles);
  const StlColors colors = colors_of(bytes, facets);
  if (find_in_header(bytes, "MATERIAL=")) read.warnings.add("STL: MATERIAL of the header is left out");
  if (colors.magics && colors.rgba[3] > 0 && colors.rgba[3] < 255) {
    surface.opacity = static_cast<float>(colors.rgba[3]) / 255.0f;
    surface.alpha = Alpha::kBlend;
  }
  Solid solid;
  uint64_t bad = 0;
  for (size_t i = 0; i < facets; ++i) {
    if (i % 65536 == 0) read.source.deadline.check();
    const unsigned char* const p = bytes.data + kHeaderSize + kFacetSize * i;
    const float normal[3] = {float_at(p), float_at(p + 4), float_at(p + 8)};
    Point corners[3];
    for (size_t k = 0; k < 9; ++k) corners[k / 3][k % 3] = static_cast<double>(float_at(p + 12 + 4 * k));
    if (!append_facet(read, corners, normal, solid)) {
      ++bad;
    } else if (colors.present) {
      append_facet_color(colors, attribute_at(bytes, i), solid.colors);
    }
  }
  warn_of_bad(read, solid, bad);
  add_solid(read, std::move(solid));
}

/// State of a text file.
struct TextStl {
  Solid solid;
  float normal[3] = {0, 0, 0};
  std::vector<Point> loop;
  uint64_t bad = 0;
  bool open = false;  // between solid and endsolid
};

void end_loop(StlRead& read, TextStl& state) {
  if (!state.loop.empty() && state.loop.size() < 3) {
    read.warnings.add("STL: loops of fewer than 3 vertices are left out");
  }
  if (state.loop.size() >= 3) {
    std::vector<std::array<uint32_t, 3>> triangles;
    triangulate(state.loop, read.source.deadline, triangles);
    bool good = true;
    for (const auto& triangle : triangles) {
      const Point corners[3] = {state.loop[triangle[0]], state.loop[triangle[1]], state.loop[triangle[2]]};
      good = append_facet(read, corners, state.normal, state.solid) && good;
    }
    if (!good) ++state.bad;
  }
  state.loop.clear();
}

void end_solid(StlRead& read, TextStl& state) {
  end_loop(read, state);
  warn_of_bad(read, state.solid, state.bad);
  if (state.open || !state.solid.positions.empty()) add_solid(read, std::move(state.solid));
  state = TextStl();
}

/// Reads one word and what belongs to it. Returns false if it is not understood.
bool parse_text_word(StlRead& read, std::string_view* rest, TextStl& state) {
  const std::string word = lower_case(take_word(rest));
  if (word == "vertex") {
    Point p;
    for (double& c : p) {
      if (!take_number(rest, &c)) return false;
    }
    check_limit("vertices", state.loop.size(), "max_vertices", read.source.limits.vertices);
    state.loop.push_back(p);
  } else if (word == "normal") {
    double numbers[3];
    for (double& c : numbers) {
      if (!take_number(rest, &c)) return false;
    }
    for (size_t c = 0; c < 3; ++c) state.normal[c] = static_cast<float>(numbers[c]);
  } else if (word == "endloop") {
    end_loop(read, state);
  } else if (word == "solid") {
    end_solid(read, state);
    state.solid.name = std::string(*rest);
    state.open = true;
    *rest = {};
  } else if (word == "endsolid") {
    end_solid(read, state);
    *rest = {};
  } else if (word == "facet") {
    for (float& c : state.normal) c = 0;  // a facet may have none
  } else {
    return word == "outer" || word == "loop" || word == "endfacet";
  }
  return true;
}

void read_text_stl(StlRead& read) {
  const std::string text = utf8_of(read.source.bytes);
  TextLines lines(text);
  TextStl state;
  std::string_view rest;
  for (uint64_t i = 0; lines.next(&rest); ++i) {
    if (i % 4096 == 0) read.source.deadline.check();
    while (!rest.empty()) {
      if (parse_text_word(read, &rest, state)) continue;
      read.warnings.add("STL: line " + std::to_string(lines.line()) + " is not understood");
      break;
    }
  }
  end_solid(read, state);
}

/// Whether the number of facets in the header gives the size of the file.
bool has_binary_size(const Bytes& bytes) {
  return bytes.size >= kHeaderSize && bytes.size - kHeaderSize == uint64_t{kFacetSize} * facets_of(bytes);
}

bool is_text(const Bytes& bytes) {
  const std::string text = utf8_of(bytes, 4096);
  TextLines lines(text);
  std::string_view statement;
  if (!lines.next(&statement) || lower_case(take_word(&statement)) != "solid") return false;
  bool only = true;
  for (; lines.next(&statement); only = false) {
    const std::string word = lower_case(take_word(&statement));
    if (word == "facet" || word == "endsolid" || word == "solid") return true;
  }
  return only && text.find("facet") != std::string::npos;  // all in one line
}

bool is_binary(const Source& source) {
  constexpr std::string_view kSuffix = ".stl";
  if (has_binary_size(source.bytes)) return true;
  const std::string end = source.name.substr(source.name.size() - std::min(source.name.size(), kSuffix.size()));
  return source.bytes.size > kHeaderSize + kFacetSize && lower_case(end) == kSuffix && !is_text(source.bytes);
}

}  // namespace

bool is_stl(const Source& source) {
  return is_binary(source) || is_text(source.bytes);
}

Model read_stl(const Source& source) {
  Model model;
  Warnings warnings(model);
  StlRead read{source, model, warnings, 0};
  Surface surface;
  surface.name = "default";
  if (is_binary(source)) {
    read_binary(read, surface);
  } else {
    read_text_stl(read);
  }
  if (model.geometries.empty()) refuse_empty(model);
  const bool has_colors = !model.geometries[0].color.empty();
  for (float& c : surface.diffuse) c = has_colors ? 1.0f : kGrey;
  model.surfaces.push_back(surface);
  Node root;
  root.name = text_of(source.name);
  model.nodes.push_back(std::move(root));
  return model;
}

}  // namespace shd::scene
