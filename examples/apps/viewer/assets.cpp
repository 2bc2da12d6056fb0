// SPDX-License-Identifier: MIT
#include "assets.h"

#include <algorithm>
#include <cmath>

#include <shd/io.h>
#include <shd/scene.h>

#include "occlusion.h"
#include "patterns.h"

namespace viewer {
namespace {

constexpr float kFloorSize = 120.0f;     // [radii]
constexpr float kTilesPerRadius = 0.5f;  // repeats of the texture

shd_texture* load_texture(shd_context* context, const std::string& name, shd_table_flags tables, Assets& assets) {
  if (name == "none") return nullptr;
  if (name == "porcelain" || name == "default") {
    assets.textures.push_back(make_porcelain(context, tables));
  } else if (name == "tiles") {
    assets.textures.push_back(make_tiles(context, tables));
  } else {
    shd::load_desc desc;
    desc.tables = tables;
    assets.textures.push_back(shd::texture_load(context, name.c_str(), &desc));
  }
  return assets.textures.back();
}

void set_diffuse(SurfaceAsset& surface, shd_texture* texture) {
  surface.slots.clear();
  surface.wraps.clear();
  if (!texture) return;
  surface.slots.push_back(shd_slot_texture(SHD_SLOT_DIFFUSE, texture, nullptr));
  surface.wraps.emplace_back();
}

void add_shape(shd_context* context, shd_shape shape, Assets& assets) {
  shd::shape_desc desc;
  desc.kind = shape;
  desc.segments[0] = shape == SHD_SHAPE_TEAPOT ? 24 : shape == SHD_SHAPE_BOX || shape == SHD_SHAPE_PLANE ? 0 : 128;
  desc.segments[1] = shape == SHD_SHAPE_SPHERE || shape == SHD_SHAPE_TORUS ? 64 : 0;
  assets.meshes.push_back(shd::mesh_create_shape(context, &desc, SHD_MESH_TANGENTS));
  Part part;
  part.mesh = assets.meshes.back();
  assets.parts.push_back(part);
  SurfaceAsset surface;
  surface.name = shape == SHD_SHAPE_TEAPOT ? "teapot" : "shape";
  surface.desc.ambient_share = 1.0f;
  surface.desc.flags = SHD_MATERIAL_DOUBLE_SIDED;
  assets.surfaces.push_back(surface);
}

void add_scene(shd_context* context, const std::string& path, shd_table_flags tables, Assets& assets) {
  shd::sampler_desc nearest;
  nearest.filter = SHD_FILTER_NEAREST;  // wraps_of() needs it; each side has a sampler of its own
  shd::load_desc texture;
  texture.tables = tables;
  shd::scene_desc desc;
  desc.sampler = &nearest;
  desc.texture = &texture;
  assets.scene = shd::scene_load(context, path.c_str(), &desc);
  assets.from_file = true;
  const shd_scene_info info = shd::scene_get_info(assets.scene);
  for (uint32_t i = 0; i < info.warning_count; ++i) assets.warnings.push_back(shd_scene_get_warning(assets.scene, i));
  for (uint32_t i = 0; i < info.material_count; ++i) {
    SurfaceAsset surface;
    surface.name = shd_scene_get_name(assets.scene, SHD_SCENE_PART_MATERIAL, i);
    surface.desc = shd::scene_get_material_desc(assets.scene, i);
    for (uint32_t k = 0; k < surface.desc.slot_count; ++k) {
      const shd_slot& slot = surface.desc.slots[k];
      surface.slots.push_back(slot);
      surface.wraps.push_back(slot.texture && slot.sampler ? wraps_of(slot.texture, slot.sampler) : Wraps());
    }
    assets.surfaces.push_back(surface);
  }
  for (uint32_t i = 0; i < info.instance_count; ++i) {
    const shd_scene_instance instance = shd::scene_get_instance(assets.scene, i);
    Part part;
    part.mesh = shd_scene_get_mesh(assets.scene, instance.mesh);
    part.surface = instance.material;
    std::copy(instance.object_to_world, instance.object_to_world + 16, part.object_to_world.begin());
    assets.parts.push_back(part);
  }
}

/// Sphere around the box of the vertices of shapes, whose matrices are the identity, or around the box of a file.
Bounds bounds_of(const Assets& assets) {
  float low[3] = {HUGE_VALF, HUGE_VALF, HUGE_VALF}, high[3] = {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF};
  if (assets.scene) {
    const shd_scene_info info = shd::scene_get_info(assets.scene);
    std::copy(info.bounds_min, info.bounds_min + 3, low);
    std::copy(info.bounds_max, info.bounds_max + 3, high);
  }
  for (const shd::mesh& mesh : assets.meshes) {
    const shd_mesh_info info = shd::mesh_get_info(mesh);
    for (size_t c = 0; c < 3; ++c) {
      low[c] = std::min(low[c], info.bounds_min[c]);
      high[c] = std::max(high[c], info.bounds_max[c]);
    }
  }
  Bounds bounds;
  float diagonal = 0.0f;
  for (size_t c = 0; c < 3; ++c) {
    bounds.center[c] = 0.5f * (low[c] + high[c]);
    diagonal = std::hypot(diagonal, high[c] - low[c]);
  }
  bounds.radius = std::max(0.5f * diagonal, 1e-6f);
  bounds.bottom = low[1];
  return bounds;
}

/// A square of triangles that are small near the centre, where occlusion varies.
shd::mesh make_floor(shd_context* context, float half) {
  constexpr uint32_t kSide = 129;
  std::vector<std::array<float, 8>> vertices;
  std::vector<uint32_t> indices;
  const float repeats = 0.5f * kFloorSize * kTilesPerRadius;  // repeats of the texture from the middle to an edge
  const auto place = [half](uint32_t i) {
    const float t = 2.0f * float(i) / (kSide - 1) - 1.0f;
    return half * t * t * t;
  };
  for (uint32_t row = 0; row < kSide; ++row) {
    for (uint32_t column = 0; column < kSide; ++column) {
      const float x = place(column), z = place(row);
      vertices.push_back({x, 0, z, 0, 1, 0, 0.5f + repeats * x / half, 0.5f + repeats * z / half});
      const uint32_t i = row * kSide + column;
      if (row + 1 < kSide && column + 1 < kSide) {
        indices.insert(indices.end(), {i, i + kSide, i + 1, i + 1, i + kSide, i + kSide + 1});
      }
    }
  }
  shd::mesh_desc desc;
  desc.vertex_count = kSide * kSide;
  for (size_t c = 0; c < 8; ++c) {
    shd_f32_in& column = c < 3 ? desc.position[c] : c < 6 ? desc.normal[c - 3] : desc.uv[c - 6];
    column = shd_f32_column(&vertices[0][c], sizeof vertices[0]);
  }
  desc.indices = shd_u32_column(indices.data(), 0);
  desc.index_count = indices.size();
  return shd::mesh_create(context, &desc);
}

void add_floor(shd_context* context, shd_table_flags tables, Assets& assets) {
  const Bounds& bounds = assets.bounds;
  assets.meshes.push_back(make_floor(context, 0.5f * kFloorSize * bounds.radius));
  Part part;
  part.mesh = assets.meshes.back();
  part.surface = assets.surfaces.size();
  part.object_to_world[12] = bounds.center[0];
  part.object_to_world[13] = bounds.bottom - 1e-4f * bounds.radius;
  part.object_to_world[14] = bounds.center[2];
  assets.parts.push_back(part);
  SurfaceAsset surface;
  surface.name = "floor";
  surface.is_floor = true;
  surface.desc.model = SHD_MODEL_METALLIC_ROUGHNESS;
  surface.desc.ambient_share = 1.0f;
  surface.desc.roughness = 0.55f;
  for (float& c : surface.desc.diffuse) c = 1.0f;
  assets.textures.push_back(make_tiles(context, tables));
  set_diffuse(surface, assets.textures.back());
  assets.surfaces.push_back(surface);
}

}  // namespace

Wraps wraps_of(const shd_texture* texture, const shd_sampler* sampler) {
  const shd_texture_info info = shd::texture_get_info(texture);
  const auto wrap_of = [&](float u, float v, uint32_t size, uint32_t shd_tap::*index) {
    shd::lookups lookups;
    lookups.count = 1;
    lookups.u = shd_f32_column(&u, 0), lookups.v = shd_f32_column(&v, 0);
    shd_tap tap = {};
    shd::explanation explanation;
    explanation.taps = &tap, explanation.tap_capacity = 1;
    if (size < 4 || info.depth || shd_texture_explain(texture, sampler, &lookups, 0, &explanation) != SHD_OK) {
      return SHD_WRAP_REPEAT;
    }
    if (tap.border) return SHD_WRAP_BORDER;
    if (tap.*index >= size / 2) return SHD_WRAP_REPEAT;
    return tap.*index == 0 ? SHD_WRAP_CLAMP : SHD_WRAP_MIRROR;
  };
  // A quarter left of the texture: the right half with repeat, column 0 with clamp, column size / 4 with mirror.
  return {wrap_of(-0.25f, 0.5f, info.width, &shd_tap::x), wrap_of(0.5f, -0.25f, info.height, &shd_tap::y)};
}

Assets make_assets(shd_context* context, const Content& content, shd_table_flags tables) {
  Assets assets;
  if (const auto shape = shape_of(content.model)) {
    add_shape(context, *shape, assets);
    set_diffuse(assets.surfaces[0], load_texture(context, content.texture, tables, assets));
  } else {
    add_scene(context, content.model, tables, assets);
    if (content.texture != "default") {
      shd_texture* const texture = load_texture(context, content.texture, tables, assets);
      for (SurfaceAsset& surface : assets.surfaces) set_diffuse(surface, texture);
    }
  }
  assets.bounds = bounds_of(assets);
  if (content.floor) add_floor(context, tables, assets);
  if (content.occlusion) add_occlusion(context, assets);
  for (const Part& part : assets.parts) assets.triangles += shd::mesh_get_info(part.mesh).triangle_count;
  return assets;
}

}  // namespace viewer
