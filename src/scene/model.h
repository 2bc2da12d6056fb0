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

using Matrix = std::array<double, 16>;  // column-major

constexpr Matrix kIdentity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/// Changes of the vertices of a geometry at weight 1. Each column is empty or has all vertices.
struct MorphTarget {
  std::vector<float> position;  // [vertex][3]
  std::vector<float> normal;    // [vertex][3]
  std::vector<float> tangent;   // [vertex][3]
};

/// Normals of a geometry without a column of them.
enum class Shading : uint32_t {
  kSmooth,  // means over the triangles around a vertex
  kFlat,    // normals of the triangles
};

/// Triangles in object space, counter-clockwise as seen from the front. Indices are below the number of vertices.
/// Positions are finite.
struct Geometry {
  std::string name;
  std::array<double, 3> origin = {0, 0, 0};  // added to all positions
  std::vector<float> position;               // [vertex][3]
  std::vector<float> normal;                 // [vertex][3], or empty; a normal of length 0 or not finite is computed
  std::vector<float> tangent;                // [vertex][4], handedness +1 or -1 last, or empty
  std::vector<float> uv;                     // [vertex][2], v down, or empty
  std::vector<float> uv1;                    // second uv set, as uv
  std::vector<float> color;                  // [vertex][4], linear, multiplies the diffuse colour, or empty
  std::vector<uint16_t> joint;               // [vertex][influence], rows of Skin::joints, or empty
  std::vector<float> weight;                 // [vertex][influence], as joint
  uint32_t influences = 0;                   // a multiple of 4 in glTF
  std::vector<MorphTarget> morphs;
  std::vector<uint32_t> indices;  // [triangle][3]
  Shading shading = Shading::kSmooth;
};

/// Source of a texture: a file, or bytes embedded in the model.
struct TextureSource {
  std::string name;                 // as the model gives it, decoded and trimmed: a file, or a text for messages
  std::string folder;               // folder of a file that is relative to another one: "" or "a/b/" in the model's
  std::vector<unsigned char> file;  // a whole image file in memory, or empty
  std::vector<unsigned char> rgba;  // [height][width][4], sRGB unless data, or empty
  uint32_t width = 0, height = 0;   // size of rgba
  bool data = false;                // numbers, not colours: no sRGB curve
  bool srgb = false;                // colours of PNG, JPEG and WebP files are sRGB, even if a file declares others
};

/// Filter of a texture in a file. kDefault is that of the host's sampler.
enum class Filter : uint32_t { kDefault, kNearest, kLinear };

/// A texture on a surface, with the parameters of a material slot.
struct Map {
  int32_t texture = -1;  // index into Model::textures; -1 = none
  uint32_t uv_set = 0, channel = 0;
  std::array<float, 6> uv_transform = {1, 0, 0, 0, 1, 0};
  int32_t wrap_u = SHD_WRAP_REPEAT, wrap_v = SHD_WRAP_REPEAT;  // shd_wrap
  Filter magnify = Filter::kDefault, minify = Filter::kDefault;
  Filter mip = Filter::kDefault;  // between levels
  bool no_mip = false;            // level 0 alone
};

enum class Alpha : uint32_t { kOpaque, kMask, kBlend };

/// Reflection of dielectrics at normal incidence, at an index of refraction of 1.5.
constexpr float kDielectric = 0.04f;

/// Reflectance, scene-linear. Each map multiplies the coefficient of the same name.
struct Surface {
  std::string name;
  std::array<float, 3> diffuse = {0.8f, 0.8f, 0.8f};  // or base colour
  std::array<float, 3> specular = {0.25f, 0.25f, 0.25f};
  float exponent = 40.0f;
  bool unlit = false;               // diffuse alone, without light
  bool metallic_roughness = false;  // if set, specular and exponent are unused
  /// Set: diffuse, specular and 1 - roughness, each with its map, are those of KHR_materials_pbrSpecularGlossiness;
  /// alpha of the specular map multiplies 1 - roughness. specular_glossiness.h converts them.
  bool specular_glossiness = false;
  float metallic = 0.0f, roughness = 0.5f;
  float ior = 1.5f;
  float transmission = 0.0f;  // share of light that passes, as through glass
  std::array<float, 3> emission = {0, 0, 0};
  float normal_scale = 1.0f, occlusion_strength = 1.0f;
  float bump_scale = 0.0f;  // factor of the height map [its units in world units]; 0 = no bumps
  Alpha alpha = Alpha::kOpaque;
  float opacity = 1.0f;
  float alpha_cutoff = 0.5f;  // cutoff of kMask, at least 0; above 1 hides the surface
  bool double_sided = true;   // if not set, faces seen from behind are not drawn
  float clearcoat = 0.0f, clearcoat_roughness = 0.0f;
  std::array<Map, SHD_SLOT_CLEARCOAT_NORMAL + 1> maps;  // by shd_slot_target
};

/// A place in the tree of the model. Parents come before their children.
struct Node {
  std::string name;
  int32_t parent = -1;        // index of an earlier node; -1 = the world
  Matrix matrix = kIdentity;  // to the parent; used unless `parts`
  bool parts = false;         // translation * rotation * scale
  std::array<double, 3> translation = {0, 0, 0};
  std::array<double, 4> rotation = {0, 0, 0, 1};  // quaternion x, y, z, w
  std::array<double, 3> scale = {1, 1, 1};
  std::vector<float> weights;  // weights of morph targets
};

/// Joints that move the vertices of a geometry.
struct Skin {
  std::vector<uint32_t> joints;       // nodes
  std::vector<Matrix> inverse_binds;  // one for each joint
};

/// A geometry at a node. With a skin its joints place it, and not the node.
struct Placement {
  uint32_t geometry = 0, surface = 0, node = 0;
  int32_t skin = -1;
  std::vector<Matrix> copies;  // to the node, one for each copy; empty = one copy at the node
};

enum class Interpolation : uint32_t { kStep, kLinear, kCubicSpline };
enum class Target : uint32_t { kTranslation, kRotation, kScale, kWeights };

/// Values of one property of a node over time.
struct Channel {
  uint32_t node = 0;
  Target target = Target::kTranslation;
  Interpolation interpolation = Interpolation::kLinear;
  std::vector<float> times;   // [key], seconds, increasing
  std::vector<float> values;  // [key][component]; kCubicSpline: [key][in-tangent, value, out-tangent][component]
};

struct Animation {
  std::string name;
  std::vector<Channel> channels;
};

/// A light. Its position and direction are in the space of `node`, or of the world (-1).
struct NamedLight {
  std::string name;
  shd_light_desc desc;
  int32_t node = -1;
};

/// A camera, in the space of `node` as a light. near_plane and far_plane are 0 if the file has no usable ones.
struct NamedCamera {
  std::string name;
  shd_camera camera;
  int32_t node = -1;
};

/// The contents of a model file. Indices are in range, numbers finite; check_model() throws otherwise.
struct Model {
  std::vector<Geometry> geometries;
  std::vector<Surface> surfaces;
  std::vector<TextureSource> textures;
  std::vector<Node> nodes;
  std::vector<Placement> placements;
  std::vector<Skin> skins;
  std::vector<Animation> animations;
  std::vector<NamedLight> lights;
  std::vector<NamedCamera> cameras;
  std::vector<std::string> warnings;  // one for each feature or part that the picture has not, with its name
};

}  // namespace shd::scene
