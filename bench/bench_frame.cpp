// SPDX-License-Identifier: MIT
// frame/spheres/<triangles>/<target or peer>: 1024 x 1024 pixels, one thread, a mipmapped RGBA8 texture with trilinear
// lookups, two point lights, Blinn-Phong per fragment, back faces culled. Items are triangles.
// frame/<variant>/<triangles>/<target>: the same frame with several samples, depth alone, RGBA8 pixels or
// half-transparent spheres, or with a vertex program, a normal map, shadows or lines (Feature); over_spheres is its
// time divided by the time of the plain frame.
// frame/draws/{one,10648}/<target>: 10,648 spheres of 18 triangles as one draw of one mesh, and as a draw each;
// over_one is the time divided by that of one draw.
#include <algorithm>
#include <memory>

#include "frame_scene.h"
#include "peers/peers.h"

namespace shd::bench {
namespace {

constexpr Variant kPlain = {"spheres", 1, true, SHD_BLEND_OPAQUE};
constexpr Variant kVariants[] = {
    {"msaa4", 4, true, SHD_BLEND_OPAQUE},
    {"msaa16", 16, true, SHD_BLEND_OPAQUE},
    {"depth", 1, false, SHD_BLEND_OPAQUE},
    {"blended", 1, true, SHD_BLEND_PREMULTIPLIED},
    {"rgba8", 1, true, SHD_BLEND_OPAQUE, SHD_FORMAT_RGBA8},
    {"weighted", 1, true, SHD_BLEND_WEIGHTED},
    {"sorted", 1, true, SHD_BLEND_SORTED},
    {"vertex_program", 1, true, SHD_BLEND_OPAQUE, SHD_FORMAT_RGBA32F, Feature::kVertexProgram},
    {"normal_map", 1, true, SHD_BLEND_OPAQUE, SHD_FORMAT_RGBA32F, Feature::kNormalMap},
    {"shadows", 1, true, SHD_BLEND_OPAQUE, SHD_FORMAT_RGBA32F, Feature::kShadows},
    {"lines", 1, true, SHD_BLEND_OPAQUE, SHD_FORMAT_RGBA32F, Feature::kLines}};

std::string row_name(const Spheres& spheres, const std::string& who, const Variant& variant = kPlain) {
  return std::string("frame/") + variant.name + "/" + spheres.name + "/" + who;
}

void finish(benchmark::State& state, const Spheres& spheres) {
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(spheres.triangle_count()));
  state.counters["triangles"] = static_cast<double>(spheres.triangle_count());
}

void run_shd(benchmark::State& state, const Spheres& spheres, const Target& target, const Variant& variant) {
  FrameScene scene(spheres, target.simd, variant);
  scene.render();
  const Stopwatch watch;
  for (auto _ : state) scene.render();
  const double rate = watch.items_per_second(static_cast<double>(state.iterations()));
  finish(state, spheres);
  state.counters["fragments"] = static_cast<double>(scene.stats().fragment_count);
  record_rate(row_name(spheres, target.name, variant), rate);
  const double plain = recorded_rate(row_name(spheres, target.name));
  if (variant.name != kPlain.name && plain > 0.0) state.counters["over_spheres"] = plain / rate;
  const bool peer_draws = variant.name == kPlain.name || variant.color == SHD_FORMAT_RGBA8;
  const double other = peer_draws ? recorded_rate(row_name(spheres, "llvmpipe")) : 0.0;
  if (other > 0.0) state.counters["ratio_llvmpipe"] = rate / other;
}

const Spheres& small_spheres() {
  static const Spheres all = make_spheres("10648", 3, 4, 22);
  return all;
}
const Spheres& small_spheres_in_one() {
  static const Spheres all = merge("one", small_spheres());
  return all;
}

void run_draws(benchmark::State& state, const Spheres& spheres, const Target& target) {
  const std::string name = "frame/draws/" + spheres.name + "/" + target.name;
  FrameScene scene(spheres, target.simd, kPlain);
  scene.render();
  const Stopwatch watch;
  for (auto _ : state) scene.render();
  const double rate = watch.items_per_second(static_cast<double>(state.iterations()));
  finish(state, spheres);
  record_rate(name, rate);
  const double one = recorded_rate("frame/draws/one/" + std::string(target.name));
  if (one > 0.0) state.counters["over_one"] = one / rate;
}

#ifdef SHD_BENCH_OSMESA
void run_llvmpipe(benchmark::State& state, const Spheres& spheres) {
  const std::unique_ptr<Peer> peer = make_llvmpipe_spheres(spheres, frame_texels());
  peer->run();
  const Stopwatch watch;
  for (auto _ : state) peer->run();
  record_rate(row_name(spheres, "llvmpipe"), watch.items_per_second(static_cast<double>(state.iterations())));
  finish(state, spheres);
  FrameScene scene(spheres, SHD_SIMD_BEST, kPlain);
  scene.render();
  const std::vector<float> ours = scene.image(), theirs = peer->image();
  const Difference difference = compare(ours, theirs);
  state.counters["mean_difference"] = difference.mean;
  state.counters["max_difference"] = difference.max;
  maybe_write("spheres-" + spheres.name + "-llvmpipe", theirs);
  maybe_write("spheres-" + spheres.name + "-shd", ours);
}
#endif

template <class Body>
void add(const std::string& name, Body body) {
  benchmark::RegisterBenchmark(name.c_str(), body)->Unit(benchmark::kMillisecond);
}

}  // namespace

void register_frame_peers() {
#ifdef SHD_BENCH_OSMESA
  for (const Spheres& spheres : sphere_frames()) {
    add(row_name(spheres, "llvmpipe"), [&spheres](benchmark::State& state) { run_llvmpipe(state, spheres); });
  }
#endif
}

void register_frame() {
  for (const Spheres& spheres : sphere_frames()) {
    for (const Target& target : targets()) {
      add(row_name(spheres, target.name),
          [&spheres, target](benchmark::State& state) { run_shd(state, spheres, target, kPlain); });
    }
    for (const Variant& variant : kVariants) {
      for (const Target& target : targets()) {
        add(row_name(spheres, target.name, variant),
            [&spheres, target, &variant](benchmark::State& state) { run_shd(state, spheres, target, variant); });
      }
    }
  }
  for (const auto spheres : {small_spheres_in_one, small_spheres}) {
    for (const Target& target : targets()) {
      const std::string name = spheres == small_spheres ? "10648" : "one";
      add("frame/draws/" + name + "/" + target.name,
          [spheres, target](benchmark::State& state) { run_draws(state, spheres(), target); });
    }
  }
}

}  // namespace shd::bench
