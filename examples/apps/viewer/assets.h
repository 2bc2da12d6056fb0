// SPDX-License-Identifier: MIT
/// Meshes, textures and materials of a model: those of a file, or a shape with computed textures.
#pragma once
#include <string>
#include <vector>

#include <shd.hpp>

#include "state.h"

namespace viewer {

/// A mesh in the world. `surface` is an index of Assets::surfaces.
struct Part {
  shd_mesh* mesh = nullptr;  // borrowed from Assets
  std::array<float, 16> object_to_world = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  size_t surface = 0;
};

/// Wraps of the two axes of a slot's texture.
struct Wraps {
  shd_wrap u = SHD_WRAP_REPEAT, v = SHD_WRAP_REPEAT;
  auto tie() const { return std::tie(u, v); }
};

/// A material before the settings of a side change it.
struct SurfaceAsset {
  std::string name;
  shd::material_desc desc;
  std::vector<shd_slot> slots;  // `desc.slots` is unused
  std::vector<Wraps> wraps;     // one for each slot
  bool is_floor = false;
};

struct Assets {
  shd::scene scene;  // scene of a file; null for shapes
  std::vector<shd::mesh> meshes;
  std::vector<shd::texture> textures;
  std::vector<SurfaceAsset> surfaces;
  std::vector<Part> parts;
  Bounds bounds;
  uint64_t triangles = 0;
  bool from_file = false;
  std::vector<std::string> warnings;
};

/// Loads or makes everything. Throws shd::error for a file that cannot be read.
Assets make_assets(shd_context* context, const Content& content, shd_table_flags tables);

/// Wraps with which a sampler of SHD_FILTER_NEAREST reads a texture, found by lookups left of and above it.
Wraps wraps_of(const shd_texture* texture, const shd_sampler* sampler);

}  // namespace viewer
