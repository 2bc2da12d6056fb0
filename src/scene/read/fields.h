// SPDX-License-Identifier: MIT
#pragma once

#include "scene/limits.h"
#include "scene/model.h"

/// The fields of a Model in their order in a stream: one list for writing and reading. A structured binding names every
/// field of its struct, so that a new field does not compile until it is in its list. Pointers are never in a stream.
namespace shd::scene {

/// Visits the values of `parts` in turn.
template <class Visitor, class... Part>
void visit_each(Visitor& visit, Part&... parts) {
  (visit(parts), ...);
}

template <class Visitor>
void fields(Visitor& v, MorphTarget& in) {
  auto& [position, normal, tangent] = in;
  visit_each(v, position, normal, tangent);
}

template <class Visitor>
void fields(Visitor& v, Geometry& in) {
  auto& [name, origin, position, normal, tangent, uv, uv1, color, joint, weight, influences, morphs, indices, shading] =
      in;
  visit_each(v, name, origin, position, normal, tangent, uv, uv1, color, joint, weight, influences, morphs, indices,
             shading);
}

template <class Visitor>
void fields(Visitor& v, TextureSource& in) {
  auto& [name, folder, file, rgba, width, height, data, srgb] = in;
  visit_each(v, name, folder, file, rgba, width, height, data, srgb);
}

template <class Visitor>
void fields(Visitor& v, Map& in) {
  auto& [texture, uv_set, channel, uv_transform, wrap_u, wrap_v, magnify, minify, mip, no_mip] = in;
  visit_each(v, texture, uv_set, channel, uv_transform, wrap_u, wrap_v, magnify, minify, mip, no_mip);
}

template <class Visitor>
void fields(Visitor& v, Surface& in) {
  auto& [name, diffuse, specular, exponent, unlit, metallic_roughness, specular_glossiness, metallic, roughness, ior,
         transmission, emission, normal_scale, occlusion_strength, bump_scale, alpha, opacity, alpha_cutoff,
         double_sided, clearcoat, clearcoat_roughness, maps] = in;
  visit_each(v, name, diffuse, specular, exponent, unlit, metallic_roughness, specular_glossiness, metallic, roughness,
             ior, transmission, emission, normal_scale, occlusion_strength, bump_scale, alpha, opacity, alpha_cutoff,
             double_sided, clearcoat, clearcoat_roughness, maps);
}

template <class Visitor>
void fields(Visitor& v, Node& in) {
  auto& [name, parent, matrix, parts, translation, rotation, scale, weights] = in;
  visit_each(v, name, parent, matrix, parts, translation, rotation, scale, weights);
}

template <class Visitor>
void fields(Visitor& v, Skin& in) {
  auto& [joints, inverse_binds] = in;
  visit_each(v, joints, inverse_binds);
}

template <class Visitor>
void fields(Visitor& v, Placement& in) {
  auto& [geometry, surface, node, skin, copies] = in;
  visit_each(v, geometry, surface, node, skin, copies);
}

template <class Visitor>
void fields(Visitor& v, Channel& in) {
  auto& [node, target, interpolation, times, values] = in;
  visit_each(v, node, target, interpolation, times, values);
}

template <class Visitor>
void fields(Visitor& v, Animation& in) {
  auto& [name, channels] = in;
  visit_each(v, name, channels);
}

template <class Visitor>
void fields(Visitor& v, shd_light_desc& in) {
  auto& [struct_size, kind, intensity, position, direction, range, inner_angle, outer_angle, up, extent, texture,
         sampler] = in;
  struct_size = sizeof in;
  visit_each(v, kind, intensity, position, direction, range, inner_angle, outer_angle, up, extent);
}

template <class Visitor>
void fields(Visitor& v, NamedLight& in) {
  auto& [name, desc, node] = in;
  visit_each(v, name, desc, node);
}

template <class Visitor>
void fields(Visitor& v, shd_camera& in) {
  auto& [struct_size, eye, target, up, fov_y, aspect, near_plane, far_plane] = in;
  struct_size = sizeof in;
  visit_each(v, eye, target, up, fov_y, aspect, near_plane, far_plane);
}

template <class Visitor>
void fields(Visitor& v, NamedCamera& in) {
  auto& [name, camera, node] = in;
  visit_each(v, name, camera, node);
}

template <class Visitor>
void fields(Visitor& v, Model& in) {
  auto& [geometries, surfaces, textures, nodes, placements, skins, animations, lights, cameras, warnings] = in;
  visit_each(v, geometries, surfaces, textures, nodes, placements, skins, animations, lights, cameras, warnings);
}

template <class Visitor>
void fields(Visitor& v, Limits& in) {
  auto& [file_bytes, vertices, triangles, nodes, instances, texture_bytes, reader_bytes, seconds] = in;
  visit_each(v, file_bytes, vertices, triangles, nodes, instances, texture_bytes, reader_bytes, seconds);
}

/// The request to the module of the readers.
struct ReadRequest {
  std::string version;  // version of shd: both ends are of one build
  std::string name;     // name of the model file, without folders
  Limits limits;
};

template <class Visitor>
void fields(Visitor& v, ReadRequest& in) {
  auto& [version, name, limits] = in;
  visit_each(v, version, name, limits);
}

}  // namespace shd::scene
