// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scene/limits.h"
#include "scene/model.h"
#include "scene/owned.h"

namespace shd::scene {

/// Base colour and metallic factor of a metallic-roughness material.
struct BaseMetal {
  std::array<float, 3> base;
  float metallic;
};

/// The conversion of the appendix of KHR_materials_pbrSpecularGlossiness. That one has the diffuse colour of glTF
/// before 2.0.1; here base (1 - metallic) = diffuse (1 - max(specular)) (glTF 2.0, appendix B). Colours are linear, in
/// 0..1.
BaseMetal convert_specular(const std::array<float, 3>& diffuse, const std::array<float, 3>& specular);

/// State of a load of textures.
struct TextureLoad {
  shd_context* context;
  shd_table_flags tables;
  const Limits& limits;
  const Deadline& deadline;
  uint64_t bytes = 0;  // sum of all textures so far
  std::vector<Texture> textures;
  std::vector<std::string> names;  // [textures]
};

/// Adds a texture, which may be empty. Throws Failure if all exceed the budget.
void add_texture(TextureLoad& load, Texture&& texture, const std::string& name);

/// Makes metallic-roughness surfaces of those with `specular_glossiness`. Their maps become new textures; a surface
/// whose maps differ in their coordinates loses one with a warning. Throws Failure.
void convert_surfaces(TextureLoad& load, Model& model, std::vector<std::string>* warnings);

}  // namespace shd::scene
