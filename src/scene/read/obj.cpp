// SPDX-License-Identifier: MIT
#include "scene/read/obj.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "scene/read/colors.h"
#include "scene/read/creases.h"
#include "scene/read/polygon.h"
#include "scene/read/positions.h"
#include "scene/read/text_lines.h"
#include "scene/text.h"

namespace shd::scene {
namespace {

/// A vertex of a geometry is a position, a texture coordinate and a normal of the file. The normal is a row of the
/// file's, or behind these a computed one.
struct Key {
  int32_t position, uv;
  int64_t normal;
  bool operator==(const Key& other) const {
    return position == other.position && uv == other.uv && normal == other.normal;
  }
};

struct KeyHash {
  size_t operator()(const Key& key) const {
    const auto mix = [](uint64_t h, uint64_t value) { return (h ^ value) * 0x9e3779b97f4a7c15u; };
    const uint64_t h = mix(mix(static_cast<uint64_t>(key.position), static_cast<uint64_t>(key.uv) << 20),
                           static_cast<uint64_t>(key.normal));
    return static_cast<size_t>(h ^ h >> 29);
  }
};

/// The vertices of one part.
struct PartVertices {
  std::vector<double> positions;
  std::vector<uint32_t> indices;
  std::vector<Key> keys;
  std::unordered_map<Key, uint32_t, KeyHash> vertex_of;
};

/// State between the statements and the model.
struct Build {
  const Source& source;
  const ObjFile& file;
  Warnings& warnings;
  std::vector<int64_t> corner_normals;  // by corner: row of file.normals, or behind them of `computed`
  std::vector<Point> computed;          // normals that the file has not
  uint64_t unusable_normals = 0;
};

Point position_of(const ObjFile& file, int32_t row) {
  const double* const p = &file.positions[size_t{3} * static_cast<size_t>(row)];
  return {p[0], p[1], p[2]};
}

/// Inside the range of floats, so that positions stay finite.
bool is_usable(const ObjFile& file, const ObjFace& face) {
  for (size_t i = 0; i < face.count; ++i) {
    for (const double c : position_of(file, file.corners[face.first + i].position)) {
      if (!(std::fabs(c) < 1e37)) return false;
    }
  }
  return true;
}

std::vector<Point> polygon_of(const ObjFile& file, const ObjFace& face) {
  std::vector<Point> corners;
  for (size_t i = 0; i < face.count; ++i) {
    corners.push_back(position_of(file, file.corners[face.first + i].position));
  }
  return corners;
}

/// Whether a corner has a normal of the file with a direction.
bool has_normal(Build& build, const ObjCorner& corner) {
  if (corner.normal == kNone) return false;
  const float* const n = &build.file.normals[size_t{3} * static_cast<size_t>(corner.normal)];
  const bool good = std::isfinite(n[0]) && std::isfinite(n[1]) && std::isfinite(n[2]) && (n[0] || n[1] || n[2]);
  if (!good) ++build.unusable_normals;
  return good;
}

/// Removes faces with positions that are not finite.
void drop_faces(ObjFile& file, Warnings& warnings) {
  std::vector<uint64_t> bad(file.parts.size());
  const auto is_bad = [&file, &bad](const ObjFace& face) {
    if (is_usable(file, face)) return false;
    ++bad[face.part];
    return true;
  };
  file.faces.erase(std::remove_if(file.faces.begin(), file.faces.end(), is_bad), file.faces.end());
  for (size_t i = 0; i < bad.size(); ++i) {
    if (bad[i] == 0) continue;
    warnings.add("mesh \"" + text_of(file.parts[i].name) + "\": " + std::to_string(bad[i]) +
                 " faces with positions that are not finite");
  }
}

/// Numbers for the corners at one position that smooth each other: those in the same smoothing group.
struct Places {
  std::unordered_map<uint64_t, uint32_t> place_of;  // by group and position
  uint32_t count = 0;

  uint32_t of(uint32_t group, int32_t position) {
    const auto [at, is_new] = place_of.try_emplace(uint64_t{group} << 32 | static_cast<uint32_t>(position), count);
    if (is_new) ++count;
    return at->second;
  }
};

/// Chooses the normal of each corner. Corners without one get the mean over the faces of their smoothing group around
/// the position; `s off` gives the normal of the face. Faces with normals of the file count for their neighbours.
void choose_normals(Build& build) {
  constexpr double kOpposite = -0.99;  // a group smooths any edge, but not a face with its own back
  const ObjFile& file = build.file;
  std::vector<CreaseCorner> corners;
  std::vector<Point> faces;
  Places places;
  for (const ObjFace& face : file.faces) {
    const auto row = static_cast<uint32_t>(faces.size());
    faces.push_back(newell_normal(polygon_of(file, face)));
    const double cosine = face.group == kNoStatement ? kCrease : kOpposite;
    const uint32_t alone = face.group == kNoGroup ? places.count++ : 0;
    for (size_t i = face.first; i < face.first + face.count; ++i) {
      const int32_t position = file.corners[i].position;
      corners.push_back({face.group == kNoGroup ? alone : places.of(face.group, position), row, cosine});
    }
  }
  CornerNormals computed = crease_normals(corners, faces, places.count, build.source.deadline);
  build.computed = std::move(computed.normals);
  const auto own = static_cast<int64_t>(file.normals.size() / 3);
  build.corner_normals.resize(file.corners.size());
  const uint32_t* row = computed.row.data();
  for (const ObjFace& face : file.faces) {
    for (size_t i = face.first; i < face.first + face.count; ++i, ++row) {
      const ObjCorner& corner = file.corners[i];
      build.corner_normals[i] = has_normal(build, corner) ? corner.normal : own + *row;
    }
  }
  if (build.unusable_normals) {
    build.warnings.add("normals of length 0 or not finite: those of the faces are used");
  }
}

uint32_t vertex_of(Build& build, PartVertices& part, size_t corner_index) {
  const ObjCorner& corner = build.file.corners[corner_index];
  const Key key = {corner.position, corner.uv, build.corner_normals[corner_index]};
  const auto next = static_cast<uint32_t>(part.keys.size());
  const auto [at, is_new] = part.vertex_of.try_emplace(key, next);
  if (is_new) {
    part.keys.push_back(key);
    for (const double c : position_of(build.file, corner.position)) part.positions.push_back(c);
  }
  return at->second;
}

std::vector<PartVertices> collect(Build& build) {
  std::vector<PartVertices> parts(build.file.parts.size());
  std::vector<std::array<uint32_t, 3>> triangles;
  uint64_t count = 0, faces = 0, vertices = 0;
  for (const ObjFace& face : build.file.faces) {
    if (++faces % 1024 == 0) build.source.deadline.check();
    PartVertices& part = parts[face.part];
    triangles.clear();
    triangulate(polygon_of(build.file, face), build.source.deadline, triangles);
    const size_t before = part.keys.size();
    for (const auto& triangle : triangles) {
      for (const uint32_t corner : triangle) part.indices.push_back(vertex_of(build, part, face.first + corner));
    }
    vertices += part.keys.size() - before;
    count += triangles.size();
    check_limit("vertices", vertices, "max_vertices", build.source.limits.vertices);
    check_limit("triangles", count, "max_triangles", build.source.limits.triangles);
  }
  return parts;
}

void append_normal(const Build& build, int64_t row, std::vector<float>& out) {
  const auto own = static_cast<int64_t>(build.file.normals.size() / 3);
  if (row < own) {
    const float* const n = &build.file.normals[size_t{3} * static_cast<size_t>(row)];
    out.insert(out.end(), n, n + 3);
    return;
  }
  for (const double c : build.computed[static_cast<size_t>(row - own)]) out.push_back(static_cast<float>(c));
}

void append_color(const ObjFile& file, size_t position, float scale, std::vector<float>& out) {
  for (size_t c = 0; c < 3; ++c) {
    const float code = file.colors[3 * position + c];
    out.push_back(std::isnan(code) ? 1.0f : linear_of_srgb(code * scale));
  }
  out.push_back(1.0f);
}

Geometry geometry_of(const Build& build, PartVertices&& part, const std::string& name, const Point& base,
                     float color_scale) {
  const ObjFile& file = build.file;
  Geometry geometry;
  geometry.name = text_of(name);
  geometry.indices = std::move(part.indices);
  set_positions(geometry, part.positions, base);
  const bool has_uv = std::any_of(part.keys.begin(), part.keys.end(), [](const Key& key) { return key.uv != kNone; });
  for (const Key& key : part.keys) {
    append_normal(build, key.normal, geometry.normal);
    if (!file.colors.empty()) append_color(file, static_cast<size_t>(key.position), color_scale, geometry.color);
    if (!has_uv) continue;
    const float* const uv = key.uv == kNone ? nullptr : &file.uvs[size_t{2} * static_cast<size_t>(key.uv)];
    geometry.uv.push_back(uv ? uv[0] : 0.0f);
    geometry.uv.push_back(uv ? 1.0f - uv[1] : 0.0f);
  }
  return geometry;
}

/// The place that all geometries share.
Point base_of(const std::vector<PartVertices>& parts) {
  std::vector<double> all;
  for (const PartVertices& part : parts) all.insert(all.end(), part.positions.begin(), part.positions.end());
  return choose_origin(all);
}

/// The surface of a part without a material of the file: grey, or white under colours of vertices.
int32_t plain_surface(const ObjFile& file, int32_t* known, Model& model) {
  if (*known == kNone) {
    *known = static_cast<int32_t>(model.surfaces.size());
    Surface surface;
    surface.name = "default";
    const float grey = file.colors.empty() ? 0.6f : 1.0f;
    surface.diffuse = {grey, grey, grey};
    model.surfaces.push_back(surface);
  }
  return *known;
}

/// Colours are numbers of 0..1. Files with greater ones have bytes.
float color_scale_of(const ObjFile& file) {
  const bool bytes = std::any_of(file.colors.begin(), file.colors.end(), [](float c) { return c > 1.0f; });
  return bytes ? 1.0f / 255.0f : 1.0f;
}

void add_parts(Build& build, Model& model) {
  const ObjFile& file = build.file;
  std::vector<PartVertices> parts = collect(build);
  const Point base = base_of(parts);
  const float color_scale = color_scale_of(file);
  std::vector<std::string> names;  // materials of faces
  std::vector<int32_t> name_of(file.material_names.size(), kNone);
  for (size_t i = 0; i < parts.size(); ++i) {
    const int32_t material = file.parts[i].material;
    if (material == kNone || parts[i].indices.empty() || name_of[static_cast<size_t>(material)] != kNone) continue;
    name_of[static_cast<size_t>(material)] = static_cast<int32_t>(names.size());
    names.push_back(file.material_names[static_cast<size_t>(material)]);
  }
  const std::vector<int32_t> surfaces = add_mtl_surfaces(build.source, file.libraries, names, model, build.warnings);
  int32_t plain = kNone;
  for (size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].indices.empty()) continue;
    build.source.deadline.check();
    const int32_t material = file.parts[i].material;
    int32_t surface = material == kNone ? kNone : surfaces[static_cast<size_t>(name_of[static_cast<size_t>(material)])];
    if (surface == kNone) surface = plain_surface(file, &plain, model);
    Placement placement;
    placement.geometry = static_cast<uint32_t>(model.geometries.size());
    placement.surface = static_cast<uint32_t>(surface);
    model.geometries.push_back(geometry_of(build, std::move(parts[i]), file.parts[i].name, base, color_scale));
    model.placements.push_back(placement);
    check_limit("instances", model.placements.size(), "max_instances", build.source.limits.instances);
  }
}

bool is_obj_word(std::string_view word) {
  constexpr std::string_view kWords[] = {"v", "vt", "vn", "vp", "f", "l", "p", "o", "g", "s", "mtllib", "usemtl"};
  return std::find(std::begin(kWords), std::end(kWords), word) != std::end(kWords);
}

bool has_extension(const std::string& name) {
  const size_t dot = name.size() < 4 ? std::string::npos : name.size() - 4;
  return dot != std::string::npos && name[dot] == '.' && (name[dot + 1] | 0x20) == 'o' &&
         (name[dot + 2] | 0x20) == 'b' && (name[dot + 3] | 0x20) == 'j';
}

}  // namespace

bool is_obj(const Source& source) {
  constexpr size_t kStart = size_t{1} << 20;
  const std::string text = utf8_of(source.bytes, kStart);
  TextLines lines(text);
  std::string_view statement;
  bool first = !has_extension(source.name);
  while (lines.next(&statement)) {
    const std::string_view word = take_word(&statement);
    if (first && !is_obj_word(word)) return false;
    first = false;
    double number = 0;
    if (word == "v" && take_number(&statement, &number) && take_number(&statement, &number) &&
        take_number(&statement, &number)) {
      return true;
    }
  }
  return false;
}

Model read_obj(const Source& source) {
  Model model;
  Warnings warnings(model);
  ObjFile file = parse_obj(source, utf8_of(source.bytes), warnings);
  drop_faces(file, warnings);
  if (file.faces.empty()) refuse_empty(model);
  Build build{source, file, warnings, {}, {}, 0};
  choose_normals(build);
  Node root;
  root.name = text_of(source.name);
  model.nodes.push_back(std::move(root));
  add_parts(build, model);
  return model;
}

}  // namespace shd::scene
