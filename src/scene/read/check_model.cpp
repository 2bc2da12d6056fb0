// SPDX-License-Identifier: MIT
#include "scene/read/check_model.h"

#include <cmath>
#include <iterator>

namespace shd::scene {
namespace {

[[noreturn]] void refuse_part(const char* part, size_t index, const char* what) {
  core::refuse(SHD_ERROR_CORRUPT, "%s %zu: %s", part, index, what);
}

template <class Numbers>
bool are_finite(const Numbers& numbers) {
  for (const auto number : numbers) {
    if (!std::isfinite(number)) return false;
  }
  return true;
}

/// The column is absent, or has `width` numbers for each of `count` vertices.
template <class Number>
bool fits(const std::vector<Number>& column, size_t count, size_t width) {
  return column.empty() || column.size() == count * width;
}

/// An enum of a stream can have any bits.
template <class Enum>
bool is_one_of(Enum value, Enum last) {
  return static_cast<uint32_t>(value) <= static_cast<uint32_t>(last);
}

void check_geometry(const Model& model, size_t index) {
  const Geometry& g = model.geometries[index];
  const size_t count = g.position.size() / 3;
  bool good = g.position.size() % 3 == 0 && g.indices.size() % 3 == 0 && !g.indices.empty();
  good = good && fits(g.normal, count, 3) && fits(g.tangent, count, 4) && fits(g.uv, count, 2) &&
         fits(g.uv1, count, 2) && fits(g.color, count, 4) && fits(g.joint, count, g.influences) &&
         fits(g.weight, count, g.influences) && g.joint.size() == g.weight.size();
  for (const MorphTarget& morph : g.morphs) {
    good = good && fits(morph.position, count, 3) && fits(morph.normal, count, 3) && fits(morph.tangent, count, 3) &&
           are_finite(morph.position);
  }
  if (!good) refuse_part("geometry", index, "its columns have different lengths");
  if (!are_finite(g.position) || !are_finite(g.origin)) refuse_part("geometry", index, "a position is not finite");
  if (!is_one_of(g.shading, Shading::kFlat)) refuse_part("geometry", index, "its shading is not known");
  for (const uint32_t vertex : g.indices) {
    if (vertex >= count) refuse_part("geometry", index, "an index is out of range");
  }
}

void check_surface(const Model& model, size_t index) {
  const Surface& s = model.surfaces[index];
  for (const Map& map : s.maps) {
    if (map.texture >= static_cast<int64_t>(model.textures.size()) || map.uv_set > 1 || map.channel > 3 ||
        !are_finite(map.uv_transform) || map.wrap_u < 0 || map.wrap_u > SHD_WRAP_MIRROR_ONCE || map.wrap_v < 0 ||
        map.wrap_v > SHD_WRAP_MIRROR_ONCE || !is_one_of(map.magnify, Filter::kLinear) ||
        !is_one_of(map.minify, Filter::kLinear) || !is_one_of(map.mip, Filter::kLinear)) {
      refuse_part("surface", index, "a map is out of range");
    }
  }
  if (!is_one_of(s.alpha, Alpha::kBlend)) refuse_part("surface", index, "its alpha is not known");
  const float numbers[] = {s.exponent,     s.metallic,     s.roughness,  s.ior,
                           s.transmission, s.normal_scale, s.bump_scale, s.occlusion_strength,
                           s.opacity,      s.alpha_cutoff, s.clearcoat,  s.clearcoat_roughness};
  if (!are_finite(numbers) || !are_finite(s.diffuse) || !are_finite(s.specular) || !are_finite(s.emission)) {
    refuse_part("surface", index, "a number is not finite");
  }
}

void check_texture(const Model& model, size_t index) {
  const TextureSource& t = model.textures[index];
  const bool good = t.rgba.empty() || (t.width > 0 && t.height > 0 && t.rgba.size() % 4 == 0 &&
                                       t.rgba.size() / 4 == uint64_t{t.width} * t.height);
  if (!good) refuse_part("texture", index, "its texels do not fit its size");
}

void check_nodes(const Model& model) {
  for (size_t i = 0; i < model.nodes.size(); ++i) {
    const Node& n = model.nodes[i];
    if (n.parent >= static_cast<int64_t>(i)) refuse_part("node", i, "its parent comes later");
    if (!are_finite(n.matrix) || !are_finite(n.translation) || !are_finite(n.rotation) || !are_finite(n.scale) ||
        !are_finite(n.weights)) {
      refuse_part("node", i, "a number is not finite");
    }
  }
  for (size_t i = 0; i < model.skins.size(); ++i) {
    const Skin& skin = model.skins[i];
    bool good = skin.inverse_binds.size() == skin.joints.size();
    for (const uint32_t joint : skin.joints) good = good && joint < model.nodes.size();
    if (!good) refuse_part("skin", i, "its joints are out of range");
  }
}

void check_placements(const Model& model, const Limits& limits) {
  uint64_t instances = 0;
  for (size_t i = 0; i < model.placements.size(); ++i) {
    const Placement& p = model.placements[i];
    if (p.geometry >= model.geometries.size() || p.surface >= model.surfaces.size() || p.node >= model.nodes.size() ||
        p.skin >= static_cast<int64_t>(model.skins.size())) {
      refuse_part("placement", i, "an index is out of range");
    }
    for (const Matrix& copy : p.copies) {
      if (!are_finite(copy)) refuse_part("placement", i, "a matrix is not finite");
    }
    instances += p.copies.empty() ? 1 : p.copies.size();
  }
  check_limit("instances", instances, "max_instances", limits.instances);
}

void check_animations(const Model& model) {
  for (size_t i = 0; i < model.animations.size(); ++i) {
    for (const Channel& channel : model.animations[i].channels) {
      const size_t each = channel.interpolation == Interpolation::kCubicSpline ? 3 : 1;
      const size_t keys = channel.times.size() * each;
      if (!is_one_of(channel.target, Target::kWeights) ||
          !is_one_of(channel.interpolation, Interpolation::kCubicSpline) || channel.node >= model.nodes.size() ||
          keys == 0 || channel.values.size() % keys != 0 || !are_finite(channel.times) || !are_finite(channel.values)) {
        refuse_part("animation", i, "a channel is out of range");
      }
    }
  }
}

template <class Part>
void check_node_of(const char* name, const std::vector<Part>& parts, const Model& model) {
  for (size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].node >= static_cast<int64_t>(model.nodes.size())) refuse_part(name, i, "its node is out of range");
  }
}

}  // namespace

void check_model(const Model& model, const Limits& limits) {
  uint64_t vertices = 0, triangles = 0;
  for (size_t i = 0; i < model.geometries.size(); ++i) {
    check_geometry(model, i);
    vertices += model.geometries[i].position.size() / 3;
    triangles += model.geometries[i].indices.size() / 3;
  }
  check_limit("vertices", vertices, "max_vertices", limits.vertices);
  check_limit("triangles", triangles, "max_triangles", limits.triangles);
  check_limit("nodes", model.nodes.size(), "max_nodes", limits.nodes);
  for (size_t i = 0; i < model.surfaces.size(); ++i) check_surface(model, i);
  for (size_t i = 0; i < model.textures.size(); ++i) check_texture(model, i);
  check_nodes(model);
  check_placements(model, limits);
  check_animations(model);
  check_node_of("light", model.lights, model);
  check_node_of("camera", model.cameras, model);
}

}  // namespace shd::scene
