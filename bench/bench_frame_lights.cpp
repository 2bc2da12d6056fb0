// SPDX-License-Identifier: MIT
// frame/lights:<n>/<target>: a plane over 1024 x 1024 pixels under n point lights whose range covers a 64th of it,
// spread evenly; Blinn-Phong per fragment, one thread. `over_8` is the time divided by the time for 8 lights.
// frame/model:<name>/<target>: the same plane with every model under two lights without range. Items are pixels.
// frame/environment:<name>/<target>: the same plane in the light of an environment instead; `over_model` is the time
// divided by the time of frame/model. frame/background/<target>: an environment alone.
// environment/irradiance and environment/lobes: an environment of 1024 x 512 texels, made with harmonics alone or with
// the radiance and the lobes of GGX as well; one thread.
#include <algorithm>
#include <cmath>
#include <memory>

#include "bench.h"
#include "peers/peers.h"
#include "workload.h"

namespace shd::bench {
namespace {

struct Model {
  const char* name;
  shd_model model;
};
constexpr Model kModels[] = {{"unlit", SHD_MODEL_UNLIT},
                             {"lambert", SHD_MODEL_LAMBERT},
                             {"phong", SHD_MODEL_PHONG},
                             {"blinn_phong", SHD_MODEL_BLINN_PHONG},
                             {"blinn_phong_normalized", SHD_MODEL_BLINN_PHONG_NORMALIZED},
                             {"gooch", SHD_MODEL_GOOCH},
                             {"toon", SHD_MODEL_TOON},
                             {"metallic_roughness", SHD_MODEL_METALLIC_ROUGHNESS}};

/// The plane -1..1 across the whole picture, and lights in front of it.
class Plane {
 public:
  Plane(shd_simd simd, shd_model model, uint32_t light_count, bool ends) : context_(make_context(simd)) {
    make_mesh();
    shd_material_desc material = shd_material_desc_default();
    material.model = model;
    check(shd_material_create(context_, &material, &material_));
    make_lights(light_count, ends);
    shd_framebuffer_desc framebuffer = shd_framebuffer_desc_default();
    framebuffer.width = framebuffer.height = kFrameEdge;
    check(shd_framebuffer_create(context_, &framebuffer, &framebuffer_));
    draw_.mesh = mesh_;
    draw_.material = material_;
    desc_.framebuffer = framebuffer_;
    desc_.draws = &draw_;
    desc_.draw_count = 1;
    desc_.lights = lights_.data();
    desc_.light_count = lights_.size();
    desc_.view.eye[2] = 3.0f;
  }
  ~Plane() {
    for (const shd_light* light : lights_) shd_light_release(const_cast<shd_light*>(light));
    shd_environment_release(environment_);
    shd_framebuffer_release(framebuffer_);
    shd_material_release(material_);
    shd_mesh_release(mesh_);
    shd_context_release(context_);
  }
  Plane(const Plane&) = delete;
  Plane& operator=(const Plane&) = delete;

  /// Replaces the lights by an environment.
  void surround(shd_environment* environment) {
    desc_.light_count = 0;
    desc_.environment = environment_ = environment;
  }
  /// Shows the environment and no plane.
  void show_background() {
    desc_.draw_count = 0;
    desc_.background = SHD_BACKGROUND_ENVIRONMENT;
  }
  shd_context* context() const { return context_; }
  void render() { check(shd_render(context_, &desc_)); }

 private:
  void make_mesh() {
    const float x[4] = {-1.0f, 1.0f, 1.0f, -1.0f}, y[4] = {-1.0f, -1.0f, 1.0f, 1.0f}, z[4] = {0.5f, 0.5f, 0.5f, 0.5f};
    const uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
    shd_mesh_desc desc = shd_mesh_desc_default();
    desc.vertex_count = 4;
    desc.position[0].data = x;
    desc.position[1].data = y;
    desc.position[2].data = z;
    desc.indices.data = indices;
    desc.index_count = 6;
    check(shd_mesh_create(context_, &desc, &mesh_));
  }
  void make_lights(uint32_t count, bool ends) {
    const auto columns = static_cast<uint32_t>(std::ceil(std::sqrt(static_cast<double>(count))));
    const uint32_t rows = (count + columns - 1) / columns;
    for (uint32_t i = 0; i < count; ++i) {
      shd_light_desc desc = shd_light_desc_default();
      desc.position[0] = 2.0f * (static_cast<float>(i % columns) + 0.5f) / static_cast<float>(columns) - 1.0f;
      desc.position[1] = 2.0f * (static_cast<float>(i / columns) + 0.5f) / static_cast<float>(rows) - 1.0f;
      desc.position[2] = 0.55f;
      if (ends) desc.range = 0.15f;  // a disc of area 4 / 64 on the plane
      std::fill_n(desc.intensity, 3, 0.01f);
      shd_light* light = nullptr;
      check(shd_light_create(context_, &desc, &light));
      lights_.push_back(light);
    }
  }

  shd_context* context_;
  shd_mesh* mesh_ = nullptr;
  shd_material* material_ = nullptr;
  shd_environment* environment_ = nullptr;
  shd_framebuffer* framebuffer_ = nullptr;
  std::vector<const shd_light*> lights_;
  shd_draw draw_ = shd_draw_default();
  shd_render_desc desc_ = shd_render_desc_default();
};

std::string lights_name(uint32_t count, const Target& target) {
  return "frame/lights:" + std::to_string(count) + "/" + target.name;
}

double run(benchmark::State& state, Plane* plane) {
  plane->render();
  const Stopwatch watch;
  for (auto _ : state) plane->render();
  const double rate = watch.items_per_second(static_cast<double>(state.iterations()));
  state.SetItemsProcessed(state.iterations() * int64_t{kFrameEdge} * int64_t{kFrameEdge});
  return rate;
}

void run_lights(benchmark::State& state, uint32_t count, const Target& target) {
  Plane plane(target.simd, SHD_MODEL_BLINN_PHONG, count, true);
  const double rate = run(state, &plane);
  record_rate(lights_name(count, target), rate);
  const double few = recorded_rate(lights_name(8, target));
  if (few > 0.0) state.counters["over_8"] = few / rate;
}

constexpr uint32_t kSkyWidth = 1024, kSkyHeight = 512;

/// A sky of smooth noise with a small sun.
std::vector<float> make_sky() {
  std::vector<float> texels;
  for (uint32_t y = 0; y < kSkyHeight; ++y) {
    for (uint32_t x = 0; x < kSkyWidth; ++x) {
      const float u = static_cast<float>(x) / kSkyWidth, v = static_cast<float>(y) / kSkyHeight;
      const bool sun = x >= 300 && x < 304 && y >= 150 && y < 154;
      for (const float phase : {0.0f, 1.0f, 2.0f}) {
        texels.push_back(0.5f + 0.3f * std::sin(40.0f * u + phase) * std::sin(20.0f * v) + (sun ? 5000.0f : 0.0f));
      }
    }
  }
  return texels;
}

shd_environment* make_environment(shd_context* context, shd_environment_table_flags tables) {
  static const std::vector<float> texels = make_sky();
  shd_image image = shd_image_default();
  image.format = SHD_FORMAT_RGB32F;
  image.width = kSkyWidth;
  image.height = kSkyHeight;
  image.pixels = const_cast<float*>(texels.data());
  shd_environment_desc desc = shd_environment_desc_default();
  desc.image = &image;
  desc.tables = tables;
  shd_environment* environment = nullptr;
  check(shd_environment_create(context, &desc, &environment));
  return environment;
}

std::string model_name(const char* what, const Model& model, const Target& target) {
  return std::string("frame/") + what + ":" + model.name + "/" + target.name;
}

void run_model(benchmark::State& state, const Model& model, const Target& target) {
  Plane plane(target.simd, model.model, 2, false);
  record_rate(model_name("model", model, target), run(state, &plane));
}

void run_environment(benchmark::State& state, const Model& model, const Target& target) {
  Plane plane(target.simd, model.model, 2, false);
  plane.surround(make_environment(plane.context(), SHD_ENVIRONMENT_TABLE_ALL));
  const double rate = run(state, &plane), lit = recorded_rate(model_name("model", model, target));
  if (lit > 0.0) state.counters["over_model"] = lit / rate;
}

void run_background(benchmark::State& state, const Target& target) {
  Plane plane(target.simd, SHD_MODEL_LAMBERT, 2, false);
  plane.surround(make_environment(plane.context(), SHD_ENVIRONMENT_TABLE_RADIANCE));
  plane.show_background();
  run(state, &plane);
}

void run_create(benchmark::State& state, shd_environment_table_flags tables) {
  shd_context* context = make_context(SHD_SIMD_BEST);
  shd_environment_release(make_environment(context, tables));
  for (auto _ : state) shd_environment_release(make_environment(context, tables));
  state.SetItemsProcessed(state.iterations() * int64_t{kSkyWidth} * int64_t{kSkyHeight});
  shd_context_release(context);
}

}  // namespace

void register_lights() {
  benchmark::RegisterBenchmark("environment/irradiance",
                               [](benchmark::State& state) { run_create(state, SHD_ENVIRONMENT_TABLE_NONE); });
  benchmark::RegisterBenchmark("environment/lobes",
                               [](benchmark::State& state) { run_create(state, SHD_ENVIRONMENT_TABLE_GGX); });
  for (const Target& target : targets()) {
    for (const uint32_t count : {8u, 64u, 256u}) {
      benchmark::RegisterBenchmark(lights_name(count, target).c_str(),
                                   [=](benchmark::State& state) { run_lights(state, count, target); });
    }
    for (const Model& model : kModels) {
      benchmark::RegisterBenchmark(model_name("model", model, target).c_str(),
                                   [=](benchmark::State& state) { run_model(state, model, target); });
      benchmark::RegisterBenchmark(model_name("environment", model, target).c_str(),
                                   [=](benchmark::State& state) { run_environment(state, model, target); });
    }
    benchmark::RegisterBenchmark((std::string("frame/background/") + target.name).c_str(),
                                 [=](benchmark::State& state) { run_background(state, target); });
  }
}

}  // namespace shd::bench
