// SPDX-License-Identifier: MIT
/// shd-render: pictures of a 3D model.
#include <algorithm>
#include <chrono>
#include <cinttypes>
#include <csignal>
#include <cstdio>
#include <vector>

#include <unistd.h>

#include "command/program.h"
#include "tool/camera.h"
#include "tool/cryptomatte.h"
#include "tool/draws.h"
#include "tool/environment.h"
#include "tool/lights.h"
#include "tool/occlusion.h"
#include "tool/output.h"
#include "tool/progress.h"
#include "tool/shadows.h"
#include "tool/tables.h"
#include "tool/uv.h"
#include "tool/volumes.h"

namespace {

Context make_context(const Options& options) {
  shd_context_desc desc = shd_context_desc_default();
  desc.worker_count = options.threads;
  desc.simd = options.simd;
  Context context;
  check(shd_context_create(&desc, context.out()), "context");
  return context;
}

Framebuffer make_framebuffer(shd_context* context, const Options& options) {
  shd_framebuffer_desc desc = shd_framebuffer_desc_default();
  desc.width = options.width;
  desc.height = options.height;
  desc.sample_count = options.samples;
  desc.aovs = options.aovs;
  Framebuffer framebuffer;
  check(shd_framebuffer_create(context, &desc, framebuffer.out()), "framebuffer");
  return framebuffer;
}

unsigned long long wide(uint64_t value) {
  return static_cast<unsigned long long>(value);
}

void print_stats(shd_context* context, const shd_render_stats& stats, double seconds) {
  std::fprintf(stderr, "%llu triangles, %llu rasterised, %llu fragments in %.1f ms on %s with %zu workers\n",
               wide(stats.triangle_count), wide(stats.rasterized_triangle_count), wide(stats.fragment_count),
               1e3 * seconds, shd_context_get_simd_target(context), shd_context_get_worker_count(context));
  std::fprintf(stderr, "vertices %.1f ms, assembly %.1f ms, binning %.1f ms, tiles %.1f ms; %.1f MiB of scratch\n",
               1e3 * stats.vertex_seconds, 1e3 * stats.assembly_seconds, 1e3 * stats.binning_seconds,
               1e3 * stats.tile_seconds, static_cast<double>(stats.scratch_bytes) / 1048576.0);
  if (stats.order_conflict_count || stats.split_count) {
    std::fprintf(stderr, "%llu pairs in the wrong order, %llu cuts\n", wide(stats.order_conflict_count),
                 wide(stats.split_count));
  }
  if (stats.black_draw_count) {
    std::fprintf(stderr, "%llu draws without a material or without light\n", wide(stats.black_draw_count));
  }
}

/// The parts of a picture, except the camera.
struct Stage {
  shd_context* context;
  const Options& options;
  const Model& model;
  const Model& shown;  // inside the picture
  const Bounds& bounds;
  const Paint& paint;
  shd_environment* environment;
  const StageVolume& volume;
};

std::vector<Shadow> shadows_of(const Stage& stage, const Camera& camera, const Draws& draws) {
  const std::vector<StageLight> lights = make_lights(stage.context, stage.options, stage.model, stage.bounds, camera);
  return make_shadows(stage.context, stage.options, stage.bounds, draws, lights);
}

void render(const Stage& stage, const Camera& camera, const Draws& draws, const shd_progress& progress,
            shd_framebuffer* framebuffer) {
  const Options& options = stage.options;
  const std::vector<StageLight> lights = make_lights(stage.context, options, stage.model, stage.bounds, camera);
  const std::vector<Shadow> shadows = make_shadows(stage.context, options, stage.bounds, draws, lights);
  std::vector<const shd_light*> light_list;
  for (const StageLight& light : lights) light_list.push_back(light.light.get());
  std::vector<const shd_shadow*> shadow_list;
  for (const Shadow& shadow : shadows) shadow_list.push_back(shadow.get());
  shd_render_stats stats = shd_render_stats_default();
  shd_render_desc desc = shd_render_desc_default();
  desc.framebuffer = framebuffer;
  desc.view = camera.view;
  desc.draws = draws.draws.data();
  desc.draw_count = draws.draws.size();
  desc.lights = light_list.data();
  desc.light_count = light_list.size();
  if (!shadow_list.empty()) desc.shadows = shadow_list.data();
  desc.stats = &stats;
  desc.visibility = options.visibility;
  desc.supersampling = std::max(options.supersampling, 1u);
  for (size_t c = 0; c < 4; ++c) desc.clear_color[c] = options.background[c];
  set_environment(options, stage.environment, desc);
  shd_volume_draw volume = shd_volume_draw_default();
  volume.volume = stage.volume.volume.get();
  std::copy(stage.volume.object_to_world.begin(), stage.volume.object_to_world.end(), volume.object_to_world);
  desc.volumes = volume.volume ? &volume : nullptr;
  desc.volume_count = volume.volume ? 1 : 0;
  desc.progress = progress;
  const auto start = std::chrono::steady_clock::now();
  check(shd_render(stage.context, &desc), "render");
  if (stats.triangle_count > 0 && stats.culled_triangle_count == stats.triangle_count) {
    std::fprintf(stderr, "shd-render: all faces are seen from behind, and none is double-sided: see --orbit\n");
  }
  if (!options.stats) return;
  print_stats(stage.context, stats, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

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

/// The poses of the pictures.
struct Poses {
  Animation animation;
  std::vector<double> times;  // [s]; empty = the pose of the file
};

Poses find_poses(const Options& options, const Model& model) {
  Poses poses;
  if (options.animation.empty()) return poses;
  poses.animation = find_animation(options, model);
  const double first = poses.animation.first, length = poses.animation.last - first;
  if (options.frames == 0) poses.times.push_back(options.time.value_or(first));
  for (uint32_t i = 0; i < options.frames; ++i) {
    poses.times.push_back(first + length * i / std::max(options.frames - 1.0, 1.0));
  }
  return poses;
}

/// The corners of a box around all poses; no geometry if there is one pose.
Model show_all(const Poses& poses, const Model& model) {
  if (poses.times.size() < 2) return Model();
  Box box;
  for (const double time : poses.times) grow(box, box_of(pose_model(model, poses.animation, time)));
  return box_model(box);
}

/// Adds the floor and the occlusion of the options.
void add_extras(shd_context* context, const Options& options, const Bounds& bounds, Model& model) {
  if (options.floor) add_floor(context, options, bounds, model);
  if (options.occlusion) add_occlusion(context, options, bounds, model);
}

void run(const Options& options) {
  const Context context = make_context(options);
  check_output(context.get(), options);
  if (shows_texture(options)) return save_table(context.get(), options, picture_name(options, 0, 1));
  const Color color = open_color(context.get(), options);
  const StageVolume volume = load_volume(context.get(), options);
  Model model = volume.volume.get() ? volume_model(volume) : make_model(context.get(), options);
  report_unused(options, model);
  report_missing_uv(options, model);
  report_glass(options, model);
  const Poses poses = find_poses(options, model);
  if (!poses.times.empty()) model = pose_model(model, poses.animation, poses.times[0]);
  const Model all = show_all(poses, model);
  const Model& shown = all.geometries.empty() ? model : all;
  const Bounds bounds = bounds_of(shown);
  for (const Shot& shot : options.shots) {
    make_camera(options, shot, 0.0f, model, shown, bounds);  // throws before textures are read
  }
  const Camera first = make_camera(options, options.shots[0], 0.0f, model, shown, bounds);
  const shd_slot uv = uv_slot(options.uv, box_of(shown), first);
  add_extras(context.get(), options, bounds, model);
  const Paint paint = make_paint(context.get(), options, model, uv);
  const Framebuffer framebuffer = make_framebuffer(context.get(), options);
  const Environment environment = load_environment(context.get(), options);
  const Stage stage = {context.get(), options, model, shown, bounds, paint, environment.get(), volume};
  const uint32_t pictures = std::max({options.turntable, options.frames, static_cast<uint32_t>(options.shots.size())});
  Progress progress(options.progress || isatty(STDERR_FILENO), pictures);
  for (uint32_t i = 0; i < pictures; ++i) {
    if (i > 0 && options.frames > 0) {
      model = pose_model(model, poses.animation, poses.times[i]);
      add_extras(context.get(), options, bounds, model);
    }
    const float turn = options.turntable ? 360.0f * static_cast<float>(i) / static_cast<float>(pictures) : 0.0f;
    const Shot& shot = options.shots[options.shots.size() > 1 ? i : 0];
    const Camera camera = make_camera(options, shot, turn, model, shown, bounds);
    const Draws draws = make_draws(context.get(), options, model, paint, camera);
    const std::string name = picture_name(options, i, pictures);
    if (options.table) {
      save_shadow_map(shadows_of(stage, camera, draws), options, name);
      continue;
    }
    render(stage, camera, draws, progress.of_picture(i), framebuffer.get());
    if (options.hash) {
      std::printf("%016" PRIx64 "\n", picture_hash(framebuffer.get(), options));
      flush_stream();
    }
    if (name.empty()) continue;
    const Mattes mattes = make_mattes(context.get(), options, model, camera.view, draws);
    save_picture(color, framebuffer.get(), options, name, mattes.extras(camera.view));
  }
  progress.finish();
}

}  // namespace

int main(int argc, char** argv) {
  return command::run("shd-render", [&]() -> int {
    Options options;
    if (!read_options(argc, argv, options)) return kExitOk;
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error of the output
    std::signal(SIGXFSZ, SIG_IGN);  // a file that is too large is an error of write()
    run(options);
    return kExitOk;
  });
}
