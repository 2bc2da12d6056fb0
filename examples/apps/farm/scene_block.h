// SPDX-License-Identifier: MIT
// A scene as one block of memory without pointers, so that all ranks of a node read one copy of its arrays.
#ifndef SHD_FARM_SCENE_BLOCK_H
#define SHD_FARM_SCENE_BLOCK_H

#include <shd/shd.h>

#include <cstdint>
#include <string>
#include <vector>

#include "options.h"

namespace farm {

constexpr uint32_t kSlots = 16, kNone = 0xffffffffu;

/// Offsets count bytes from the beginning of the block; 0 = absent.
struct BlockMesh {
  uint64_t position[3], normal[3], tangent[4], uv[2], indices;
  uint32_t vertex_count, index_count;
};
struct BlockTexture {
  uint64_t texels;  // followed by SHD_TEXTURE_PADDING bytes
  uint32_t format, width, height, reserved;
};
struct BlockMaterial {
  shd_material_desc desc;  // pointers are NULL
  shd_slot slots[kSlots];  // handles are NULL
  uint32_t texture[kSlots];
  uint32_t slot_count, reserved;
};
struct BlockDraw {
  float object_to_world[16];
  uint32_t mesh, material;
};
struct BlockHead {
  uint64_t bytes, meshes, textures, materials, draws;  // offsets of the tables
  uint32_t mesh_count, texture_count, material_count, draw_count;
  float bounds_min[3], bounds_max[3];  // box of the models without the floor
};

/// Grows a block. Tables are kept apart until finish() appends them.
struct BlockBuilder {
  std::vector<char> bytes = std::vector<char>(sizeof(BlockHead));
  std::vector<BlockMesh> meshes;
  std::vector<BlockTexture> textures;
  std::vector<BlockMaterial> materials;
  std::vector<BlockDraw> draws;
  float bounds_min[3] = {0, 0, 0}, bounds_max[3] = {0, 0, 0};

  /// Appends zeros at a multiple of 64 bytes, and returns their offset.
  uint64_t allocate(uint64_t size);
  uint64_t append(const void* data, uint64_t size);
  template <class T>
  T* at(uint64_t offset) {
    return reinterpret_cast<T*>(bytes.data() + offset);
  }
  /// Copies the arrays of a mesh; returns its index.
  uint32_t add_mesh(const shd_mesh* mesh, bool tangents);
  uint32_t add_texture(shd_format format, uint32_t width, uint32_t height, const void* texels, uint64_t size);
  uint32_t add_material(const shd_material_desc& desc);
  void set_slot(uint32_t material, const shd_slot& slot, uint32_t texture);
  void add_draw(uint32_t mesh, uint32_t material, const float object_to_world[16]);
  std::vector<char> finish();
};

/// The scene of the options: a model file, or a scene made in code. Throws std::runtime_error.
std::vector<char> make_scene_block(shd_context* context, const Options& options);

void add_model(shd_context* context, const std::string& path, BlockBuilder* out);
void add_shapes(shd_context* context, BlockBuilder* out);

/// Size in bytes of a texel of an uncompressed format.
uint32_t texel_size(shd_format format);

}  // namespace farm

#endif  // SHD_FARM_SCENE_BLOCK_H
