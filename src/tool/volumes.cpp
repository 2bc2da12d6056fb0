// SPDX-License-Identifier: MIT
#include "tool/volumes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "command/values.h"

namespace {

struct Loaded {
  Texture texture;
  shd_vdb_info grid = shd_vdb_info_default();  // properties of a .vdb file
  bool has_grid = false;
};

shd_result load_raw(shd_context* context, const VolumeOptions& options, shd_load_desc load, Loaded& out) {
  shd_raw_desc desc = shd_raw_desc_default();
  desc.width = options.size[0];
  desc.height = options.size[1];
  desc.depth = options.size[2];
  desc.sample = options.sample;
  desc.byte_order = options.order;
  desc.header_bytes = options.header;
  load.raw = &desc;
  return shd_texture_load(context, options.file.c_str(), &load, out.texture.out());
}

shd_result load_stack(shd_context* context, const VolumeOptions& options, shd_load_desc load, Loaded& out) {
  const char* const path = options.file.c_str();
  shd_stack_desc desc = shd_stack_desc_default();
  if (options.file.find('%') != std::string::npos) {
    desc.pattern = path;
    desc.first = options.first;
    desc.last = options.last;
  } else {
    desc.paths = &path;
    desc.path_count = 1;
  }
  load.stack = &desc;
  return shd_texture_load(context, nullptr, &load, out.texture.out());
}

shd_result load_grid(shd_context* context, const VolumeOptions& options, shd_load_desc load, Loaded& out) {
  shd_vdb_desc desc = shd_vdb_desc_default();
  if (!options.grid.empty()) desc.grid = options.grid.c_str();
  out.has_grid = true;
  load.vdb = &desc;
  load.vdb_info = &out.grid;
  return shd_texture_load(context, options.file.c_str(), &load, out.texture.out());
}

Loaded load_file(shd_context* context, const VolumeOptions& options) {
  shd_load_desc load = shd_load_desc_default();
  load.tables = SHD_TABLE_NONE;  // volumes read the base level
  load.max_file_bytes = uint64_t{1} << 33;
  if (command::ends_with(options.file, ".raw") && options.size[0] == 0) {
    throw Failure(kExitUsage, options.file + " needs --volume-size");
  }
  Loaded out;
  const shd_result result = options.size[0] > 0                        ? load_raw(context, options, load, out)
                            : command::ends_with(options.file, ".vdb") ? load_grid(context, options, load, out)
                                                                       : load_stack(context, options, load, out);
  check(result, "--volume", kExitInput);
  return out;
}

/// Smallest and largest finite density.
std::array<float, 2> find_range(shd_context* context, const shd_texture* texture, const shd_texture_info& info) {
  const size_t count = size_t{info.width} * info.height;
  std::vector<float> u(count), v(count), w(count), density(count);
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = SHD_FILTER_NEAREST;
  Sampler sampler;
  check(shd_sampler_create(context, &desc, sampler.out()), "sampler");
  for (size_t i = 0; i < count; ++i) {
    u[i] = (static_cast<float>(i % info.width) + 0.5f) / static_cast<float>(info.width);
    v[i] = (static_cast<float>(i / info.width) + 0.5f) / static_cast<float>(info.height);
  }
  shd_lookups lookups = shd_lookups_default();
  shd_texels texels = shd_texels_default();
  lookups.count = count;
  lookups.u = shd_f32_column(u.data(), 0);
  lookups.v = shd_f32_column(v.data(), 0);
  lookups.w = shd_f32_column(w.data(), 0);
  texels.channel[0].data = density.data();
  std::array<float, 2> range = {HUGE_VALF, -HUGE_VALF};
  for (uint32_t z = 0; z < info.depth; ++z) {
    std::fill(w.begin(), w.end(), (static_cast<float>(z) + 0.5f) / static_cast<float>(info.depth));
    check(shd_texture_sample(texture, sampler.get(), &lookups, &texels), "densities");
    for (const float d : density) {
      if (!std::isfinite(d)) continue;
      range[0] = std::min(range[0], d);
      range[1] = std::max(range[1], d);
    }
  }
  if (range[0] > range[1]) return {0, 1};
  if (range[0] == range[1]) range[1] = range[0] + std::max(1.0f, std::fabs(range[0]));
  return range;
}

/// Maps the texture to a box around the origin whose longest side is 2. Rows go down, and slices go away from the
/// viewer; or rows go away, and slices go up.
std::array<float, 16> place_voxels(const VolumeOptions& options, const shd_texture_info& info) {
  const float sides[3] = {options.spacing[0] * static_cast<float>(info.width),
                          options.spacing[1] * static_cast<float>(info.height),
                          options.spacing[2] * static_cast<float>(info.depth)};
  const float scale = 2.0f / std::max({sides[0], sides[1], sides[2]});
  const float down[3] = {0, options.slices_up ? 0.0f : -1.0f, options.slices_up ? -1.0f : 0.0f};
  const float deep[3] = {0, options.slices_up ? 1.0f : 0.0f, options.slices_up ? 0.0f : -1.0f};
  std::array<float, 16> out{};
  out[0] = scale * sides[0];
  out[12] = -0.5f * out[0];
  out[15] = 1.0f;
  for (size_t c = 1; c < 3; ++c) {
    out[4 + c] = scale * sides[1] * down[c];
    out[8 + c] = scale * sides[2] * deep[c];
    out[12 + c] = -0.5f * (out[4 + c] + out[8 + c]);
  }
  return out;
}

/// Length of an edge of the box.
float edge(const std::array<float, 16>& m, size_t axis) {
  return std::sqrt(m[4 * axis] * m[4 * axis] + m[4 * axis + 1] * m[4 * axis + 1] + m[4 * axis + 2] * m[4 * axis + 2]);
}

/// Density, extinction for a box of side 2, r, g, b.
struct Point {
  float density, extinction, color[3];
};

/// Densities from clear to opaque; of a level set the inside.
std::vector<Point> transfer_function(const Loaded& loaded, const std::array<float, 2>& range, bool lit) {
  if (loaded.has_grid && loaded.grid.grid_class == SHD_VDB_CLASS_LEVEL_SET) {
    const float half = std::max(std::fabs(loaded.grid.background) / 3.0f, 1e-30f);
    return {{-half, 200, {0.8f, 0.75f, 0.7f}}, {half, 0, {0.8f, 0.75f, 0.7f}}};
  }
  std::vector<Point> points = {{0.1f, 0, {0.55f, 0.6f, 0.7f}},
                               {0.25f, 5, {0.7f, 0.75f, 0.8f}},
                               {0.5f, 18, {1, 0.95f, 0.9f}},
                               {1, 40, {1, 1, 0.95f}}};
  if (lit) {
    points = {{0.1f, 0, {0.7f, 0.35f, 0.3f}},
              {0.25f, 12, {0.8f, 0.45f, 0.38f}},
              {0.5f, 40, {0.9f, 0.8f, 0.65f}},
              {1, 60, {1, 0.98f, 0.9f}}};
  }
  for (Point& point : points) point.density = range[0] + point.density * (range[1] - range[0]);
  return points;
}

/// The material of lit volumes. Fog glows, unless a model is chosen.
Material make_volume_material(shd_context* context, const Options& options, const Loaded& loaded) {
  Material material;
  const bool fog = loaded.has_grid && loaded.grid.grid_class == SHD_VDB_CLASS_FOG_VOLUME;
  if (options.reflectance ? *options.reflectance == SHD_MODEL_UNLIT : fog) return material;
  shd_material_desc desc = shd_material_desc_default();
  desc.model = options.reflectance.value_or(SHD_MODEL_BLINN_PHONG);
  desc.ambient_share = 1.0f;
  for (float& s : desc.specular) s = options.specular.value_or(0.3f);
  desc.exponent = options.exponent.value_or(30.0f);
  desc.flags = SHD_MATERIAL_DOUBLE_SIDED;
  check(shd_material_create(context, &desc, material.out()), "material of the volume");
  return material;
}

}  // namespace

StageVolume load_volume(shd_context* context, const Options& options) {
  StageVolume out;
  if (options.volume.file.empty()) return out;
  const Loaded loaded = load_file(context, options.volume);
  shd_texture_info info = shd_texture_info_default();
  check(shd_texture_get_info(loaded.texture.get(), &info), "volume");
  if (loaded.has_grid) {
    std::copy(std::begin(loaded.grid.object_to_world), std::end(loaded.grid.object_to_world),
              out.object_to_world.begin());
  } else {
    out.object_to_world = place_voxels(options.volume, info);
  }
  const float sides[3] = {edge(out.object_to_world, 0), edge(out.object_to_world, 1), edge(out.object_to_world, 2)};
  const Material material = make_volume_material(context, options, loaded);
  const std::array<float, 2> range =
      options.volume.range ? *options.volume.range : find_range(context, loaded.texture.get(), info);
  std::vector<Point> points = transfer_function(loaded, range, material.get() != nullptr);
  const float scale = options.volume.density * 2.0f / std::max({sides[0], sides[1], sides[2]});
  for (Point& point : points) point.extinction *= scale;
  shd_volume_desc desc = shd_volume_desc_default();
  desc.texture = loaded.texture.get();
  desc.material = material.get();
  desc.point_count = static_cast<uint32_t>(points.size());
  desc.density = shd_f32_column(&points[0].density, sizeof(Point));
  desc.extinction = shd_f32_column(&points[0].extinction, sizeof(Point));
  for (size_t c = 0; c < 3; ++c) desc.color[c] = shd_f32_column(&points[0].color[c], sizeof(Point));
  desc.step = 0.5f * std::min({sides[0] / static_cast<float>(info.width), sides[1] / static_cast<float>(info.height),
                               sides[2] / static_cast<float>(info.depth)});
  desc.jitter = 1.0f;
  check(shd_volume_create(context, &desc, out.volume.out()), "volume");
  return out;
}

Model volume_model(const StageVolume& volume) {
  Model model;
  Geometry corners;
  for (uint32_t i = 0; i < 8; ++i) {
    for (uint32_t c = 0; c < 3; ++c) corners.position.push_back(static_cast<float>(i >> c & 1));
    corners.indices.push_back(i);
  }
  model.geometries.push_back(std::move(corners));
  Instance instance;
  instance.object_to_world = volume.object_to_world;
  model.surfaces.push_back({"volume", shd_material_desc_default()});
  model.instances.push_back(instance);
  return model;
}
