// SPDX-License-Identifier: MIT
// polyhedron/<kind>/<what>/<target>/triangles:1000: 2^14 random places inside a ball of 1,000 triangles on one thread;
// items are places. `interpolate` gives three values of each place, `weights` all 502 coordinates; `s_per_million` is
// the time of 10^6 places.
#include <cmath>
#include <string>

#include "bench.h"

namespace shd::bench {
namespace {

constexpr size_t kPlaces = 16384;
constexpr uint32_t kRings = 21, kSides = 25;  // 2 (kRings - 1) kSides triangles

/// A ball of radius 1 with places inside, and columns for the results.
struct Ball {
  std::vector<float> position[3], place[3];
  std::vector<uint32_t> index;
  std::vector<float> result;  // [vertex][place]

  void add_vertex(double x, double y, double z) {
    const double p[3] = {x, y, z};
    for (int c = 0; c < 3; ++c) position[c].push_back(static_cast<float>(p[c]));
  }

  Ball() {
    const double pi = 3.14159265358979324;
    add_vertex(0, 0, 1);
    for (uint32_t r = 1; r < kRings; ++r) {
      for (uint32_t s = 0; s < kSides; ++s) {
        const double a = pi * r / kRings, b = 2 * pi * s / kSides;
        add_vertex(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
      }
    }
    add_vertex(0, 0, -1);
    const auto last = static_cast<uint32_t>(position[0].size() - 1);
    const auto at = [](uint32_t r, uint32_t s) { return 1 + (r - 1) * kSides + s % kSides; };
    for (uint32_t s = 0; s < kSides; ++s) {
      index.insert(index.end(), {0, at(1, s), at(1, s + 1)});
      for (uint32_t r = 1; r + 1 < kRings; ++r) {
        const uint32_t a = at(r, s), b = at(r, s + 1), c = at(r + 1, s), d = at(r + 1, s + 1);
        index.insert(index.end(), {a, c, d, a, d, b});
      }
      index.insert(index.end(), {last, at(kRings - 1, s + 1), at(kRings - 1, s)});
    }
    uint32_t random = 1;
    const auto next = [&] {
      random = random * 1664525u + 1013904223u;
      return 2.0f * static_cast<float>(random >> 8) * 0x1p-24f - 1.0f;
    };
    while (place[0].size() < kPlaces) {
      const float x = next(), y = next(), z = next();
      if (x * x + y * y + z * z > 0.9f) continue;
      place[0].push_back(x), place[1].push_back(y), place[2].push_back(z);
    }
    result.resize(position[0].size() * kPlaces);
  }
};

void run(benchmark::State& state, shd_simd simd, shd_barycentric kind, bool has_weights) {
  static Ball ball;
  shd_context* context = make_context(simd);
  shd_polyhedron* polyhedron = nullptr;
  shd_polyhedron_desc desc = shd_polyhedron_desc_default();
  desc.kind = kind;
  desc.vertex_count = ball.position[0].size();
  desc.index_count = ball.index.size();
  desc.indices.data = ball.index.data();
  for (int c = 0; c < 3; ++c) desc.position[c].data = ball.position[c].data();
  check(shd_polyhedron_create(context, &desc, &polyhedron));
  shd_polyhedron_points points = shd_polyhedron_points_default();
  points.count = kPlaces;
  for (int c = 0; c < 3; ++c) points.position[c].data = ball.place[c].data();
  std::vector<shd_f32_out> columns;
  for (size_t v = 0; v < desc.vertex_count; ++v) columns.push_back(shd_f32_out_column(&ball.result[v * kPlaces], 0));
  shd_polyhedron_weights weights = shd_polyhedron_weights_default();
  weights.weight = columns.data();
  weights.weight_count = columns.size();
  shd_polyhedron_values values = shd_polyhedron_values_default();
  values.vertex_value = desc.position;
  values.value = columns.data();
  values.value_count = 3;
  const Stopwatch watch;
  for (auto _ : state) {
    check(has_weights ? shd_polyhedron_evaluate(polyhedron, &points, &weights)
                      : shd_polyhedron_interpolate(polyhedron, &points, &values));
  }
  const double places = static_cast<double>(state.iterations()) * static_cast<double>(kPlaces);
  state.SetItemsProcessed(static_cast<int64_t>(places));
  state.counters["s_per_million"] = 1e6 / watch.items_per_second(places);
  shd_polyhedron_release(polyhedron);
  shd_context_release(context);
}

}  // namespace

void register_polyhedron() {
  for (const bool is_convex : {false, true}) {
    for (const bool has_weights : {false, true}) {
      for (const Target& target : targets()) {
        const std::string name = std::string("polyhedron/") + (is_convex ? "wachspress/" : "mean_value/") +
                                 (has_weights ? "weights/" : "interpolate/") + target.name + "/triangles:1000";
        const shd_barycentric kind = is_convex ? SHD_BARYCENTRIC_WACHSPRESS : SHD_BARYCENTRIC_MEAN_VALUE;
        benchmark::RegisterBenchmark(name.c_str(), [simd = target.simd, kind, has_weights](benchmark::State& state) {
          run(state, simd, kind, has_weights);
        })->Unit(benchmark::kMillisecond);
      }
    }
  }
}

}  // namespace shd::bench
