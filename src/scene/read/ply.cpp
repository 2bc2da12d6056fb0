// SPDX-License-Identifier: MIT
// PLY to a Model: polygons and strips, colours of vertices and faces, textures.
#include "scene/read/ply.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "scene/read/colors.h"
#include "scene/read/creases.h"
#include "scene/read/join.h"
#include "scene/read/polygon.h"
#include "scene/read/positions.h"
#include "scene/read/text_lines.h"
#include "scene/text.h"

namespace shd::scene {
namespace ply {
namespace {

constexpr uint32_t kNoRow = ~0u;
constexpr uint64_t kNoUv = ~uint64_t{0};

/// Properties that count together; all are null if the file lacks one.
template <size_t N>
using Group = std::array<const PlyProperty*, N>;

struct Colors {
  Group<3> rgb = {};
  const PlyProperty* alpha = nullptr;  // null = opaque
  double one = 1;                      // value of full light
  bool present() const { return rgb[0] != nullptr; }
};

/// The properties to read; null if the file has not.
struct Wanted {
  uint64_t vertex_count = 0;
  Group<3> position = {}, normal = {};
  Group<2> uv = {};
  const PlyProperty *polygons = nullptr, *strips = nullptr;
  const PlyProperty* corner_uvs = nullptr;       // [face][corner][2]
  const PlyProperty* texture_numbers = nullptr;  // [face]
  Colors vertex_colors, face_colors;

  bool has_normals() const { return normal[0] != nullptr; }
};

/// A corner of a triangle; also a vertex of the Model.
struct Corner {
  uint32_t vertex = 0, face = kNoRow;
  uint64_t uv = 0;  // place of u in the values of corner_uvs, or kNoUv
};

/// The triangles that have one texture.
struct Part {
  std::vector<Corner> corners;
};

struct Build {
  const Source& source;
  const Wanted& wanted;
  Warnings& warnings;
  std::vector<Part> parts;  // one for each texture with a number, and one without a texture
  uint64_t triangles = 0, bad = 0;
};

/// The properties by any of their names. If one is missing, the others are left out, with a warning.
template <size_t N>
Group<N> want_group(PlyElement& element, const std::array<std::initializer_list<std::string_view>, N>& names) {
  std::array<PlyProperty*, N> found;
  for (size_t i = 0; i < N; ++i) found[i] = element.want(names[i]);
  const bool complete = std::find(found.begin(), found.end(), nullptr) == found.end();
  Group<N> out = {};
  for (size_t i = 0; i < N; ++i) {
    if (complete) out[i] = found[i];
    if (!complete && found[i]) found[i]->wanted = false;
  }
  return out;
}

Colors want_colors(PlyElement& element) {
  Colors colors;
  colors.rgb = want_group<3>(
      element, {{{"red", "diffuse_red", "r"}, {"green", "diffuse_green", "g"}, {"blue", "diffuse_blue", "b"}}});
  if (colors.present()) colors.alpha = element.want({"alpha", "diffuse_alpha", "a"});
  return colors;
}

/// Chooses the properties to read, and warns of all others.
Wanted want_properties(PlyFile& file, Warnings& warnings) {
  Wanted wanted;
  if (PlyElement* const vertices = file.element("vertex")) {
    wanted.vertex_count = vertices->count;
    wanted.position = want_group<3>(*vertices, {{{"x"}, {"y"}, {"z"}}});
    wanted.normal = want_group<3>(*vertices, {{{"nx"}, {"ny"}, {"nz"}}});
    wanted.uv = want_group<2>(*vertices, {{{"s", "u", "texture_u"}, {"t", "v", "texture_v"}}});
    wanted.vertex_colors = want_colors(*vertices);
  }
  if (PlyElement* const faces = file.element("face")) {
    wanted.polygons = faces->want({"vertex_indices", "vertex_index"}, true);
    wanted.corner_uvs = faces->want({"texcoord"}, true);
    wanted.texture_numbers = faces->want({"texnumber"});
    if (!wanted.vertex_colors.present()) wanted.face_colors = want_colors(*faces);
  }
  if (PlyElement* const strips = file.element("tristrips")) {
    wanted.strips = strips->want({"vertex_indices", "vertex_index"}, true);
  }
  for (const PlyElement& element : file.elements) {
    const auto is_wanted = [](const PlyProperty& property) { return property.wanted; };
    const std::string name = "\"" + text_of(element.name) + "\"";
    if (element.count == 0) continue;
    if (std::none_of(element.properties.begin(), element.properties.end(), is_wanted)) {
      warnings.add("PLY: element " + name + " is left out");
      continue;
    }
    for (const PlyProperty& property : element.properties) {
      if (!property.wanted)
        warnings.add("PLY: property \"" + text_of(property.name) + "\" of element " + name + " is left out");
    }
  }
  return wanted;
}

/// Sets the value of full light: the largest one of the type. Some programs write codes of 8 bits as wider numbers.
void find_scale(Colors& colors) {
  if (!colors.present()) return;
  const PlyType type = colors.rgb[0]->type;
  double most = 0;
  for (const PlyProperty* const channel : {colors.rgb[0], colors.rgb[1], colors.rgb[2]}) {
    for (const double value : channel->values) most = std::max(most, value);
  }
  colors.one = ply_scale(type);
  const bool codes = colors.one == 1 ? most > 1 : most <= 255;
  if (codes) colors.one = 255;
}

Point position_of(const Wanted& wanted, uint32_t vertex) {
  return {wanted.position[0]->values[vertex], wanted.position[1]->values[vertex], wanted.position[2]->values[vertex]};
}

/// The part of a face. A number of no texture is that of the last part, and a warning unless it is -1.
size_t part_of(Build& build, uint32_t row) {
  if (!build.wanted.texture_numbers) return 0;
  const size_t none = build.parts.size() - 1;
  const double number = row == kNoRow ? -1 : build.wanted.texture_numbers->values[row];
  if (number >= 0 && number < static_cast<double>(none)) return static_cast<size_t>(number);
  if (number != -1) build.warnings.add("PLY: texnumber of faces is out of range: they have no texture");
  return none;
}

/// Appends a polygon's triangles. `row` is its face, or kNoRow.
void append_polygon(Build& build, const std::vector<double>& indices, uint32_t row) {
  std::vector<Point> points;
  for (const double index : indices) {
    if (!(index >= 0 && index < static_cast<double>(build.wanted.vertex_count))) break;
    points.push_back(position_of(build.wanted, static_cast<uint32_t>(index)));
    for (const double c : points.back()) {
      if (!(std::fabs(c) < 1e37)) points.clear();  // inside the range of floats
    }
    if (points.empty()) break;
  }
  if (points.size() != indices.size() || points.size() < 3) {
    ++build.bad;
    return;
  }
  const size_t part = part_of(build, row);
  const PlyProperty* const uvs = row == kNoRow ? nullptr : build.wanted.corner_uvs;
  const uint64_t first_uv = !uvs || row == 0 ? 0 : uvs->ends[row - 1];
  const bool lacks_uvs = uvs && uvs->ends[row] == first_uv;
  if (lacks_uvs) {
    build.warnings.add("PLY: faces without texture coordinates take the place (0, 0)");
  } else if (uvs && uvs->ends[row] - first_uv != 2 * indices.size()) {
    core::refuse(SHD_ERROR_CORRUPT, "PLY: face %u has no texture coordinates for each corner", row);
  }
  std::vector<std::array<uint32_t, 3>> triangles;
  triangulate(points, build.source.deadline, triangles);
  build.triangles += triangles.size();
  check_limit("triangles", build.triangles, "max_triangles", build.source.limits.triangles);
  for (const auto& triangle : triangles) {
    for (const uint32_t corner : triangle) {
      const uint64_t uv = lacks_uvs ? kNoUv : first_uv + 2 * corner;
      build.parts[part].corners.push_back({static_cast<uint32_t>(indices[corner]), row, uv});
    }
  }
}

void collect_polygons(Build& build) {
  const PlyProperty& polygons = *build.wanted.polygons;
  std::vector<double> indices;
  uint64_t begin = 0;
  for (uint32_t row = 0; row < polygons.ends.size(); ++row) {
    if (row % 4096 == 0) build.source.deadline.check();
    indices.assign(polygons.values.begin() + static_cast<std::ptrdiff_t>(begin),
                   polygons.values.begin() + static_cast<std::ptrdiff_t>(polygons.ends[row]));
    append_polygon(build, indices, row);
    begin = polygons.ends[row];
  }
}

/// A strip ends at a negative index. Every second triangle has the other winding.
void collect_strips(Build& build) {
  const PlyProperty& strips = *build.wanted.strips;
  uint64_t begin = 0;
  for (const uint64_t end : strips.ends) {
    uint64_t length = 0;
    for (uint64_t i = begin; i < end; ++i) {
      if (i % 4096 == 0) build.source.deadline.check();
      length = strips.values[i] < 0 ? 0 : length + 1;
      if (length < 3) continue;
      const double a = strips.values[i - 2], b = strips.values[i - 1], c = strips.values[i];
      if (a == b || b == c || a == c) continue;  // joins two strips
      append_polygon(build, length % 2 == 1 ? std::vector<double>{a, b, c} : std::vector<double>{b, a, c}, kNoRow);
    }
    begin = end;
  }
}

/// Makes one vertex of all corners with the same row of the file. The corners become the vertices.
std::vector<uint32_t> share_vertices(uint64_t vertex_count, std::vector<Corner>& corners) {
  std::vector<uint32_t> vertex_of(vertex_count, kNoRow), indices;
  std::vector<Corner> vertices;
  for (const Corner& corner : corners) {
    uint32_t& vertex = vertex_of[corner.vertex];
    if (vertex == kNoRow) {
      vertex = static_cast<uint32_t>(vertices.size());
      vertices.push_back(corner);
    }
    indices.push_back(vertex);
  }
  corners = std::move(vertices);
  return indices;
}

void append_color(const Colors& colors, uint32_t row, std::vector<float>& out) {
  for (size_t c = 0; c < 4; ++c) {
    const PlyProperty* const channel = c < 3 ? colors.rgb[c] : colors.alpha;
    const auto code = channel ? static_cast<float>(channel->values[row] / colors.one) : 1.0f;
    out.push_back(c < 3 ? linear_of_srgb(code) : code > 0.0f ? std::min(code, 1.0f) : 0.0f);
  }
}

void append_columns(const Wanted& wanted, const Corner& corner, Geometry& geometry) {
  for (size_t c = 0; c < 3 && wanted.has_normals(); ++c) {
    geometry.normal.push_back(static_cast<float>(wanted.normal[c]->values[corner.vertex]));
  }
  if (wanted.vertex_colors.present()) append_color(wanted.vertex_colors, corner.vertex, geometry.color);
  if (wanted.face_colors.present()) {
    static const Colors kWhite;
    append_color(corner.face == kNoRow ? kWhite : wanted.face_colors, corner.face, geometry.color);
  }
  const bool by_vertex = wanted.uv[0] != nullptr;
  if (!wanted.corner_uvs && !by_vertex) return;
  double u = 0, v = 0;
  if (wanted.corner_uvs && corner.face != kNoRow && corner.uv != kNoUv) {
    u = wanted.corner_uvs->values[corner.uv];
    v = wanted.corner_uvs->values[corner.uv + 1];
  } else if (by_vertex) {
    u = wanted.uv[0]->values[corner.vertex];
    v = wanted.uv[1]->values[corner.vertex];
  }
  geometry.uv.push_back(static_cast<float>(u));
  geometry.uv.push_back(static_cast<float>(1.0 - v));
}

void add_part(const Build& build, const Point& base, bool split, Part&& part, Model& model) {
  const Wanted& wanted = build.wanted;
  Geometry geometry;
  if (split) {
    for (uint32_t i = 0; i < part.corners.size(); ++i) geometry.indices.push_back(i);
  } else {
    geometry.indices = share_vertices(wanted.vertex_count, part.corners);
  }
  check_limit("vertices", part.corners.size(), "max_vertices", build.source.limits.vertices);
  std::vector<double> positions;
  for (const Corner& corner : part.corners) {
    const Point p = position_of(wanted, corner.vertex);
    positions.insert(positions.end(), p.begin(), p.end());
    append_columns(wanted, corner, geometry);
  }
  set_positions(geometry, positions, base);
  if (split) join_identical(geometry);
  Placement placement;
  placement.geometry = static_cast<uint32_t>(model.geometries.size());
  placement.surface = static_cast<uint32_t>(model.surfaces.size());
  model.geometries.push_back(std::move(geometry));
  model.placements.push_back(std::move(placement));
}

/// A surface with a texture (-1 = none). It blends if colours have alpha.
Surface surface_of(const Geometry& geometry, int32_t texture, Warnings& warnings) {
  Surface surface;
  surface.name = "default";
  const bool textured = texture >= 0 && !geometry.uv.empty();
  if (textured) surface.maps[SHD_SLOT_DIFFUSE].texture = texture;
  if (texture >= 0 && !textured) warnings.add("PLY: a texture without texture coordinates is left out");
  surface.diffuse.fill(textured || !geometry.color.empty() ? 1.0f : 0.6f);
  for (size_t i = 3; i < geometry.color.size(); i += 4) {
    if (geometry.color[i] < 1.0f) surface.alpha = Alpha::kBlend;
  }
  return surface;
}

/// The place around which all positions that triangles have are read.
Point base_of(const Build& build) {
  std::vector<double> positions;
  for (const Part& part : build.parts) {
    for (const Corner& corner : part.corners) {
      const Point p = position_of(build.wanted, corner.vertex);
      positions.insert(positions.end(), p.begin(), p.end());
    }
  }
  return choose_origin(positions);
}

void add_parts(Build& build, Model& model) {
  const Wanted& wanted = build.wanted;
  const bool split = wanted.face_colors.present() || wanted.corner_uvs;
  const Point base = base_of(build);
  for (size_t i = 0; i < build.parts.size(); ++i) {
    if (build.parts[i].corners.empty()) continue;
    build.source.deadline.check();
    add_part(build, base, split, std::move(build.parts[i]), model);
    model.geometries.back().name = text_of(build.source.name);
    const int32_t texture = i < model.textures.size() ? static_cast<int32_t>(i) : -1;
    model.surfaces.push_back(surface_of(model.geometries.back(), texture, build.warnings));
  }
  if (wanted.has_normals()) return;
  add_creased_normals(model.geometries.data(), model.geometries.size(), build.source.limits, build.source.deadline);
}

}  // namespace
}  // namespace ply

bool is_ply(const Source& source) {
  const std::string text = utf8_of(source.bytes, 8);
  return text.compare(0, 3, "ply") == 0 && text.size() > 3 && (is_blank(text[3]) || text[3] == '\n' || text[3] == '\r');
}

Model read_ply(const Source& source) {
  Model model;
  Warnings warnings(model);
  PlyFile file = parse_ply_header(source);
  ply::Wanted wanted = ply::want_properties(file, warnings);
  check_limit("vertices", wanted.vertex_count, "max_vertices", source.limits.vertices);
  if (!wanted.position[0]) {
    core::refuse(SHD_ERROR_CORRUPT, "PLY: element \"vertex\" with x, y and z is missing");
  }
  read_ply_rows(source, file, warnings);
  ply::find_scale(wanted.vertex_colors);
  ply::find_scale(wanted.face_colors);
  ply::Build build{source, wanted, warnings, {}, 0, 0};
  build.parts.resize(wanted.texture_numbers ? file.textures.size() + 1 : 1);
  if (wanted.polygons) ply::collect_polygons(build);
  if (wanted.strips) ply::collect_strips(build);
  if (!wanted.polygons && !wanted.strips) {
    warnings.add("mesh \"" + text_of(source.name) + "\": it has points and no faces");
  }
  if (build.bad > 0) {
    warnings.add("mesh \"" + text_of(source.name) + "\": " + std::to_string(build.bad) +
                 " faces with indices out of range or positions that are not finite");
  }
  if (build.triangles == 0) refuse_empty(model);
  Node root;
  root.name = text_of(source.name);
  model.nodes.push_back(std::move(root));
  for (size_t i = 0; i < file.textures.size(); ++i) {
    if (i < build.parts.size()) {
      model.textures.emplace_back();
      model.textures.back().name = file.textures[i];
    } else {
      warnings.add("PLY: texture \"" + text_of(file.textures[i]) + "\" is left out: no face names it");
    }
  }
  ply::add_parts(build, model);
  return model;
}

}  // namespace shd::scene
