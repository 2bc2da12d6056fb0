// SPDX-License-Identifier: MIT
// A scene made in code: a teapot, a torus and a sphere with a pattern each.
#include <algorithm>
#include <cmath>
#include <shd.hpp>

#include "scene_block.h"

namespace farm {
namespace {

constexpr uint32_t kEdge = 512;

/// Bands that waves bend, in two colours.
uint32_t add_pattern(BlockBuilder* out, const uint8_t (&light)[3], const uint8_t (&dark)[3], int waves) {
  std::vector<uint8_t> texels(size_t{4} * kEdge * kEdge, 255);
  for (uint32_t y = 0; y < kEdge; ++y) {
    for (uint32_t x = 0; x < kEdge; ++x) {
      // A triangle wave in whole numbers has the same texels on every machine.
      const uint32_t bend = (y * static_cast<uint32_t>(waves)) % kEdge;
      const uint32_t place = (8 * x + std::min(bend, kEdge - bend)) % kEdge;
      const uint8_t* color = place < kEdge / 2 ? light : dark;
      for (size_t c = 0; c < 3; ++c) texels[4 * (size_t{y} * kEdge + x) + c] = color[c];
    }
  }
  return out->add_texture(SHD_FORMAT_RGBA8_SRGB, kEdge, kEdge, texels.data(), texels.size());
}

void add_shape(shd_context* context, BlockBuilder* out, shd_shape shape, float x, float y, uint32_t texture) {
  shd::shape_desc desc;
  desc.kind = shape;
  desc.segments[0] = shape == SHD_SHAPE_TEAPOT ? 24 : 96;
  desc.segments[1] = shape == SHD_SHAPE_TEAPOT ? 0 : 48;
  const shd::mesh mesh = shd::mesh_create_shape(context, &desc, SHD_MESH_NONE);
  shd::material_desc material;
  material.model = SHD_MODEL_BLINN_PHONG;
  material.ambient_share = 1.0f;
  const uint32_t row = out->add_material(material);
  out->set_slot(row, shd_slot_texture(SHD_SLOT_DIFFUSE, nullptr, nullptr), texture);
  const float place[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, 0, 1};
  out->add_draw(out->add_mesh(mesh, false), row, place);
}

}  // namespace

void add_shapes(shd_context* context, BlockBuilder* out) {
  add_shape(context, out, SHD_SHAPE_TEAPOT, 0.0f, 0.0f, add_pattern(out, {235, 228, 210}, {40, 70, 130}, 3));
  add_shape(context, out, SHD_SHAPE_TORUS, 5.2f, 0.25f, add_pattern(out, {226, 170, 60}, {120, 40, 30}, 7));
  add_shape(context, out, SHD_SHAPE_SPHERE, -4.6f, 1.0f, add_pattern(out, {200, 220, 205}, {30, 100, 70}, 5));
  const float low[3] = {-5.6f, 0.0f, -2.0f}, high[3] = {6.5f, 3.15f, 2.0f};
  std::copy_n(low, 3, out->bounds_min);
  std::copy_n(high, 3, out->bounds_max);
}

}  // namespace farm
