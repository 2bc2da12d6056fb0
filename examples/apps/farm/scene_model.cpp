// SPDX-License-Identifier: MIT
// Model files through libshd_scene: their meshes, textures, materials and instances as arrays.
#include <algorithm>
#include <shd.hpp>
#include <stdexcept>

#include "scene_block.h"

namespace farm {

#ifdef FARM_HAS_SCENE
namespace {

/// The index of a texture of the scene among those that can be borrowed, or kNone.
using TextureRows = std::vector<std::pair<const shd_texture*, uint32_t>>;

TextureRows add_textures(const shd_scene* scene, uint32_t count, BlockBuilder* out) {
  TextureRows rows;
  for (uint32_t i = 0; i < count; ++i) {
    const shd_texture* texture = shd_scene_get_texture(scene, i);
    const shd_texture_info info = shd::texture_get_info(texture);
    const uint32_t size = texel_size(info.format);
    if (!size || info.layer_count != 1 || info.depth)
      throw std::runtime_error("a texture of the model has no plain texels");
    std::vector<char> texels(size_t{size} * info.width * info.height);
    shd::image image;
    image.format = info.format, image.width = info.width, image.height = info.height;
    image.pixels = texels.data();
    shd::texture_read_level(texture, 0, 0, &image);
    rows.emplace_back(texture, out->add_texture(info.format, info.width, info.height, texels.data(), texels.size()));
  }
  return rows;
}

void add_materials(const shd_scene* scene, uint32_t count, const TextureRows& rows, BlockBuilder* out) {
  for (uint32_t i = 0; i < count; ++i) {
    shd::material_desc desc;
    shd::check(shd_scene_get_material_desc(scene, i, &desc));
    const uint32_t material = out->add_material(desc);
    for (uint32_t s = 0; s < desc.slot_count; ++s) {
      const shd_slot& slot = desc.slots[s];
      const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r.first == slot.texture; });
      out->set_slot(material, slot, row == rows.end() ? kNone : row->second);
    }
  }
}

}  // namespace

void add_model(shd_context* context, const std::string& path, BlockBuilder* out) {
  const shd::scene scene = shd::scene_load(context, path.c_str(), nullptr);
  const shd_scene_info info = shd::scene_get_info(scene);
  const TextureRows rows = add_textures(scene, info.texture_count, out);
  add_materials(scene, info.material_count, rows, out);
  for (uint32_t i = 0; i < info.mesh_count; ++i) out->add_mesh(shd_scene_get_mesh(scene, i), true);
  for (uint32_t i = 0; i < info.instance_count; ++i) {
    shd::scene_instance instance;
    shd::check(shd_scene_get_instance(scene, i, &instance));
    out->add_draw(instance.mesh, instance.material, instance.object_to_world);
  }
  std::copy_n(info.bounds_min, 3, out->bounds_min);
  std::copy_n(info.bounds_max, 3, out->bounds_max);
}

#else

void add_model(shd_context*, const std::string& path, BlockBuilder*) {
  throw std::runtime_error(path + ": built without libshd_scene, only the scene made in code is there");
}

#endif

}  // namespace farm
