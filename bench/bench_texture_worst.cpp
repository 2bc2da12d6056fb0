// SPDX-License-Identifier: MIT
// worst/<filter>/<target>: cost of the slowest lookup relative to the usual one. worst_ns and median_ns are over kinds
// of footprint that any caller can pass, at random positions of one texture; floor_ns is the median row of the floor.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>

#include "texture_setup.h"

namespace shd::bench {
namespace {

constexpr uint32_t kEdge = 2048;
constexpr size_t kCount = 4096;
constexpr int kRepeats = 5;

/// Footprints by their axes in texels, at random angles.
struct Kind {
  const char* name;
  float longer, shorter;
};
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr Kind kKinds[] = {
    {"point", 0.0f, 0.0f},           {"texel", 1.0f, 1.0f},        {"round_100", 100.0f, 100.0f},
    {"long_16", 16.0f, 1.0f},        {"long_30", 30.0f, 1.9f},     {"long_1000", 1000.0f, 60.0f},
    {"needle", 1000.0f, 1e-3f},      {"thin_4", 4.0f, 1e-6f},      {"denormal", 1e-40f, 1e-42f},
    {"huge", 1e30f, 1e10f},          {"huge_round", 1e30f, 1e30f}, {"infinite", kInfinity, kInfinity},
    {"half_infinite", kInfinity, 0}, {"nan", kNaN, kNaN},
};

Lookups lookups_of(const Kind& kind) {
  std::minstd_rand random(7);
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  Lookups q;
  for (size_t i = 0; i < kCount; ++i) {
    const float angle = 6.2831853f * unit(random), c = std::cos(angle) / kEdge, s = std::sin(angle) / kEdge;
    q.u.push_back(unit(random));
    q.v.push_back(unit(random));
    q.dudx.push_back(kind.longer * c);
    q.dvdx.push_back(kind.longer * s);
    q.dudy.push_back(-kind.shorter * s);
    q.dvdy.push_back(kind.shorter * c);
  }
  return q;
}

shd_lookups part_of(const Lookups& q, size_t first, size_t count) {
  shd_lookups part = shd_lookups_default();
  part.count = count;
  part.u.data = q.u.data() + first;
  part.v.data = q.v.data() + first;
  part.dudx.data = q.dudx.data() + first;
  part.dvdx.data = q.dvdx.data() + first;
  part.dudy.data = q.dudy.data() + first;
  part.dvdy.data = q.dvdy.data() + first;
  return part;
}

/// Shortest time of some runs, in nanoseconds per lookup.
double time_of(const Sampling& sampling, const shd_lookups& columns) {
  using Clock = std::chrono::steady_clock;
  std::vector<float> channels[4];
  shd_texels out = {};
  for (size_t c = 0; c < 4; ++c) {
    channels[c].resize(columns.count);
    out.channel[c].data = channels[c].data();
  }
  double best = 1e30;
  for (int k = 0; k < kRepeats; ++k) {
    const Clock::time_point start = Clock::now();
    sampling.run(columns, &out);
    best = std::min(best, std::chrono::duration<double, std::nano>(Clock::now() - start).count());
  }
  return best / static_cast<double>(columns.count);
}

double median_of(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

void run(benchmark::State& state, const Target& target, const Filter& filter) {
  const Sampling sampling(target.simd, filter, kRgba8, kEdge, make_rgba8(kEdge));
  const Lookups floor = floor_lookups(Floor::of_texture(kEdge));
  double worst = 0;
  const char* name = "";
  std::vector<double> rows, kinds;
  for (auto _ : state) {
    for (size_t first = 0; first < floor.count(); first += 16 * kFrameEdge) {
      rows.push_back(time_of(sampling, part_of(floor, first, kFrameEdge)));
    }
    for (const Kind& kind : kKinds) {
      kinds.push_back(time_of(sampling, part_of(lookups_of(kind), 0, kCount)));
      if (kinds.back() > worst) name = kind.name;
      worst = std::max(worst, kinds.back());
    }
  }
  const double median = median_of(kinds), floor_median = median_of(rows);
  state.SetLabel(name);
  state.counters["median_ns"] = median;
  state.counters["worst_ns"] = worst;
  state.counters["floor_ns"] = floor_median;
  state.counters["worst_over_median"] = worst / median;
  state.counters["worst_over_floor"] = worst / floor_median;
}

}  // namespace

void register_texture_worst() {
  for (const Target& target : targets()) {
    for (const Filter& filter : kFilters) {
      if (filter.filter == SHD_FILTER_EXACT) continue;  // its cost depends on its tolerance
      benchmark::RegisterBenchmark((std::string("worst/") + filter.name + "/" + target.name).c_str(),
                                   [=](benchmark::State& state) { run(state, target, filter); })
          ->Iterations(1)
          ->Unit(benchmark::kMillisecond);
    }
  }
}

}  // namespace shd::bench
