// SPDX-License-Identifier: MIT
#include <fstream>

#include "bench.h"
#include "peers/peers.h"
#include "usage.h"

namespace shd::bench {

std::vector<Target> targets() {
  std::vector<Target> found;
  for (int simd = SHD_SIMD_SCALAR; simd <= SHD_SIMD_WASM; ++simd) {
    shd_context_desc desc = shd_context_desc_default();
    desc.worker_count = 1;
    desc.simd = static_cast<shd_simd>(simd);
    shd_context* context = nullptr;
    if (shd_context_create(&desc, &context) != SHD_OK) continue;
    found.push_back({desc.simd, shd_context_get_simd_target(context)});
    shd_context_release(context);
  }
  return found;
}

shd_context* make_context(shd_simd simd, uint32_t workers) {
  shd_context_desc desc = shd_context_desc_default();
  desc.worker_count = workers;
  desc.simd = simd;
  shd_context* context = nullptr;
  check(shd_context_create(&desc, &context));
  return context;
}

namespace {

std::string cpu_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

std::string version() {
  const uint32_t number = shd_version();
  return std::to_string(number >> 16) + '.' + std::to_string(number >> 8 & 255) + '.' + std::to_string(number & 255);
}

/// SIMD targets, the best one first.
std::string target_names() {
  std::string names;
  for (const Target& target : targets()) names = names.empty() ? target.name : target.name + ' ' + names;
  return names;
}

void add_context() {
  benchmark::AddCustomContext("cpu", cpu_name());
  benchmark::AddCustomContext("shd", version());
  benchmark::AddCustomContext("simd", target_names());
  benchmark::AddCustomContext("compiler", SHD_BENCH_COMPILER);
  if (*SHD_BENCH_COMMIT) benchmark::AddCustomContext("commit", SHD_BENCH_COMMIT);
#ifdef SHD_BENCH_OSMESA
  benchmark::AddCustomContext("llvmpipe", llvmpipe_description());
#endif
#ifdef SHD_BENCH_LAVAPIPE
  const std::string problem = lavapipe_problem();
  benchmark::AddCustomContext("lavapipe", problem.empty() ? lavapipe_description() : "left out: " + problem);
#endif
#ifdef SHD_BENCH_OIIO
  benchmark::AddCustomContext("openimageio", openimageio_description());
#endif
#ifdef SHD_BENCH_OCIO
  benchmark::AddCustomContext("opencolorio", opencolorio_description());
#endif
}

}  // namespace
}  // namespace shd::bench

int main(int argc, char** argv) {
  shd::bench::read_usage(argc, argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  shd::bench::add_context();
  shd::bench::register_frame_peers();
  shd::bench::register_surface_peers();
  shd::bench::register_texture_peers();
  shd::bench::register_frame();
  shd::bench::register_surface();
  shd::bench::register_lights();
  shd::bench::register_volume();
  shd::bench::register_texture();
  shd::bench::register_texture_create();
  shd::bench::register_texture_worst();
  shd::bench::register_directions();
  shd::bench::register_calls();
  shd::bench::register_scaling();
  shd::bench::register_shadow();
  shd::bench::register_solid();
  shd::bench::register_polyhedron();
  shd::bench::register_occlusion();
  shd::bench::register_quality();
  shd::bench::register_defaults();
  shd::bench::register_mesh();
#ifdef SHD_BENCH_OIIO
  shd::bench::register_load();
  shd::bench::register_tiles();
#endif
#ifdef SHD_BENCH_COLOR
  shd::bench::register_display();
  shd::bench::register_present();
#endif
  const size_t matched = benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return shd::bench::status_of(matched);
}
