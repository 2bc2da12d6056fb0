// SPDX-License-Identifier: MIT
// frame/{quad,floor}/{trilinear,anisotropic}/<target or peer>: one textured surface over 1024 x 1024 pixels, unlit, one
// thread; the quad minifies twice, the floor is the floor of the texture rows. Items are pixels.
// frame/.../<filter>_rgba8/<target>: the same into RGBA8 pixels, as llvmpipe writes them, instead of float planes;
// <filter>_fast_rgba8 also with SHD_PRECISION_FAST.
#include <memory>

#include "frame_scene.h"
#include "peers/peers.h"

namespace shd::bench {
namespace {

struct Row {
  const char* name;
  Surface surface;
  SurfaceFilter filter;
  PeerFilter peer;
  const char* peer_row;  // row of the same surface and filter that a peer has
  shd_format color;
};

const std::vector<Row>& rows() {
  static const Surface quad = quad_surface(2.0f), floor = floor_surface(Floor::of_texture(kFrameTextureEdge));
  static const SurfaceFilter trilinear(SHD_FILTER_TRILINEAR), anisotropic(SHD_FILTER_ANISOTROPIC);
  static const SurfaceFilter trilinear_fast(SHD_FILTER_TRILINEAR, SHD_PRECISION_FAST);
  static const SurfaceFilter anisotropic_fast(SHD_FILTER_ANISOTROPIC, SHD_PRECISION_FAST);
  constexpr PeerFilter kTrilinear = PeerFilter::kTrilinear, kAnisotropic = PeerFilter::kAnisotropic16;
  constexpr shd_format kPlanes = SHD_FORMAT_RGBA32F, kPixels = SHD_FORMAT_RGBA8;
  static const std::vector<Row> all = {
      {"quad/trilinear", quad, trilinear, kTrilinear, "quad/trilinear", kPlanes},
      {"quad/trilinear_rgba8", quad, trilinear, kTrilinear, "quad/trilinear", kPixels},
      {"quad/trilinear_fast_rgba8", quad, trilinear_fast, kTrilinear, "quad/trilinear", kPixels},
      {"floor/trilinear", floor, trilinear, kTrilinear, "floor/trilinear", kPlanes},
      {"floor/trilinear_rgba8", floor, trilinear, kTrilinear, "floor/trilinear", kPixels},
      {"floor/trilinear_fast_rgba8", floor, trilinear_fast, kTrilinear, "floor/trilinear", kPixels},
      {"floor/anisotropic", floor, anisotropic, kAnisotropic, "floor/anisotropic", kPlanes},
      {"floor/anisotropic_rgba8", floor, anisotropic, kAnisotropic, "floor/anisotropic", kPixels},
      {"floor/anisotropic_fast_rgba8", floor, anisotropic_fast, kAnisotropic, "floor/anisotropic", kPixels}};
  return all;
}

std::string row_name(const char* row, const std::string& who) {
  return std::string("frame/") + row + "/" + who;
}

void run_shd(benchmark::State& state, const Row& row, const Target& target) {
  FrameScene scene(row.surface, target.simd, row.filter, row.color);
  scene.render();
  const Stopwatch watch;
  for (auto _ : state) scene.render();
  const double rate = watch.items_per_second(static_cast<double>(state.iterations()));
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(kLookupCount));
  const double other = recorded_rate(row_name(row.peer_row, "llvmpipe"));
  if (other > 0.0) state.counters["ratio_llvmpipe"] = rate / other;
}

#ifdef SHD_BENCH_OSMESA
void run_llvmpipe(benchmark::State& state, const Row& row) {
  const std::unique_ptr<Peer> peer =
      make_llvmpipe_surface(row.surface, kFrameEdge, kFrameTextureEdge, frame_texels(), row.peer);
  peer->run();
  const Stopwatch watch;
  for (auto _ : state) peer->run();
  record_rate(row_name(row.peer_row, "llvmpipe"), watch.items_per_second(static_cast<double>(state.iterations())));
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(kLookupCount));
  FrameScene scene(row.surface, SHD_SIMD_BEST, row.filter, row.color);
  scene.render();
  const Difference difference = compare(scene.image(), peer->image());
  state.counters["mean_difference"] = difference.mean;
  state.counters["max_difference"] = difference.max;
}
#endif

template <class Body>
void add(const std::string& name, Body body) {
  benchmark::RegisterBenchmark(name.c_str(), body)->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_surface_peers() {
#ifdef SHD_BENCH_OSMESA
  for (const Row& row : rows()) {
    if (row.color != SHD_FORMAT_RGBA32F) continue;
    add(row_name(row.name, "llvmpipe"), [&row](benchmark::State& state) { run_llvmpipe(state, row); });
  }
#endif
}

void register_surface() {
  for (const Row& row : rows()) {
    for (const Target& target : targets()) {
      add(row_name(row.name, target.name), [&row, target](benchmark::State& state) { run_shd(state, row, target); });
    }
  }
}

}  // namespace shd::bench
