// SPDX-License-Identifier: MIT
// shade/<model>/lights:<n>/<target>: only the kernels of a model, lobes and coefficients, over batches of fragments in
// cache; point lights that reach all fragments, random normals and directions. Items are fragments.
// shade_over_normals/...: the same with lobes averaged over the normals of a filtered map.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <random>
#include <string>

#include "core/simd_target.h"
#include "shade/combine.h"
#include "shade/illuminate.h"

#include <hwy/highway.h>

namespace shd::bench {
namespace {

const core::Allocator g_allocator = {core::default_allocator()};

struct Model {
  const char* name;
  shd_model model;
};
constexpr Model kModels[] = {{"lambert", SHD_MODEL_LAMBERT},
                             {"phong", SHD_MODEL_PHONG},
                             {"blinn_phong", SHD_MODEL_BLINN_PHONG},
                             {"blinn_phong_normalized", SHD_MODEL_BLINN_PHONG_NORMALIZED},
                             {"combined", SHD_MODEL_COMBINED},
                             {"gooch", SHD_MODEL_GOOCH},
                             {"toon", SHD_MODEL_TOON},
                             {"metallic_roughness", SHD_MODEL_METALLIC_ROUGHNESS}};

/// One full batch of fragments, and its lights.
struct Batch {
  material::Material material;
  shade::LightTable lights = {};
  shade::ActiveLight active[8];
  raster::Fragments rows;
  shade::Columns columns;
};

void set_unit(std::mt19937* random, float* x, float* y, float* z) {
  std::normal_distribution<float> normal;
  const float v[3] = {normal(*random), normal(*random), std::fabs(normal(*random)) + 0.5f};
  const float length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  *x = v[0] / length;
  *y = v[1] / length;
  *z = v[2] / length;
}

std::unique_ptr<Batch> make_batch(shd_model model, size_t light_count) {
  auto batch = std::make_unique<Batch>();
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(-1.0f, 1.0f);
  raster::allocate(g_allocator, &batch->rows);
  shade::allocate(g_allocator, 1, &batch->columns);
  raster::Fragments& f = batch->rows;
  f.count = raster::kBatch;
  for (size_t i = 0; i < f.count; ++i) {
    f.px[i] = place(random);
    f.py[i] = place(random);
    f.pz[i] = place(random);
    set_unit(&random, f.nx + i, f.ny + i, f.nz + i);
    set_unit(&random, f.ox + i, f.oy + i, f.oz + i);
  }
  shd_material_desc desc = shd_material_desc_default();
  desc.model = model;
  const material::SlotInput slots[material::kSlotCount] = {};
  material::build(desc, slots, &batch->material);
  batch->lights.lights = core::Array<light::Light>(g_allocator, light_count);
  batch->lights.count = light_count;
  for (size_t i = 0; i < light_count; ++i) {
    shd_light_desc light = shd_light_desc_default();
    light.position[0] = 3.0f * place(random);
    light.position[1] = 3.0f * place(random);
    light.position[2] = 4.0f;
    batch->lights.lights[i] = light::make_light(light, nullptr, nullptr);
    batch->active[i] = {&batch->lights.lights[i], {nullptr, nullptr, nullptr}};
  }
  return batch;
}

/// Slopes with deviations of 0.1 to 0.5 across every normal.
shade::LobeShape make_spread(Batch* batch) {
  std::mt19937 random(8);
  std::uniform_real_distribution<float> deviation(0.1f, 0.5f);
  shade::LobeShape shape = {};
  for (int k = 0; k < 6; ++k) {
    shape.spread[k] = batch->columns.spread[k];
    for (size_t i = 0; i < raster::kBatch; ++i) batch->columns.spread[k][i] = deviation(random);
  }
  return shape;
}

void run(benchmark::State& state, shd_model model, size_t light_count, bool over_normals,
         const core::SimdTarget& target) {
  const std::unique_ptr<Batch> batch = make_batch(model, light_count);
  const material::Parameters parameters = {};
  const shade::LobeShape shape = over_normals ? make_spread(batch.get()) : shade::LobeShape();
  for (auto _ : state) {
    shade::illuminate(target, batch->material, shape, batch->active, light_count, batch->rows, {false, true},
                      &batch->columns.lobes);
    shade::combine(target, batch->material, batch->lights, batch->columns.lobes, parameters, batch->rows.count,
                   &batch->columns.radiance);
    benchmark::DoNotOptimize(batch->columns.radiance.channel[0][0]);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(raster::kBatch));
}

void register_all() {
  for (const int64_t bit : hwy::SupportedAndGeneratedTargets()) {
    const core::SimdTarget target = core::simd_target_from_bit(bit);
    for (const Model& model : kModels) {
      for (const size_t lights : {1, 2, 8}) {
        for (const bool over_normals : {false, true}) {
          const std::string name = std::string(over_normals ? "shade_over_normals/" : "shade/") + model.name +
                                   "/lights:" + std::to_string(lights) + "/" + target.name;
          benchmark::RegisterBenchmark(
              name.c_str(), [=](benchmark::State& state) { run(state, model.model, lights, over_normals, target); });
        }
      }
    }
  }
}

}  // namespace
}  // namespace shd::bench

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  shd::bench::register_all();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
