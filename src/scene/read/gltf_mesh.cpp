// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "scene/read/gltf_decode.h"
#include "scene/read/gltf_document.h"

namespace shd::scene::gltf {
namespace {

constexpr uint64_t kTriangleList = 4;  // mode of a primitive

constexpr uint32_t kNoVertex = 0xffffffffu;

/// A primitive while it is read.
struct Primitive {
  Document& document;
  const Part& part;
  std::string title;                 // for warnings
  Part draco;                        // KHR_draco_mesh_compression, or absent
  std::vector<DracoColumn> columns;  // decoded attributes
  std::vector<uint32_t> draco_indices;
  size_t count = 0;            // vertices of the file
  std::vector<uint32_t> rows;  // vertices of the file that the geometry has
  Geometry geometry;

  void warn(const std::string& text) { document.warnings.add(title + ": " + text); }
};

/// The columns that Draco's data has, with the types of their accessors.
void decode_columns(Primitive& p) {
  const Part attributes = p.draco["attributes"], accessors = p.document.root["accessors"];
  if (!attributes || !attributes.json()->is_object()) p.draco.refuse("has no attributes");
  for (const auto& item : attributes.json()->items()) {
    const std::optional<uint32_t> accessor = p.part["attributes"].index(item.key().c_str(), accessors.size());
    if (!accessor) continue;
    const Accessor plain = open_accessor(p.document, p.part["attributes"][item.key().c_str()]);
    const auto id = static_cast<uint32_t>(attributes[item.key().c_str()].integer(kNoVertex));
    p.columns.push_back({id, plain.component_type, plain.components, {}});
    spend_bytes(p.document, uint64_t{plain.components} * component_size(plain.component_type) * p.count);
  }
  const Part indices = p.part["indices"];
  const uint64_t corners = indices ? open_accessor(p.document, indices).count : p.count;
  check_limit("triangles", p.document.triangles + corners / 3, "max_triangles", p.document.source.limits.triangles);
  spend_bytes(p.document, corners * sizeof(uint32_t));
  const std::optional<uint32_t> view = p.draco.index("bufferView", p.document.root["bufferViews"].size());
  if (!view) p.draco.refuse("has no bufferView");
  const uint64_t most = p.part.integer("mode", kTriangleList) == kTriangleList ? corners / 3 : corners;
  p.draco_indices = decode_draco(view_bytes(p.document, *view), most, p.count, p.columns);
}

/// The accessor of an attribute, with the bytes that Draco has decoded. Absent if the primitive has no such attribute.
std::optional<Accessor> attribute_of(Primitive& p, const Part& attributes, const char* name) {
  const Part reference = attributes[name];
  if (!reference) return std::nullopt;
  Accessor accessor = open_accessor(p.document, reference);
  if (accessor.count < p.count) reference.refuse("has fewer elements than POSITION");
  if (!kHasDraco || !p.draco || attributes.where() != p.part["attributes"].where()) return accessor;
  const Part id = p.draco["attributes"][name];
  for (const DracoColumn& column : p.columns) {
    if (!id || column.id != id.integer()) continue;
    accessor.stride = component_size(column.component_type) * column.components;
    accessor.data = column.bytes.data();
    accessor.count = column.bytes.size() / accessor.stride;
  }
  return accessor;
}

/// The numbers of an attribute at the rows of the geometry; empty if there is none. A fault of it is a warning.
std::vector<float> read_column(Primitive& p, const Part& attributes, const char* name, uint32_t width) {
  std::vector<float> out;
  attempt(p.document, p.title, [&] {
    std::optional<Accessor> accessor = attribute_of(p, attributes, name);
    if (!accessor) return;
    const bool color = std::string(name) == "COLOR_0";
    if (accessor->components != width && !(color && accessor->components == 3)) {
      attributes[name].refuse("its elements have " + std::to_string(accessor->components) + " components, not " +
                              std::to_string(width));
    }
    // Integers of colours and weights are normalised, with or without the flag (section 3.7.2.1).
    if (color || name[0] == 'W') accessor->normalized = accessor->component_type != kFloat;
    out = read_floats(*accessor, &p.rows);
  });
  return out;
}

/// Replaces numbers that are not finite.
void make_finite(Primitive& p, const char* name, std::vector<float>& numbers, float value) {
  size_t bad = 0;
  for (float& number : numbers) {
    if (std::isfinite(number)) continue;
    number = value;
    ++bad;
  }
  if (bad) p.warn(std::string(name) + " has numbers that are not finite: " + std::to_string(bad));
}

/// Corners of the triangles of a primitive (section 3.7.2.1).
std::vector<uint32_t> corners_of(const std::vector<uint32_t>& v, uint64_t mode) {
  std::vector<uint32_t> out;
  if (mode == 4) {
    out.assign(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 3 * 3));
    return out;
  }
  for (size_t i = 0; i + 2 < v.size(); ++i) {
    if (mode == 5) {
      out.insert(out.end(), {v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]});
    } else {
      out.insert(out.end(), {v[i + 1], v[i + 2], v[0]});
    }
  }
  return out;
}

/// Removes triangles with a corner that `is_good` does not accept. Returns their number.
template <class Good>
size_t drop_triangles(std::vector<uint32_t>& corners, Good is_good) {
  size_t kept = 0;
  for (size_t i = 0; i + 2 < corners.size(); i += 3) {
    if (!is_good(corners[i]) || !is_good(corners[i + 1]) || !is_good(corners[i + 2])) continue;
    for (size_t k = 0; k < 3; ++k) corners[kept++] = corners[i + k];
  }
  const size_t dropped = (corners.size() - kept) / 3;
  corners.resize(kept);
  return dropped;
}

/// The different numbers of `corners`, in their order. Many vertices that others use cost nothing.
std::vector<uint32_t> used_vertices(const std::vector<uint32_t>& corners) {
  std::vector<uint32_t> used;
  const auto last = std::max_element(corners.begin(), corners.end());
  if (last != corners.end() && *last / 8 < corners.size()) {
    std::vector<bool> is_used(size_t{*last} + 1);
    for (const uint32_t corner : corners) is_used[corner] = true;
    for (uint32_t i = 0; i <= *last; ++i) {
      if (is_used[i]) used.push_back(i);
    }
    return used;
  }
  used = corners;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

/// Numbers the vertices of `corners` anew, in their order. Returns the old numbers.
std::vector<uint32_t> compact(std::vector<uint32_t>& corners) {
  std::vector<uint32_t> used = used_vertices(corners);
  if (used.empty() || used.size() == size_t{used.back()} + 1) return used;
  for (uint32_t& corner : corners) {
    corner = static_cast<uint32_t>(std::lower_bound(used.begin(), used.end(), corner) - used.begin());
  }
  return used;
}

std::vector<uint32_t> indices_of(Primitive& p) {
  if (!p.draco_indices.empty()) return p.draco_indices;
  const Part reference = p.part["indices"];
  const uint64_t most = 3 * p.document.source.limits.triangles + 2;
  std::vector<uint32_t> out;
  if (reference) {
    const Accessor accessor = open_accessor(p.document, reference);
    if (accessor.components != 1) reference.refuse("is no accessor of scalars");
    check_limit("triangles", accessor.count > most ? accessor.count / 3 : 0, "max_triangles",
                p.document.source.limits.triangles);
    return read_integers(accessor);
  }
  check_limit("vertices", p.count, "max_vertices", p.document.source.limits.vertices);
  out.resize(p.count);
  for (size_t i = 0; i < p.count; ++i) out[i] = static_cast<uint32_t>(i);
  return out;
}

/// Reads triangles and positions. Only vertices of good triangles stay.
void read_triangles(Primitive& p, const Accessor& positions, uint64_t mode) {
  std::vector<uint32_t>& corners = p.geometry.indices;
  corners = corners_of(indices_of(p), p.draco_indices.empty() ? mode : kTriangleList);  // Draco gives triangles
  size_t bad = drop_triangles(corners, [&](uint32_t v) { return v < positions.count; });
  p.rows = compact(corners);
  p.document.vertices += p.rows.size();
  p.document.triangles += corners.size() / 3;
  check_limit("vertices", p.document.vertices, "max_vertices", p.document.source.limits.vertices);
  check_limit("triangles", p.document.triangles, "max_triangles", p.document.source.limits.triangles);
  std::vector<float>& numbers = p.geometry.position;
  numbers = read_floats(positions, &p.rows);
  const auto is_finite = [&](uint32_t v) {
    return std::isfinite(numbers[3 * v]) && std::isfinite(numbers[3 * v + 1]) && std::isfinite(numbers[3 * v + 2]);
  };
  if (const size_t wild = drop_triangles(corners, is_finite)) {
    bad += wild;
    std::vector<uint32_t> rows = compact(corners);
    for (uint32_t& row : rows) row = p.rows[row];
    p.rows = std::move(rows);
    numbers = read_floats(positions, &p.rows);
  }
  if (bad) p.warn(std::to_string(bad) + " faces with indices out of range or positions that are not finite");
}

void read_colors(Primitive& p, const Part& attributes) {
  std::vector<float> from = read_column(p, attributes, "COLOR_0", 4);
  if (from.empty()) return;
  const size_t width = from.size() / p.rows.size();
  make_finite(p, "COLOR_0", from, 1.0f);
  std::vector<float>& out = p.geometry.color;
  if (width == 4) out = std::move(from);
  for (size_t i = 0; width == 3 && i < p.rows.size(); ++i) {
    out.insert(out.end(), {from[3 * i], from[3 * i + 1], from[3 * i + 2], 1.0f});
  }
}

/// Sets of four joints and weights (section 3.7.3.3).
void read_joints(Primitive& p, const Part& attributes) {
  constexpr uint32_t kMaxSets = 8;
  std::vector<std::vector<uint32_t>> joints;
  std::vector<std::vector<float>> weights;
  for (uint32_t set = 0; set < kMaxSets; ++set) {
    const std::string number = std::to_string(set);
    std::vector<float> weight = read_column(p, attributes, ("WEIGHTS_" + number).c_str(), 4);
    if (weight.empty()) break;
    const bool good = attempt(p.document, p.title, [&] {
      const std::optional<Accessor> joint = attribute_of(p, attributes, ("JOINTS_" + number).c_str());
      if (!joint || joint->components != 4) attributes.refuse("JOINTS_" + number + " does not fit WEIGHTS_" + number);
      joints.push_back(read_integers(*joint, &p.rows));
    });
    if (!good) break;
    make_finite(p, "WEIGHTS", weight, 0.0f);
    weights.push_back(std::move(weight));
  }
  const size_t sets = weights.size(), count = p.rows.size();
  p.geometry.influences = static_cast<uint32_t>(4 * sets);
  for (size_t i = 0; i < 4 * count * (sets ? 1 : 0); i += 4) {
    for (size_t set = 0; set < sets; ++set) {
      for (size_t k = i; k < i + 4; ++k) {
        p.geometry.joint.push_back(static_cast<uint16_t>(std::min(joints[set][k], 0xffffu)));
        p.geometry.weight.push_back(weights[set][k]);
      }
    }
  }
}

/// Morph targets (section 3.7.2.2).
void read_morphs(Primitive& p) {
  const Part targets = p.part["targets"];
  for (size_t i = 0; i < targets.size(); ++i) {
    const Part target = targets.at(i);
    p.document.vertices += p.rows.size();
    check_limit("vertices, with those of morph targets,", p.document.vertices, "max_vertices",
                p.document.source.limits.vertices);
    MorphTarget morph;
    morph.position = read_column(p, target, "POSITION", 3);
    make_finite(p, "a morph target", morph.position, 0.0f);
    if (!p.geometry.normal.empty()) morph.normal = read_column(p, target, "NORMAL", 3);
    if (!p.geometry.tangent.empty()) morph.tangent = read_column(p, target, "TANGENT", 3);
    make_finite(p, "a morph target", morph.normal, 0.0f);
    make_finite(p, "a morph target", morph.tangent, 0.0f);
    for (const auto& item : target.json()->items()) {
      const std::string& name = item.key();
      if (name != "POSITION" && name != "NORMAL" && name != "TANGENT")
        p.warn("morph targets of " + name + " are left out");
    }
    p.geometry.morphs.push_back(std::move(morph));
  }
}

/// Says which attributes are left out. Names that begin with "_" belong to applications.
void warn_about_attributes(Primitive& p, const Part& attributes) {
  for (const auto& item : attributes.json()->items()) {
    const std::string& name = item.key();
    const bool joints = name.rfind("JOINTS_", 0) == 0 || name.rfind("WEIGHTS_", 0) == 0;
    const bool known = name == "POSITION" || name == "NORMAL" || name == "TANGENT" || name == "TEXCOORD_0" ||
                       name == "TEXCOORD_1" || name == "COLOR_0" || joints || name.rfind('_', 0) == 0;
    if (!known) p.warn("attribute " + name + " is left out");
  }
}

void read_attributes(Primitive& p) {
  const Part attributes = p.part["attributes"];
  Geometry& g = p.geometry;
  g.normal = read_column(p, attributes, "NORMAL", 3);
  // Section 3.7.2.1: without normals they are flat, and tangents are ignored.
  g.shading = g.normal.empty() ? Shading::kFlat : Shading::kSmooth;
  if (!g.normal.empty()) g.tangent = read_column(p, attributes, "TANGENT", 4);
  make_finite(p, "TANGENT", g.tangent, 0.0f);
  for (size_t i = 3; i < g.tangent.size(); i += 4) g.tangent[i] = g.tangent[i] < 0.0f ? -1.0f : 1.0f;
  g.uv = read_column(p, attributes, "TEXCOORD_0", 2);
  g.uv1 = read_column(p, attributes, "TEXCOORD_1", 2);
  make_finite(p, "TEXCOORD_0", g.uv, 0.0f);
  make_finite(p, "TEXCOORD_1", g.uv1, 0.0f);
  read_colors(p, attributes);
  read_joints(p, attributes);
  read_morphs(p);
  warn_about_attributes(p, attributes);
}

/// The material of a primitive: that of the first variant (KHR_materials_variants), its own, or the default one.
uint32_t surface_of(Document& document, const Part& primitive) {
  const size_t count = document.root["materials"].size();
  const Part mappings = primitive.extension("KHR_materials_variants")["mappings"];
  for (size_t i = 0; i < mappings.size(); ++i) {
    const Part mapping = mappings.at(i), variants = mapping["variants"];
    for (size_t k = 0; k < variants.size(); ++k) {
      if (variants.at(k).integer() != 0) continue;
      if (const std::optional<uint32_t> material = mapping.index("material", count)) return *material;
    }
  }
  const std::optional<uint32_t> material = primitive.index("material", count);
  return material ? *material : default_surface(document);
}

/// Returns false if the primitive has nothing to draw.
bool read_primitive(Document& document, const Part& mesh, const Part& part, MeshPart& out) {
  static constexpr const char* kLeftOut[] = {"points", "lines", "line loops", "line strips"};
  Primitive p = {document, part, title_of("mesh", mesh), part.extension("KHR_draco_mesh_compression"), {}, {}, 0,
                 {},       {}};
  const uint64_t mode = part.integer("mode", 4, 6);
  if (mode < 4) {
    p.warn(std::string("points and lines are left out: it has ") + kLeftOut[mode]);
    return false;
  }
  document.source.deadline.check();
  const Part attributes = part["attributes"];
  const Part position = attributes["POSITION"];
  if (!position) part.refuse("has no POSITION");
  p.count = open_accessor(document, position).count;
  if (kHasDraco && p.draco) decode_columns(p);
  const Accessor positions = *attribute_of(p, attributes, "POSITION");
  if (positions.components != 3)
    position.refuse("its elements have " + std::to_string(positions.components) + " components, not 3");
  read_triangles(p, positions, mode);
  if (p.geometry.indices.empty()) return false;
  read_attributes(p);
  p.geometry.name = name_of(mesh);
  out.surface = surface_of(document, part);
  out.geometry = static_cast<uint32_t>(document.model.geometries.size());
  document.model.geometries.push_back(std::move(p.geometry));
  return true;
}

}  // namespace

std::vector<MeshPart> add_mesh(Document& document, uint32_t index) {
  const Part mesh = document.root["meshes"].at(index), primitives = mesh["primitives"];
  std::vector<MeshPart> out;
  for (size_t i = 0; i < primitives.size(); ++i) {
    MeshPart part;
    bool good = false;
    attempt(document, title_of("mesh", mesh), [&] { good = read_primitive(document, mesh, primitives.at(i), part); });
    if (good) out.push_back(part);
  }
  return out;
}

}  // namespace shd::scene::gltf
