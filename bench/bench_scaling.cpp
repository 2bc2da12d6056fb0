// SPDX-License-Identifier: MIT
// scaling/<work>/workers:<n>: wall time of work that is split over the workers of one context. mipmap: the levels below
// a borrowed base; the filters: one lookup per pixel of the floor; frame_spheres: the frame of 2k triangles;
// frame_floor: the frame of the trilinear floor. speedup is the rate divided by the rate of one worker.
#include <chrono>
#include <thread>

#include "frame_scene.h"
#include "texture_setup.h"

namespace shd::bench {
namespace {

constexpr uint32_t kMipmapEdge = 8192, kLookupEdge = 2048;

std::string row_name(const std::string& what, uint32_t workers) {
  return "scaling/" + what + "/workers:" + std::to_string(workers);
}

/// Runs the loop and reports its rate by wall time.
template <class Body>
void measure(benchmark::State& state, const std::string& what, uint32_t workers, size_t items, Body body) {
  using Clock = std::chrono::steady_clock;
  body();  // a virtual machine provides memory slowly the first time
  const Clock::time_point start = Clock::now();
  for (auto _ : state) body();
  const std::chrono::duration<double> time = Clock::now() - start;
  const double rate = static_cast<double>(state.iterations()) * static_cast<double>(items) / time.count();
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(items));
  record_rate(row_name(what, workers), rate);
  const double one = recorded_rate(row_name(what, 1));
  if (one > 0.0) state.counters["speedup"] = rate / one;
}

void run_mipmap(benchmark::State& state, uint32_t workers) {
  const size_t size = size_t{kMipmapEdge} * kMipmapEdge * 4;
  std::vector<uint8_t> texels(size + SHD_TEXTURE_PADDING);
  for (size_t i = 0; i < size; ++i) texels[i] = static_cast<uint8_t>(i * 2654435761u >> 13);
  shd_context* context = make_context(SHD_SIMD_BEST, workers);
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = SHD_FORMAT_RGBA8;
  desc.width = desc.height = kMipmapEdge;
  desc.texels = texels.data();
  desc.flags |= SHD_TEXTURE_BORROW;
  desc.tables = SHD_TABLE_MIPMAP;
  measure(state, "mipmap", workers, size / 4, [&] {
    shd_texture* texture = nullptr;
    check(shd_texture_create(context, &desc, &texture));
    shd_texture_release(texture);
  });
  shd_context_release(context);
}

void run_filter(benchmark::State& state, const Filter& filter, uint32_t workers) {
  const Sampling sampling(SHD_SIMD_BEST, filter, kRgba8, kLookupEdge, make_rgba8(kLookupEdge), workers);
  const Lookups floor = floor_lookups(Floor::of_texture(kLookupEdge));
  const shd_lookups columns = columns_of(floor, filter);
  std::vector<float> channels[4];
  shd_texels out = {};
  for (size_t c = 0; c < 4; ++c) {
    channels[c].resize(columns.count);
    out.channel[c].data = channels[c].data();
  }
  measure(state, filter.name, workers, columns.count, [&] { sampling.run(columns, &out); });
}

void run_spheres(benchmark::State& state, uint32_t workers) {
  const Spheres& spheres = sphere_frames()[0];
  FrameScene scene(spheres, SHD_SIMD_BEST, {"spheres", 1, true, SHD_BLEND_OPAQUE}, workers);
  measure(state, "frame_spheres", workers, spheres.triangle_count(), [&] { scene.render(); });
}

void run_floor(benchmark::State& state, uint32_t workers) {
  const Surface floor = floor_surface(Floor::of_texture(kFrameTextureEdge));
  FrameScene scene(floor, SHD_SIMD_BEST, SHD_FILTER_TRILINEAR, SHD_FORMAT_RGBA32F, workers);
  measure(state, "frame_floor", workers, kLookupCount, [&] { scene.render(); });
}

template <class Body>
void add(const std::string& name, Body body) {
  benchmark::RegisterBenchmark(name.c_str(), body)->UseRealTime()->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_scaling() {
  std::vector<uint32_t> counts = {1};
  while (2 * counts.back() <= std::thread::hardware_concurrency()) counts.push_back(2 * counts.back());
  for (const uint32_t n : counts) {
    add(row_name("mipmap", n), [=](benchmark::State& state) { run_mipmap(state, n); });
    add(row_name("frame_spheres", n), [=](benchmark::State& state) { run_spheres(state, n); });
    add(row_name("frame_floor", n), [=](benchmark::State& state) { run_floor(state, n); });
  }
  for (const Filter& filter : kFilters) {
    if (!has_own_peers(filter) && filter.filter != SHD_FILTER_EWA) continue;
    for (const uint32_t n : counts) {
      add(row_name(filter.name, n), [=](benchmark::State& state) { run_filter(state, filter, n); });
    }
  }
}

}  // namespace shd::bench
