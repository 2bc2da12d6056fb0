// SPDX-License-Identifier: MIT
#pragma once

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include <shd/shd.h>

namespace shd::bench {

/// Ends the program with the error text if a call fails, because a benchmark of a failing call is meaningless.
inline void check(shd_result result) {
  if (result == SHD_OK) return;
  std::fprintf(stderr, "%s: %s\n", shd_result_name(result), shd_last_error());
  std::exit(1);
}

/// A SIMD target that this machine and build provide, with the library's name for it.
struct Target {
  shd_simd simd;
  std::string name;
};
std::vector<Target> targets();

/// A context on the calling thread alone, or with workers.
shd_context* make_context(shd_simd simd, uint32_t workers = 1);

/// Rate of a benchmark's loop, by the processor time of the whole process: other load of the machine does not change
/// ratios between rows, and extra threads of a peer are counted.
class Stopwatch {
 public:
  double items_per_second(double items) const {
    return items * CLOCKS_PER_SEC / static_cast<double>(std::clock() - start_);
  }

 private:
  std::clock_t start_ = std::clock();
};

/// Peers are registered first, so that the rows of shd can print their ratio.
void register_texture_peers();
void register_frame_peers();
void register_surface_peers();
void register_texture();
void register_texture_create();
void register_texture_worst();
void register_directions();
void register_calls();
void register_scaling();
void register_shadow();
void register_solid();
void register_polyhedron();
void register_occlusion();
void register_quality();
void register_defaults();
void register_frame();
void register_surface();
void register_lights();
void register_volume();
void register_mesh();
void register_load();
void register_tiles();
void register_display();
void register_present();

}  // namespace shd::bench
