// SPDX-License-Identifier: MIT
#include "tool/model.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>

#include "command/failure.h"
#include "tool/output.h"
#include "tool/picture.h"
#include "tool/shapes.h"
#include "tool/textures.h"
#include "tool/uv.h"

namespace {

void grow(Box& box, const float* m, const float* p) {
  double world[3];
  for (int row = 0; row < 3; ++row) {
    world[row] = double(m[row]) * p[0] + double(m[4 + row]) * p[1] + double(m[8 + row]) * p[2] + m[12 + row];
    if (!std::isfinite(world[row])) return;
  }
  for (int c = 0; c < 3; ++c) {
    box.low[c] = std::min(box.low[c], world[c]);
    box.high[c] = std::max(box.high[c], world[c]);
  }
}

/// Loads a model whose bytes come from standard input.
shd_result load_input(shd_context* context, const std::string& name, const shd_scene_desc& desc, shd_scene** out) {
  constexpr size_t kMost = size_t{1} << 30, kStep = size_t{1} << 20;  // kMost is shd_scene_desc.max_file_bytes
  std::vector<char> bytes;
  for (size_t got = 1; got > 0;) {
    const size_t size = bytes.size();
    if (size > kMost) throw Failure(kExitInput, "standard input: more than 1 GiB");
    bytes.resize(size + kStep);
    got = std::fread(bytes.data() + size, 1, kStep, stdin);
    bytes.resize(size + got);
  }
  if (std::ferror(stdin)) throw Failure(kExitInput, "standard input cannot be read");
  if (bytes.empty()) throw Failure(kExitInput, "standard input is empty");
  return shd_scene_load_memory(context, bytes.data(), bytes.size(), name.c_str(), &desc, out);
}

Scene load_scene(shd_context* context, const Options& options) {
  shd_sampler_desc sampler = shd_sampler_desc_default();
  sampler.filter = options.filter;
  sampler.magnification = options.magnification;
  sampler.lod_bias = options.lod_bias;
  shd_load_desc texture = shd_load_desc_default();
  texture.tables = tables_of(options.filter);
  shd_scene_desc desc = shd_scene_desc_default();
  desc.sampler = &sampler;
  desc.texture = &texture;
  if (options.has_filter) desc.flags |= SHD_SCENE_HOST_FILTERS;
  if (options.any_folder) desc.flags |= SHD_SCENE_ANY_FOLDER;
  if (options.line_width > 0.0f) desc.mesh_flags |= SHD_MESH_ADJACENCY;
  desc.uv_projection = projection_of(options.uv);
  Scene scene;
  const std::optional<std::string> type = stream_type(options.model);
  const shd_result result = type ? load_input(context, type->empty() ? "" : "standard input" + *type, desc, scene.out())
                                 : shd_scene_load(context, options.model.c_str(), &desc, scene.out());
  if (result != SHD_OK) throw Failure(kExitInput, (type ? "standard input: " : "") + std::string(shd_last_error()));
  return scene;
}

void read_geometry(Geometry& geometry) {
  shd_mesh_info info = shd_mesh_info_default();
  check(shd_mesh_get_info(geometry.mesh, &info), "mesh");
  geometry.position.resize(size_t{3} * info.vertex_count);
  geometry.indices.resize(size_t{3} * info.triangle_count);
  shd_f32_out columns[3];
  for (size_t c = 0; c < 3; ++c) columns[c] = {geometry.position.data() + c, 3 * sizeof(float)};
  const shd_u32_out indices = {geometry.indices.data(), 0};
  check(shd_mesh_read_positions(geometry.mesh, columns), "mesh");
  check(shd_mesh_read_indices(geometry.mesh, &indices), "mesh");
}

void add_scene_parts(Model& model, const shd_scene_info& info) {
  for (uint32_t i = 0; i < info.mesh_count; ++i) {
    model.geometries.emplace_back();
    model.geometries.back().name = shd_scene_get_name(model.scene.get(), SHD_SCENE_PART_MESH, i);
    model.geometries.back().mesh = shd_scene_get_mesh(model.scene.get(), i);
    read_geometry(model.geometries.back());
  }
  for (uint32_t i = 0; i < info.material_count; ++i) {
    Surface surface = {shd_scene_get_name(model.scene.get(), SHD_SCENE_PART_MATERIAL, i), shd_material_desc_default()};
    check(shd_scene_get_material_desc(model.scene.get(), i, &surface.desc), "material");
    model.surfaces.push_back(surface);
  }
  for (uint32_t i = 0; i < info.instance_count; ++i) {
    shd_scene_instance from = shd_scene_instance_default();
    check(shd_scene_get_instance(model.scene.get(), i, &from), "instance");
    Instance instance;
    instance.geometry = from.mesh;
    instance.surface = from.material;
    instance.cull = from.cull;
    std::copy(from.object_to_world, from.object_to_world + 16, instance.object_to_world.begin());
    model.instances.push_back(instance);
  }
}

/// A warning of the library with the option of this program in place of the flag of the API.
std::string in_options(std::string warning) {
  constexpr std::string_view kFlag = "SHD_SCENE_ANY_FOLDER";
  const size_t at = warning.find(kFlag);
  return at == std::string::npos ? warning : warning.replace(at, kFlag.size(), "--any-folder");
}

Model import_model(shd_context* context, const Options& options) {
  Model model;
  model.scene = load_scene(context, options);
  shd_scene_info info = shd_scene_info_default();
  check(shd_scene_get_info(model.scene.get(), &info), "scene");
  for (uint32_t i = 0; i < info.warning_count; ++i) {
    std::fprintf(stderr, "shd-render: %s\n", in_options(shd_scene_get_warning(model.scene.get(), i)).c_str());
  }
  add_scene_parts(model, info);
  return model;
}

/// The animation whose number, or else whose name, is the text.
std::optional<uint32_t> index_of(const shd_scene* scene, uint32_t count, const std::string& text) {
  for (uint32_t i = 0; i < count; ++i) {
    if (text == std::to_string(i)) return i;
  }
  for (uint32_t i = 0; i < count; ++i) {
    if (text == shd_scene_get_name(scene, SHD_SCENE_PART_ANIMATION, i)) return i;
  }
  return std::nullopt;
}

void add_shape(shd_context* context, const Options& options, shd_shape shape, uint32_t steps, const Surface& surface,
               const Instance& place, Model& model) {
  Instance instance = place;
  instance.geometry = model.geometries.size();
  instance.surface = model.surfaces.size();
  model.geometries.emplace_back();
  Geometry& geometry = model.geometries.back();
  geometry.name = surface.is_floor ? surface.name : shd_shape_name(shape);
  geometry.own = make_shape(context, shape, steps, options.line_width > 0.0f ? SHD_MESH_ADJACENCY : SHD_MESH_NONE,
                            surface.is_floor ? SHD_UV_PROJECTION_NONE : projection_of(options.uv));
  geometry.mesh = geometry.own.get();
  read_geometry(geometry);
  model.surfaces.push_back(surface);
  model.instances.push_back(instance);
}

/// The corners of triangle k of a cycle: a wide end in front and a tip behind, turned by a third of a circle for each.
std::array<std::array<float, 3>, 3> cycle_corners(uint32_t k) {
  constexpr float kFlat[3][3] = {{-0.92f, -0.95f, 0.2f}, {1.75f, -0.5f, -0.2f}, {-0.92f, -0.25f, 0.2f}};
  const float angle = 2.0943951f * static_cast<float>(k), c = std::cos(angle), s = std::sin(angle);
  std::array<std::array<float, 3>, 3> corners;
  for (size_t i = 0; i < 3; ++i) {
    const float* const p = kFlat[i];
    corners[i] = {c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]};
  }
  return corners;
}

Surface make_surface(const char* name, const std::array<float, 3>& diffuse, float specular) {
  Surface surface = {name, shd_material_desc_default()};
  for (size_t c = 0; c < 3; ++c) {
    surface.desc.diffuse[c] = diffuse[c];
    surface.desc.specular[c] = specular;
  }
  surface.desc.ambient_share = 1.0f;  // as shd_scene_load() sets it
  surface.desc.exponent = 40.0f;
  surface.desc.roughness = std::sqrt(std::sqrt(2.0f / 42.0f));  // as wide a lobe
  surface.desc.model = SHD_MODEL_BLINN_PHONG;
  return surface;
}

/// Three triangles, each of which hides a part of the next one, so that no order of whole triangles is right (Newell,
/// Newell and Sancha, "A Solution to the Hidden Surface Problem", 1972).
void add_cycle(shd_context* context, const Options& options, Model& model) {
  constexpr Rgb kColors[3] = {{0.75f, 0.12f, 0.08f}, {0.12f, 0.5f, 0.15f}, {0.1f, 0.2f, 0.7f}};
  constexpr float kUv[3][2] = {{0, 1}, {1, 0.5f}, {0, 0}};
  for (uint32_t k = 0; k < 3; ++k) {
    const auto corners = cycle_corners(k);
    shd_mesh_desc desc = shd_mesh_desc_default();
    desc.vertex_count = 3;
    for (size_t c = 0; c < 3; ++c) desc.position[c] = {&corners[0][c], sizeof corners[0]};
    for (size_t c = 0; c < 2; ++c) desc.uv[c] = {&kUv[0][c], sizeof kUv[0]};
    desc.flags = SHD_MESH_TANGENTS | (options.line_width > 0.0f ? SHD_MESH_ADJACENCY : SHD_MESH_NONE);
    Instance instance;
    instance.geometry = instance.surface = k;
    Geometry& geometry = model.geometries.emplace_back();
    geometry.name = "triangle";
    check(shd_mesh_create(context, &desc, geometry.own.out()), "cycle");
    geometry.mesh = geometry.own.get();
    read_geometry(geometry);
    model.surfaces.push_back(make_surface("triangle", kColors[k], 0.1f));
    model.instances.push_back(instance);
  }
}

}  // namespace

Model make_model(shd_context* context, const Options& options) {
  if (!options.model.empty()) return import_model(context, options);
  Model model;
  if (options.cycle) {
    add_cycle(context, options, model);
    return model;
  }
  add_shape(context, options, options.shape, static_cast<uint32_t>(options.tessellation),
            make_surface("ceramic", {0.62f, 0.6f, 0.56f}, 0.25f), Instance{}, model);
  return model;
}

void add_floor(shd_context* context, const Options& options, const Bounds& bounds, Model& model) {
  Instance instance;
  for (size_t c = 0; c < 3; ++c) instance.object_to_world[5 * c] = 4.0f * bounds.radius;
  for (size_t c = 0; c < 3; ++c) instance.object_to_world[12 + c] = bounds.center[c];
  instance.object_to_world[13] = bounds.bottom;
  Surface surface = make_surface("floor", {0.5f, 0.5f, 0.5f}, 0.0f);
  surface.is_floor = true;
  const uint32_t parts = options.occlusion ? 192 : 1;  // occlusion is stored at vertices
  add_shape(context, options, SHD_SHAPE_PLANE, parts, surface, instance, model);
}

Animation find_animation(const Options& options, const Model& model) {
  shd_scene_info info = shd_scene_info_default();
  if (model.scene.get()) check(shd_scene_get_info(model.scene.get(), &info), "scene");
  const auto index = index_of(model.scene.get(), info.animation_count, options.animation);
  if (!index) {
    std::string text = "--animation " + options.animation + ": the model has no such animation";
    for (uint32_t i = 0; i < info.animation_count && i < 16; ++i) {
      text += (i == 0 ? "; it has " : ", ") + std::to_string(i) + " \"" +
              shd_scene_get_name(model.scene.get(), SHD_SCENE_PART_ANIMATION, i) + "\"";
    }
    throw Failure(kExitInput, text);
  }
  Animation animation;
  animation.index = *index;
  check(shd_scene_get_animation_times(model.scene.get(), *index, &animation.first, &animation.last), "animation");
  return animation;
}

Model pose_model(const Model& model, const Animation& animation, double seconds) {
  Model posed;
  check(shd_scene_pose(model.scene.get(), animation.index, seconds, posed.scene.out()), "pose");
  shd_scene_info info = shd_scene_info_default();
  check(shd_scene_get_info(posed.scene.get(), &info), "scene");
  add_scene_parts(posed, info);
  return posed;
}

Model box_model(const Box& box) {
  Model model;
  Geometry corners;
  for (uint32_t i = 0; i < 8; ++i) {
    for (size_t c = 0; c < 3; ++c) {
      corners.position.push_back(static_cast<float>(i >> c & 1 ? box.high[c] : box.low[c]));
    }
    corners.indices.push_back(i);
  }
  model.geometries.push_back(std::move(corners));
  model.surfaces.push_back({"box", shd_material_desc_default()});
  model.instances.emplace_back();
  return model;
}

Box box_of(const Model& model) {
  Box box;
  for (const Instance& instance : model.instances) {
    const Geometry& geometry = model.geometries[instance.geometry];
    for (const uint32_t vertex : geometry.indices) {
      grow(box, instance.object_to_world.data(), &geometry.position[size_t{3} * vertex]);
    }
  }
  return box;
}

void grow(Box& box, const Box& by) {
  for (size_t c = 0; c < 3; ++c) {
    box.low[c] = std::min(box.low[c], by.low[c]);
    box.high[c] = std::max(box.high[c], by.high[c]);
  }
}

Bounds bounds_of(const Model& model) {
  const Box box = box_of(model);
  Bounds bounds;
  if (box.low[0] > box.high[0]) return bounds;
  double diagonal = 0.0;
  for (size_t c = 0; c < 3; ++c) {
    bounds.center[c] = static_cast<float>(0.5 * (box.low[c] + box.high[c]));
    diagonal += (box.high[c] - box.low[c]) * (box.high[c] - box.low[c]);
  }
  bounds.bottom = static_cast<float>(box.low[1]);
  bounds.radius = std::max(static_cast<float>(0.5 * std::sqrt(diagonal)), 1e-30f);
  return bounds;
}
