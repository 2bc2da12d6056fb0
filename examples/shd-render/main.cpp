// SPDX-License-Identifier: MIT
/// shd-render: a picture of a 3D model. An example of everything that an application does with shd.
#include <chrono>
#include <cstdio>
#include <exception>

#include <unistd.h>

#include "camera.h"
#include "failure.h"
#include "import.h"
#include "lights.h"
#include "output.h"
#include "scene.h"
#include "shadows.h"
#include "shapes.h"
#include "teapot.h"

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Prints percentages to stderr once a render has taken a while.
struct Progress {
  Clock::time_point start = Clock::now();
  int shown = -1;
};

int32_t report_progress(void* user_data, float fraction) {
  Progress& progress = *static_cast<Progress*>(user_data);
  const int percent = static_cast<int>(100.0f * fraction);
  if (percent > progress.shown && (progress.shown >= 0 || seconds_since(progress.start) > 0.5)) {
    std::fprintf(stderr, "\rrendering %3d %%", percent);
    std::fflush(stderr);
    progress.shown = percent;
  }
  return 0;
}

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
  desc.samples = options.samples;
  desc.aovs = options.aov ? SHD_AOV_UV | SHD_AOV_NORMAL | SHD_AOV_TRIANGLE : SHD_AOV_NONE;
  Framebuffer framebuffer;
  check(shd_framebuffer_create(context, &desc, framebuffer.out()), "framebuffer");
  return framebuffer;
}

void render(shd_context* context, const Options& options, const Scene& scene, const shd_view& view,
            const std::vector<StageLight>& lights, const std::vector<Shadow>& shadows, shd_framebuffer* framebuffer) {
  std::vector<const shd_light*> light_list;
  for (const StageLight& light : lights) light_list.push_back(light.light.get());
  std::vector<const shd_shadow*> shadow_list;
  for (const Shadow& shadow : shadows) shadow_list.push_back(shadow.get());
  Progress progress;
  shd_render_stats stats = shd_render_stats_default();
  shd_render_desc desc = shd_render_desc_default();
  desc.framebuffer = framebuffer;
  desc.view = view;
  desc.draws = scene.draws.data();
  desc.draw_count = scene.draws.size();
  desc.lights = light_list.data();
  desc.light_count = light_list.size();
  if (!shadow_list.empty()) desc.shadows = shadow_list.data();
  desc.stats = &stats;
  for (size_t c = 0; c < 4; ++c) desc.clear_color[c] = options.background[c];
  if (options.progress || isatty(STDERR_FILENO)) desc.progress = {report_progress, &progress};
  const shd_result result = shd_render(context, &desc);
  const double seconds = seconds_since(progress.start);
  if (progress.shown >= 0) std::fputc('\n', stderr);
  check(result, "render");
  if (options.stats) {
    std::fprintf(stderr, "%llu triangles, %llu rasterised, %llu fragments in %.1f ms on %s with %u workers\n",
                 static_cast<unsigned long long>(stats.triangles), static_cast<unsigned long long>(stats.rasterised),
                 static_cast<unsigned long long>(stats.fragments), 1e3 * seconds, shd_context_simd_target(context),
                 shd_context_worker_count(context));
  }
}

Model make_model(const Options& options) {
  if (!options.model.empty()) return import_model(options.model);
  if (options.shape == Shape::kSphere) return make_sphere(options.tessellation);
  if (options.shape == Shape::kPlane) return make_plane(options.tessellation);
  return make_teapot(options.tessellation);
}

void run(const Options& options) {
  check_output_name(options);
  Model model = make_model(options);
  const Bounds bounds = bounds_of(model);
  const Camera camera = make_camera(options, model, bounds);
  if (options.floor) add_floor(model, bounds);
  const Context context = make_context(options);
  const Scene scene = make_scene(context.get(), model, options, camera);
  const std::vector<StageLight> lights = make_lights(context.get(), options, model_of(options, model), bounds, camera);
  const std::vector<Shadow> shadows = make_shadows(context.get(), options, bounds, scene, lights);
  const Framebuffer framebuffer = make_framebuffer(context.get(), options);
  render(context.get(), options, scene, camera.view, lights, shadows, framebuffer.get());
  save_picture(context.get(), framebuffer.get(), options);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Options options = parse_options(argc, argv);
    if (options.help) {
      std::fputs(help_text(), stdout);
    } else {
      run(options);
    }
    return kExitOk;
  } catch (const Failure& failure) {
    std::fprintf(stderr, "shd-render: %s\n", failure.what());
    return failure.code;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "shd-render: %s\n", error.what());
    return kExitFailed;
  }
}
