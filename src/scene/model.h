// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <shd/light.h>
#include <shd/slot.h>
#include <shd/view.h>

namespace shd::scene {

/// Triangles in object space, counter-clockwise as seen from the front. Positions are finite.
struct Geometry {
  std::string name;
  std::vector<float> position;    // [vertex][3]
  std::vector<float> normal;      // [vertex][3], or empty: computed by shd
  std::vector<float> uv;          // [vertex][2], v down, or empty
  std::vector<float> uv1;         // second uv set, as uv
  std::vector<uint32_t> indices;  // [triangle][3]
};

/// Source of a texture: a file, or bytes embedded in the model.
struct TextureSource {
  std::string path;                 // file to load, or the name of an embedded texture
  std::vector<unsigned char> file;  // a whole image file in memory, or empty
  std::vector<unsigned char> rgba;  // [height][width][4], sRGB unless data, or empty
  uint32_t width = 0, height = 0;   // size of rgba
  bool data = false;                // numbers, not colours: no sRGB curve
};

/// A texture on a surface, with the parameters of a material slot.
struct Map {
  int texture = -1;  // index into Model::textures; -1 = none
  uint32_t uv_set = 0, channel = 0;
  std::array<float, 6> uv_transform = {1, 0, 0, 0, 1, 0};
  int wrap_u = 0, wrap_v = 0;  // shd_wrap
};

enum class Alpha { kOpaque, kMask, kBlend };

/// Reflectance, scene-linear. Each map multiplies the coefficient of the same name.
struct Surface {
  std::string name;
  std::array<float, 3> diffuse = {0.8f, 0.8f, 0.8f};  // or base colour
  std::array<float, 3> specular = {0.25f, 0.25f, 0.25f};
  float exponent = 40.0f;
  bool metallic_roughness = false;  // if set, specular and exponent are unused
  float metallic = 0.0f, roughness = 0.5f;
  std::array<float, 3> emission = {0, 0, 0};
  float normal_scale = 1.0f, occlusion_strength = 1.0f;
  Alpha alpha = Alpha::kOpaque;
  float opacity = 1.0f, alpha_cutoff = 0.5f;
  bool double_sided = false;
  float clearcoat = 0.0f, clearcoat_roughness = 0.0f;
  std::array<Map, SHD_SLOT_CLEARCOAT_NORMAL + 1> maps;  // by shd_slot_target
};

/// A geometry placed in the world.
struct Instance {
  size_t geometry = 0, surface = 0;
  std::array<float, 16> object_to_world = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};  // column-major
};

struct NamedLight {
  std::string name;
  shd_light_desc desc;
};

/// near_plane and far_plane are 0 if the file has no usable ones.
struct NamedCamera {
  std::string name;
  shd_camera camera;
};

struct Model {
  std::vector<Geometry> geometries;
  std::vector<Surface> surfaces;
  std::vector<TextureSource> textures;
  std::vector<Instance> instances;
  std::vector<NamedLight> lights;
  std::vector<NamedCamera> cameras;
  std::vector<std::string> warnings;
};

}  // namespace shd::scene
