// SPDX-License-Identifier: MIT
#include "scene_block.h"

#include <algorithm>
#include <cstring>
#include <shd.hpp>

namespace farm {
namespace {

template <class T>
uint64_t append_table(BlockBuilder* block, const std::vector<T>& rows) {
  return block->append(rows.data(), rows.size() * sizeof(T));
}

/// Repeats all draws in a square of places, and moves the bounds along.
void repeat_draws(BlockBuilder* block, uint32_t copies) {
  const std::vector<BlockDraw> first = block->draws;
  const float step_x = 1.1f * (block->bounds_max[0] - block->bounds_min[0]);
  const float step_z = 1.1f * (block->bounds_max[2] - block->bounds_min[2]);
  block->draws.clear();
  for (uint32_t i = 0; i < copies * copies; ++i) {
    for (BlockDraw draw : first) {
      draw.object_to_world[12] += step_x * static_cast<float>(i % copies);
      draw.object_to_world[14] += step_z * static_cast<float>(i / copies);
      block->draws.push_back(draw);
    }
  }
  block->bounds_max[0] += step_x * static_cast<float>(copies - 1);
  block->bounds_max[2] += step_z * static_cast<float>(copies - 1);
}

uint32_t add_tiles(BlockBuilder* block) {
  constexpr uint32_t kEdge = 256;
  std::vector<uint8_t> texels(size_t{4} * kEdge * kEdge, 255);
  uint32_t random = 1;
  for (uint32_t y = 0; y < kEdge; ++y) {
    for (uint32_t x = 0; x < kEdge; ++x) {
      random = random * 1664525u + 1013904223u;
      const bool joint = x % 128 < 4 || y % 128 < 4, odd = (x / 128 + y / 128) % 2;
      const uint8_t grain = static_cast<uint8_t>(random >> 28);
      const uint8_t color[3] = {static_cast<uint8_t>(joint ? 60
                                                     : odd ? 190
                                                           : 150),
                                static_cast<uint8_t>(joint ? 58
                                                     : odd ? 182
                                                           : 136),
                                static_cast<uint8_t>(joint ? 54
                                                     : odd ? 170
                                                           : 118)};
      for (size_t c = 0; c < 3; ++c) texels[4 * (size_t{y} * kEdge + x) + c] = static_cast<uint8_t>(color[c] + grain);
    }
  }
  return block->add_texture(SHD_FORMAT_RGBA8_SRGB, kEdge, kEdge, texels.data(), texels.size());
}

/// A tiled plane below the models, four times as wide as they are.
void add_floor(shd_context* context, BlockBuilder* block) {
  const float width =
      std::max(block->bounds_max[0] - block->bounds_min[0], block->bounds_max[2] - block->bounds_min[2]);
  shd::shape_desc plane;
  plane.kind = SHD_SHAPE_PLANE;
  plane.size[0] = plane.size[2] = 4.0f * width;
  const shd::mesh mesh = shd::mesh_create_shape(context, &plane, SHD_MESH_NONE);
  shd_slot slot = shd_slot_texture(SHD_SLOT_DIFFUSE, nullptr, nullptr);
  slot.uv_transform[0] = slot.uv_transform[4] = 24.0f;
  shd::material_desc desc;
  desc.diffuse[0] = desc.diffuse[1] = desc.diffuse[2] = 0.7f;
  desc.ambient_share = 1.0f;
  const uint32_t material = block->add_material(desc);
  block->set_slot(material, slot, add_tiles(block));
  float place[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  place[12] = 0.5f * (block->bounds_min[0] + block->bounds_max[0]);
  place[13] = block->bounds_min[1];
  place[14] = 0.5f * (block->bounds_min[2] + block->bounds_max[2]);
  block->add_draw(block->add_mesh(mesh, false), material, place);
}

}  // namespace

uint32_t texel_size(shd_format format) {
  switch (format) {
    case SHD_FORMAT_R8: return 1;
    case SHD_FORMAT_RGBA16: return 8;
    case SHD_FORMAT_RGBA16F: return 8;
    case SHD_FORMAT_RGBA32F: return 16;
    case SHD_FORMAT_RGBA8:
    case SHD_FORMAT_RGBA8_SRGB: return 4;
    default: return 0;
  }
}

uint64_t BlockBuilder::allocate(uint64_t size) {
  const uint64_t offset = (bytes.size() + 63) / 64 * 64;
  bytes.resize(offset + size);
  return offset;
}

uint64_t BlockBuilder::append(const void* data, uint64_t size) {
  const uint64_t offset = allocate(size);
  if (size) std::memcpy(bytes.data() + offset, data, size);
  return offset;
}

uint32_t BlockBuilder::add_mesh(const shd_mesh* mesh, bool tangents) {
  const shd_mesh_info info = shd::mesh_get_info(mesh);
  const size_t vertices = info.vertex_count;
  BlockMesh row{};
  row.vertex_count = info.vertex_count;
  row.index_count = 3 * info.triangle_count;
  const auto copy = [&](uint64_t* offsets, size_t columns, auto read) {
    std::vector<float> values(columns * vertices);
    shd_f32_out out[4];
    for (size_t c = 0; c < columns; ++c) out[c] = shd_f32_out_column(values.data() + c * vertices, 0);
    read(mesh, out);
    for (size_t c = 0; c < columns; ++c) offsets[c] = append(values.data() + c * vertices, vertices * sizeof(float));
  };
  copy(row.position, 3, [](auto... a) { shd::check(shd_mesh_read_positions(a...)); });
  copy(row.normal, 3, [](auto... a) { shd::check(shd_mesh_read_normals(a...)); });
  copy(row.uv, 2, [](auto... a) { shd::check(shd_mesh_read_uv(a...)); });
  if (tangents) copy(row.tangent, 4, [](auto... a) { shd::check(shd_mesh_read_tangents(a...)); });
  std::vector<uint32_t> indices(row.index_count);
  const shd_u32_out out = shd_u32_out_column(indices.data(), 0);
  shd::check(shd_mesh_read_indices(mesh, &out));
  row.indices = append(indices.data(), indices.size() * sizeof(uint32_t));
  meshes.push_back(row);
  return static_cast<uint32_t>(meshes.size() - 1);
}

uint32_t BlockBuilder::add_texture(shd_format format, uint32_t width, uint32_t height, const void* texels,
                                   uint64_t size) {
  BlockTexture row{};
  row.texels = allocate(size + SHD_TEXTURE_PADDING);
  std::memcpy(bytes.data() + row.texels, texels, size);
  row.format = static_cast<uint32_t>(format), row.width = width, row.height = height;
  textures.push_back(row);
  return static_cast<uint32_t>(textures.size() - 1);
}

uint32_t BlockBuilder::add_material(const shd_material_desc& desc) {
  BlockMaterial row;
  std::memset(static_cast<void*>(&row), 0, sizeof row);
  std::memcpy(static_cast<void*>(&row.desc), &desc, sizeof desc);
  row.desc.slots = nullptr, row.desc.slot_count = 0;
  materials.push_back(row);
  return static_cast<uint32_t>(materials.size() - 1);
}

void BlockBuilder::set_slot(uint32_t material, const shd_slot& slot, uint32_t texture) {
  BlockMaterial& row = materials[material];
  if (row.slot_count == kSlots) return;
  shd_slot& copy = row.slots[row.slot_count];
  std::memcpy(static_cast<void*>(&copy), &slot, sizeof slot);
  copy.texture = nullptr, copy.sampler = nullptr;
  row.texture[row.slot_count++] = texture;
}

void BlockBuilder::add_draw(uint32_t mesh, uint32_t material, const float object_to_world[16]) {
  BlockDraw row{};
  std::copy_n(object_to_world, 16, row.object_to_world);
  row.mesh = mesh, row.material = material;
  draws.push_back(row);
}

std::vector<char> BlockBuilder::finish() {
  BlockHead head{};
  head.meshes = append_table(this, meshes);
  head.textures = append_table(this, textures);
  head.materials = append_table(this, materials);
  head.draws = append_table(this, draws);
  head.mesh_count = static_cast<uint32_t>(meshes.size());
  head.texture_count = static_cast<uint32_t>(textures.size());
  head.material_count = static_cast<uint32_t>(materials.size());
  head.draw_count = static_cast<uint32_t>(draws.size());
  std::copy_n(bounds_min, 3, head.bounds_min);
  std::copy_n(bounds_max, 3, head.bounds_max);
  head.bytes = bytes.size();
  std::memcpy(bytes.data(), &head, sizeof head);
  return std::move(bytes);
}

std::vector<char> make_scene_block(shd_context* context, const Options& options) {
  BlockBuilder block;
  if (options.model.empty()) {
    add_shapes(context, &block);
  } else {
    add_model(context, options.model, &block);
  }
  repeat_draws(&block, options.copies);
  add_floor(context, &block);
  return block.finish();
}

}  // namespace farm
