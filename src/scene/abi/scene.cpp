// SPDX-License-Identifier: MIT
#include <shd/scene.h>

#include <cmath>
#include <cstddef>
#include <memory>

#include "extension/desc.h"
#include "extension/guard.h"
#include "scene/callback_files.h"
#include "scene/disk_files.h"
#include "scene/objects.h"
#include "scene/reading.h"
#include "scene/text.h"

namespace {

using namespace shd;
using namespace shd::extension;

constexpr uint32_t kSceneType = 0x53434e45;  // 'SCNE'
constexpr uint64_t kMaxInstances = uint64_t{1} << 20;

using Body = scene::Objects;

shd_object* object_of(const shd_scene* handle) {
  return reinterpret_cast<shd_object*>(const_cast<shd_scene*>(handle));
}

const Body* body_of(const shd_scene* handle) {
  return static_cast<const Body*>(shd_object_get_body(object_of(handle), kSceneType));
}

/// The body of a live handle; throws Failure.
const Body& require_body(const shd_scene* handle) {
  if (!handle) refuse(SHD_ERROR_INVALID_ARGUMENT, "scene: NULL");
  const Body* body = body_of(handle);
  if (!body) throw Failure(SHD_ERROR_INVALID_ARGUMENT, shd_last_error());
  return *body;
}

/// A load desc, read and checked.
struct Request {
  scene::ObjectOptions options;
  scene::Limits limits;
  shd_scene_desc desc = shd_scene_desc_default();
  bool in_process = false, any_folder = false;
};

uint64_t budget(const char* field, uint64_t value) {
  if (value == 0) refuse(SHD_ERROR_INVALID_ARGUMENT, "scene.%s: 0 is below 1", field);
  return value;
}

void read_limits(const shd_scene_desc& desc, scene::Limits* limits) {
  limits->file_bytes = budget("max_file_bytes", desc.max_file_bytes);
  limits->vertices = budget("max_vertices", desc.max_vertices);
  limits->triangles = budget("max_triangles", desc.max_triangles);
  limits->nodes = budget("max_nodes", desc.max_nodes);
  limits->instances = budget("max_instances", desc.max_instances);
  limits->reader_bytes = budget("max_reader_bytes", desc.max_reader_bytes);
  limits->texture_bytes = budget("max_texture_bytes", desc.max_texture_bytes);
  if (limits->instances > kMaxInstances) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "scene.max_instances: %llu is not in 1..%llu",
           static_cast<unsigned long long>(limits->instances), static_cast<unsigned long long>(kMaxInstances));
  }
  if (!(desc.time_limit > 0) || !std::isfinite(desc.time_limit)) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "scene.time_limit: %g is not positive", desc.time_limit);
  }
  limits->seconds = desc.time_limit;
}

/// Checks the parts of a desc that other functions read later, so that a mistake shows before the file is read.
void check_parts(shd_context* context, const scene::ObjectOptions& options) {
  scene::Sampler sampler;
  require(shd_sampler_create(context, &options.sampler, sampler.out()));
  constexpr uint32_t kKnown = SHD_MESH_KEEP_NONFINITE | SHD_MESH_TANGENTS | SHD_MESH_ADJACENCY;
  if (options.mesh_flags & ~kKnown) {
    refuse(SHD_ERROR_UNSUPPORTED, "scene.mesh_flags: bits 0x%x are not known", options.mesh_flags & ~kKnown);
  }
}

Request read_scene_desc(shd_context* context, const shd_scene_desc* in) {
  shd_scene_desc desc = shd_scene_desc_default();
  read_desc("scene", in, &desc);
  constexpr uint32_t kKnown =
      SHD_SCENE_REQUIRE_TEXTURES | SHD_SCENE_HOST_FILTERS | SHD_SCENE_IN_PROCESS | SHD_SCENE_ANY_FOLDER;
  if (desc.flags & ~kKnown) {
    refuse(SHD_ERROR_UNSUPPORTED, "scene.flags: bits 0x%x are not known", desc.flags & ~kKnown);
  }
  if (core::enum_bits(desc.uv_projection) > SHD_UV_PROJECTION_BOX) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "scene.uv_projection: %u is not in 0..%u", core::enum_bits(desc.uv_projection),
           core::enum_bits(SHD_UV_PROJECTION_BOX));
  }
  Request request = {{shd_sampler_desc_default(), shd_load_desc_default(), desc.mesh_flags, false, false}, {}, desc};
  request.options.uv_projection = desc.uv_projection;
  request.in_process = (desc.flags & SHD_SCENE_IN_PROCESS) != 0;
  request.any_folder = (desc.flags & SHD_SCENE_ANY_FOLDER) != 0;
  read_desc("scene.sampler", desc.sampler, &request.options.sampler);
  read_desc("scene.texture", desc.texture, &request.options.load);
  if (!desc.sampler) request.options.sampler.filter = SHD_FILTER_TRILINEAR;
  request.options.load.encoding = SHD_COLOR_ENCODING_AUTO;
  request.options.all_textures_required = (desc.flags & SHD_SCENE_REQUIRE_TEXTURES) != 0;
  request.options.host_filters = (desc.flags & SHD_SCENE_HOST_FILTERS) != 0;
  read_limits(desc, &request.limits);
  check_parts(context, request.options);
  return request;
}

scene::Model read(scene::HostFiles& files, const Request& request, const scene::Deadline& deadline) {
  scene::Model model = request.in_process
                           ? scene::read_in_process(files, request.limits, deadline)
                           : scene::read_by_worker(files, request.options.load.worker_path, request.limits, deadline);
  for (const std::string& text : files.refused()) model.warnings.push_back(text);
  return model;
}

/// Reads the model and makes its objects. Messages name its file.
std::unique_ptr<Body> make_body(shd_context* context, scene::HostFiles& files, const char* path, const Request& request,
                                const scene::Deadline& deadline) {
  try {
    auto body = std::make_unique<Body>();
    scene::make_objects(context, files, read(files, request, deadline), request.options, request.limits, deadline,
                        body.get());
    return body;
  } catch (const Failure& failure) {
    const std::string why = files.refused().empty() ? "" : "; " + files.refused().back();
    refuse(failure.code, "\"%s\": %s%s", scene::text_of(path).c_str(), failure.what(), why.c_str());
  }
}

std::unique_ptr<Body> load(shd_context* context, const char* path, const Request& request) {
  const scene::Deadline deadline(request.limits.seconds);
  scene::DiskFiles disk(path, request.any_folder, request.limits, deadline);
  if (!request.desc.find) return make_body(context, disk, path, request, deadline);
  scene::CallbackFiles files(disk.model(), disk.name(), request.desc, request.limits, deadline);
  return make_body(context, files, path, request, deadline);
}

std::unique_ptr<Body> load_memory(shd_context* context, const void* bytes, size_t size, const char* name,
                                  const Request& request) {
  const scene::Deadline deadline(request.limits.seconds);
  scene::Opened model;
  model.bytes = {static_cast<const unsigned char*>(bytes), size};
  model.size = size;
  scene::CallbackFiles files(std::move(model), name, request.desc, request.limits, deadline);
  return make_body(context, files, name, request, deadline);
}

const std::vector<std::string>* names_of(const Body& body, shd_scene_part part) {
  switch (core::enum_bits(part)) {
    case SHD_SCENE_PART_MESH: return &body.parts->mesh_names;
    case SHD_SCENE_PART_MATERIAL: return &body.parts->material_names;
    case SHD_SCENE_PART_TEXTURE: return &body.parts->texture_names;
    case SHD_SCENE_PART_LIGHT: return &body.light_names;
    case SHD_SCENE_PART_CAMERA: return &body.camera_names;
    case SHD_SCENE_PART_ANIMATION: return &body.parts->animation_names;
    default: return nullptr;
  }
}

/// Row `index` of a vector of handles, or null.
template <class Owner>
auto handle_of(const std::vector<Owner>& rows, uint32_t index) {
  return index < rows.size() ? rows[index].get() : nullptr;
}

/// Row `index` to the caller's struct. `rows_of` gives the rows of a body.
template <class RowsOf, class Out>
shd_result read_row(const shd_scene* handle, RowsOf rows_of, const char* part, uint32_t index, const char* name,
                    Out* out) {
  return guard([&]() -> shd_result {
    require(begin_output(name, out));
    const std::vector<Out>& rows = rows_of(require_body(handle));
    if (index >= rows.size()) {
      refuse(SHD_ERROR_NOT_FOUND, "index: %u, but the scene has %zu %s", index, rows.size(), part);
    }
    write_desc(rows[index], out);
    return SHD_OK;
  });
}

/// Throws Failure if there is no such animation.
const scene::Times& animation_of(const Body& body, uint32_t index) {
  const std::vector<scene::Times>& animations = body.parts->animations;
  if (index < animations.size()) return animations[index];
  refuse(SHD_ERROR_NOT_FOUND, "animation: %u, but the scene has %zu animations", index, animations.size());
}

/// Makes the handle of a body.
void create_handle(shd_context* context, std::unique_ptr<Body> body, shd_scene** out_scene) {
  const auto destroy = [](void* memory) { delete static_cast<Body*>(memory); };
  shd_object* object = nullptr;
  require(shd_object_create(context, kSceneType, body.get(), destroy, &object));
  (void)body.release();
  *out_scene = reinterpret_cast<shd_scene*>(object);
}

void log_warnings(shd_context* context, Body& body, size_t first) {
  for (size_t i = first; i < body.warnings.size(); ++i) {
    core::make_printable(body.warnings[i].data(), body.warnings[i].size());
    shd_context_log(context, SHD_LOG_LEVEL_WARNING, body.warnings[i].c_str());
  }
}

shd_scene_info info_of(const Body& body) {
  shd_scene_info info = shd_scene_info_default();
  info.mesh_count = static_cast<uint32_t>(body.meshes.size());
  info.material_count = static_cast<uint32_t>(body.parts->material_names.size());
  info.texture_count = static_cast<uint32_t>(body.parts->found_textures.size());
  info.light_count = static_cast<uint32_t>(body.lights.size());
  info.camera_count = static_cast<uint32_t>(body.cameras.size());
  info.instance_count = static_cast<uint32_t>(body.instances.size());
  info.warning_count = static_cast<uint32_t>(body.warnings.size());
  info.vertex_count = body.vertex_count;
  info.triangle_count = body.triangle_count;
  for (int c = 0; c < 3; ++c) {
    info.bounds_min[c] = static_cast<float>(body.bounds.low[c]);
    info.bounds_max[c] = static_cast<float>(body.bounds.high[c]);
    info.origin[c] = body.parts->origin[c];
  }
  info.animation_count = static_cast<uint32_t>(body.parts->animations.size());
  for (const scene::Mesh& rigid : body.parts->meshes) info.deformed_mesh_count += rigid.get() ? 0 : 1;
  return info;
}

}  // namespace

extern "C" {

shd_result shd_scene_load(shd_context* context, const char* path, const shd_scene_desc* desc, shd_scene** out_scene) {
  return guard([&]() -> shd_result {
    if (!out_scene) refuse(SHD_ERROR_INVALID_ARGUMENT, "out_scene: NULL");
    *out_scene = nullptr;
    require_context(context);
    if (!path) refuse(SHD_ERROR_INVALID_ARGUMENT, "path: NULL");
    if (!*path) refuse(SHD_ERROR_INVALID_ARGUMENT, "path: empty");
    std::unique_ptr<Body> body = load(context, path, read_scene_desc(context, desc));
    log_warnings(context, *body, 0);
    create_handle(context, std::move(body), out_scene);
    return SHD_OK;
  });
}

shd_result shd_scene_load_memory(shd_context* context, const void* bytes, size_t size, const char* name,
                                 const shd_scene_desc* desc, shd_scene** out_scene) {
  return guard([&]() -> shd_result {
    if (!out_scene) refuse(SHD_ERROR_INVALID_ARGUMENT, "out_scene: NULL");
    *out_scene = nullptr;
    require_context(context);
    if (!bytes) refuse(SHD_ERROR_INVALID_ARGUMENT, "bytes: NULL");
    if (size == 0) refuse(SHD_ERROR_CORRUPT, "size: 0 bytes are no model");
    std::unique_ptr<Body> body = load_memory(context, bytes, size, name ? name : "", read_scene_desc(context, desc));
    log_warnings(context, *body, 0);
    create_handle(context, std::move(body), out_scene);
    return SHD_OK;
  });
}

void shd_scene_retain(shd_scene* scene) {
  shd_object_retain(object_of(scene), kSceneType);
}

void shd_scene_release(shd_scene* scene) {
  shd_object_release(object_of(scene), kSceneType);
}

shd_result shd_scene_get_info(const shd_scene* scene, shd_scene_info* out_info) {
  return guard([&]() -> shd_result {
    require(begin_output("out_info", out_info));
    write_desc(info_of(require_body(scene)), out_info);
    return SHD_OK;
  });
}

const char* shd_scene_get_warning(const shd_scene* scene, size_t index) {
  const Body* body = body_of(scene);
  return body && index < body->warnings.size() ? body->warnings[index].c_str() : nullptr;
}

const char* shd_scene_get_name(const shd_scene* scene, shd_scene_part part, size_t index) {
  const Body* body = body_of(scene);
  const std::vector<std::string>* names = body ? names_of(*body, part) : nullptr;
  return names && index < names->size() ? (*names)[index].c_str() : nullptr;
}

shd_mesh* shd_scene_get_mesh(const shd_scene* scene, size_t index) {
  const Body* body = body_of(scene);
  return body ? handle_of(body->meshes, index) : nullptr;
}

shd_material* shd_scene_get_material(const shd_scene* scene, size_t index) {
  const Body* body = body_of(scene);
  return body ? handle_of(body->parts->materials.materials, index) : nullptr;
}

shd_texture* shd_scene_get_texture(const shd_scene* scene, size_t index) {
  const Body* body = body_of(scene);
  return body && index < body->parts->found_textures.size() ? body->parts->found_textures[index] : nullptr;
}

shd_light* shd_scene_get_light(const shd_scene* scene, size_t index) {
  const Body* body = body_of(scene);
  return body ? handle_of(body->lights, index) : nullptr;
}

shd_result shd_scene_get_material_desc(const shd_scene* scene, size_t index, shd_material_desc* out_desc) {
  const auto rows = [](const Body& body) -> auto& {
    return body.parts->materials.descs;
  };
  return read_row(scene, rows, "materials", index, "out_desc", out_desc);
}

shd_result shd_scene_get_light_desc(const shd_scene* scene, size_t index, shd_light_desc* out_desc) {
  const auto rows = [](const Body& body) -> auto& {
    return body.light_descs;
  };
  return read_row(scene, rows, "lights", index, "out_desc", out_desc);
}

shd_result shd_scene_get_camera(const shd_scene* scene, size_t index, shd_camera* out_camera) {
  const auto rows = [](const Body& body) -> auto& {
    return body.cameras;
  };
  return read_row(scene, rows, "cameras", index, "out_camera", out_camera);
}

shd_result shd_scene_get_instance(const shd_scene* scene, size_t index, shd_scene_instance* out_instance) {
  const auto rows = [](const Body& body) -> auto& {
    return body.instances;
  };
  return read_row(scene, rows, "instances", index, "out_instance", out_instance);
}

shd_result shd_scene_get_animation_times(const shd_scene* scene, size_t index, double* out_first, double* out_last) {
  return guard([&]() -> shd_result {
    if (out_first) *out_first = 0;
    if (out_last) *out_last = 0;
    if (!out_first) refuse(SHD_ERROR_INVALID_ARGUMENT, "out_first: NULL");
    if (!out_last) refuse(SHD_ERROR_INVALID_ARGUMENT, "out_last: NULL");
    const scene::Times& times = animation_of(require_body(scene), index);
    *out_first = times.first;
    *out_last = times.last;
    return SHD_OK;
  });
}

shd_result shd_scene_pose(const shd_scene* scene, size_t animation, double seconds, shd_scene** out_scene) {
  return guard([&]() -> shd_result {
    if (!out_scene) refuse(SHD_ERROR_INVALID_ARGUMENT, "out_scene: NULL");
    *out_scene = nullptr;
    const Body& body = require_body(scene);
    (void)animation_of(body, animation);
    if (!std::isfinite(seconds)) refuse(SHD_ERROR_INVALID_ARGUMENT, "seconds: %g is not finite", seconds);
    auto posed = std::make_unique<Body>();
    scene::pose_objects(body.parts, animation, seconds, posed.get());
    log_warnings(body.parts->context, *posed, body.parts->warnings.size());
    create_handle(body.parts->context, std::move(posed), out_scene);
    return SHD_OK;
  });
}

shd_result shd_scene_fill_render(const shd_scene* scene, shd_render_desc* in_out_render) {
  return guard([&]() -> shd_result {
    if (!in_out_render) refuse(SHD_ERROR_INVALID_ARGUMENT, "render: NULL");
    constexpr size_t kRequired = offsetof(shd_render_desc, light_count) + sizeof in_out_render->light_count;
    require(core::check_desc_size(fail, "render", in_out_render, {kRequired, alignof(shd_render_desc)}));
    const Body& body = require_body(scene);
    in_out_render->draws = body.draws.data();
    in_out_render->draw_count = body.draws.size();
    in_out_render->lights = body.light_list.data();
    in_out_render->light_count = body.light_list.size();
    return SHD_OK;
  });
}

}  // extern "C"
