// SPDX-License-Identifier: MIT
#include "tool/reports.h"

#include <cstdio>
#include <string>
#include <vector>

#include "command/failure.h"
#include "tool/materials.h"

namespace {

/// Reports the lights and cameras of the file that the options leave out.
void report_unused(const Options& options, const Model& model) {
  shd_scene_info info = shd_scene_info_default();
  if (!model.scene.get() || shd_scene_get_info(model.scene.get(), &info) != SHD_OK) return;
  if (info.light_count > 0 && options.preset != LightPreset::kFile) {
    std::fprintf(stderr, "shd-render: lights of the model that are not used: %zu (--lights file)\n", info.light_count);
  }
  if (info.animation_count > 0 && options.animation.empty()) {
    std::fprintf(stderr, "shd-render: animations of the model that are not used: %zu (--animation 0)\n",
                 info.animation_count);
  }
  if (info.camera_count > 0 && !options.shots[0].camera) {
    std::fprintf(stderr, "shd-render: cameras of the model that are not used: %zu (--camera 0)\n", info.camera_count);
  }
}

/// Whether all uv of a mesh are the same, as of meshes without uv.
bool has_no_uv(const shd_mesh* mesh, uint32_t vertex_count) {
  std::vector<float> uv(size_t{2} * vertex_count);
  const shd_f32_out columns[2] = {{uv.data(), 2 * sizeof(float)}, {uv.data() + 1, 2 * sizeof(float)}};
  check(shd_mesh_read_uv(mesh, columns), "mesh");
  for (size_t i = 2; i < uv.size(); ++i) {
    if (uv[i] != uv[i % 2]) return false;
  }
  return true;
}

/// Reports meshes of the file that cannot show the textures of the options.
void report_missing_uv(const Options& options, const Model& model) {
  const bool needs_none = options.uv == Uv::kTriplanar || options.uv == Uv::kCamera;
  const bool has_maps = !options.texture.empty() || !options.normal_map.empty();
  if (!model.scene.get() || ((needs_none || !has_maps) && options.height_map.empty())) return;
  size_t count = 0;
  for (const Geometry& geometry : model.geometries) {
    count += has_no_uv(geometry.mesh, static_cast<uint32_t>(geometry.position.size() / 3));
  }
  if (count > 0) {
    std::fprintf(stderr,
                 "shd-render: meshes without texture coordinates, which show one texel of a texture: %zu of %zu "
                 "(--uv box)\n",
                 count, model.geometries.size());
  }
}

/// Reports surfaces that need what the options have not.
void report_glass(const Options& options, const Model& model) {
  std::string names;
  for (const Surface& surface : model.surfaces) {
    if (surface.desc.model != SHD_MODEL_GLASS || options.reflectance || keeps_model(options, surface.desc.model)) {
      continue;
    }
    names += (names.empty() ? "\"" : ", \"") + surface.name + "\"";
  }
  if (names.empty()) return;
  std::fprintf(stderr, "shd-render: the transmission of %s is drawn with an --environment only\n", names.c_str());
}

}  // namespace

void report_model(const Options& options, const Model& model) {
  report_unused(options, model);
  report_missing_uv(options, model);
  report_glass(options, model);
}
