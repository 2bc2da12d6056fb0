// SPDX-License-Identifier: MIT
// frame/lights:<n>/<target>: a plane over 1024 x 1024 pixels under n point lights whose range covers a 64th of it,
// spread evenly; Blinn-Phong per fragment, one thread. `over_8` is the time divided by the time for 8 lights.
// frame/model:<name>/<target>: the same plane with every model under two lights without range. Items are pixels.
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
    shd_framebuffer_release(framebuffer_);
    shd_material_release(material_);
    shd_mesh_release(mesh_);
    shd_context_release(context_);
  }
  Plane(const Plane&) = delete;
  Plane& operator=(const Plane&) = delete;

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

}  // namespace

void register_lights() {
  for (const Target& target : targets()) {
    for (const uint32_t count : {8u, 64u, 256u}) {
      benchmark::RegisterBenchmark(lights_name(count, target).c_str(),
                                   [=](benchmark::State& state) { run_lights(state, count, target); });
    }
    for (const Model& model : kModels) {
      const std::string name = std::string("frame/model:") + model.name + "/" + target.name;
      benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        Plane plane(target.simd, model.model, 2, false);
        run(state, &plane);
      });
    }
  }
}

}  // namespace shd::bench
