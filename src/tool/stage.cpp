// SPDX-License-Identifier: MIT
#include "tool/stage.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "command/failure.h"
#include "tool/lights.h"
#include "tool/occlusion.h"
#include "tool/reports.h"
#include "tool/shadows.h"
#include "tool/uv.h"

namespace {

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

/// The model that cameras show.
const Model& shown_of(const Stage& stage) {
  return stage.all.geometries.empty() ? stage.model : stage.all;
}

/// Adds the floor and the occlusion of the options.
void add_extras(Stage& stage) {
  if (stage.options.floor) add_floor(stage.context, stage.options, stage.bounds, stage.model);
  if (stage.options.occlusion) add_occlusion(stage.context, stage.options, stage.bounds, stage.model);
}

}  // namespace

Stage open_stage(shd_context* context, const Options& options, bool reports) {
  Stage stage;
  stage.context = context;
  stage.options = options;
  stage.volume = load_volume(context, options);
  stage.model = stage.volume.volume.get() ? volume_model(stage.volume) : make_model(context, options);
  if (reports) report_model(options, stage.model);
  stage.poses = find_poses(options, stage.model);
  if (!stage.poses.times.empty()) {
    stage.model = pose_model(stage.model, stage.poses.animation, stage.poses.times[0]);
  }
  stage.all = show_all(stage.poses, stage.model);
  stage.bounds = bounds_of(shown_of(stage));
  for (const Shot& shot : options.shots) {  // throws before textures are read
    make_camera(options, shot, 0.0f, stage.model, shown_of(stage), stage.bounds);
  }
  const Camera first = make_camera(options, options.shots[0], 0.0f, stage.model, shown_of(stage), stage.bounds);
  stage.uv = uv_slot(options.uv, box_of(shown_of(stage)), first);
  add_extras(stage);
  stage.paint = make_paint(context, options, stage.model, stage.uv);
  stage.framebuffer = make_framebuffer(context, options);
  stage.environment = load_environment(context, options);
  return stage;
}

Frame make_frame(Stage& stage, uint32_t picture, uint32_t pictures) {
  const Options& options = stage.options;
  if (picture > 0 && options.frames > 0) {
    stage.model = pose_model(stage.model, stage.poses.animation, stage.poses.times[picture]);
    add_extras(stage);
  }
  const float turn = options.turntable ? 360.0f * static_cast<float>(picture) / static_cast<float>(pictures) : 0.0f;
  const Shot& shot = options.shots[options.shots.size() > 1 ? picture : 0];
  Frame frame;
  frame.camera = make_camera(options, shot, turn, stage.model, shown_of(stage), stage.bounds);
  frame.draws = make_draws(stage.context, options, stage.model, stage.paint, frame.camera);
  return frame;
}

void render(const Stage& stage, const Options& options, const Frame& frame, const shd_progress& progress) {
  const std::vector<StageLight> lights = make_lights(stage.context, options, stage.model, stage.bounds, frame.camera);
  const std::vector<Shadow> shadows = make_shadows(stage.context, options, stage.bounds, frame.draws, lights);
  std::vector<const shd_light*> light_list;
  for (const StageLight& light : lights) light_list.push_back(light.light.get());
  std::vector<const shd_shadow*> shadow_list;
  for (const Shadow& shadow : shadows) shadow_list.push_back(shadow.get());
  shd_render_stats stats = shd_render_stats_default();
  shd_render_desc desc = shd_render_desc_default();
  desc.framebuffer = stage.framebuffer.get();
  desc.view = frame.camera.view;
  desc.draws = frame.draws.draws.data();
  desc.draw_count = frame.draws.draws.size();
  desc.lights = light_list.data();
  desc.light_count = light_list.size();
  if (!shadow_list.empty()) desc.shadows = shadow_list.data();
  desc.stats = &stats;
  desc.visibility = options.visibility;
  desc.supersampling = options.supersampling;
  for (size_t c = 0; c < 4; ++c) desc.clear_color[c] = options.background[c];
  set_environment(options, stage.environment.get(), desc);
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
