// SPDX-License-Identifier: MIT
// texture/<projection>_<filter>/rgba8/<target>/<sphere or random>: lookups of directions, one for each pixel of a
// 1024 x 1024 frame, from one thread. The sphere is a mirror; random directions have a footprint of 1.5 texels.
// texture/plane_of_<projection>_<filter>/...: a 2D texture of the same texels at the same points, with the same
// footprints; ratio_plane is the rate of the row before, divided by this one's.
#include <cmath>
#include <map>
#include <memory>

#include "bench.h"
#include "workload.h"

namespace shd::bench {
namespace {

struct Kind {
  const char* name;
  shd_projection projection;
  uint32_t width, height, layers;
  float angle;  // between neighbouring texels [rad]
};
constexpr Kind kKinds[] = {{"cube", SHD_PROJECTION_CUBE, 512, 512, 6, 0.00307f},
                           {"lat_long", SHD_PROJECTION_LAT_LONG, 2048, 1024, 1, 0.00307f},
                           {"octahedral", SHD_PROJECTION_OCTAHEDRAL, 1254, 1254, 1, 0.00283f}};

struct DirectionFilter {
  const char* name;
  shd_filter filter;
};
constexpr DirectionFilter kDirectionFilters[] = {{"bilinear", SHD_FILTER_BILINEAR},
                                                 {"trilinear", SHD_FILTER_TRILINEAR},
                                                 {"anisotropic", SHD_FILTER_ANISOTROPIC},
                                                 {"ewa", SHD_FILTER_EWA}};

/// Directions and their changes: x, y, z, then per pixel step in x, then in y; and their points in an image.
struct Directions {
  std::vector<float> column[9], point[6];
  std::vector<uint32_t> face;
};

void normalize(double* n) {
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for (int c = 0; c < 3; ++c) n[c] /= length;
}

/// Direction in which a mirror sphere, or the scene around it, is seen.
void seen(double x, double y, double* n) {
  const double p = 2.2 * x / kFrameEdge - 1.1, q = 1.1 - 2.2 * y / kFrameEdge, rest = 1.0 - p * p - q * q;
  n[0] = p, n[1] = q, n[2] = -1.0;
  if (rest > 0.0) {
    const double z = std::sqrt(rest);
    n[0] = 2.0 * z * p, n[1] = 2.0 * z * q, n[2] = 2.0 * z * z - 1.0;
  }
  normalize(n);
}

void add_sphere(size_t i, Directions* to) {
  const double x = static_cast<double>(i % kFrameEdge) + 0.5, y = static_cast<double>(i / kFrameEdge) + 0.5;
  double n[3], right[3], below[3];
  seen(x, y, n), seen(x + 1e-3, y, right), seen(x, y + 1e-3, below);
  for (int c = 0; c < 3; ++c) {
    to->column[c][i] = static_cast<float>(n[c]);
    to->column[3 + c][i] = static_cast<float>(1e3 * (right[c] - n[c]));
    to->column[6 + c][i] = static_cast<float>(1e3 * (below[c] - n[c]));
  }
}

void add_random(size_t i, float angle, uint32_t* bits, Directions* to) {
  const auto next = [&] {
    *bits = *bits * 1664525u + 1013904223u;
    return (*bits >> 8) * 0x1p-23 - 1.0;
  };
  const double z = next(), a = M_PI * next(), r = std::sqrt(1.0 - z * z), size = 1.5 * static_cast<double>(angle);
  const double n[3] = {r * std::cos(a), r * std::sin(a), z};
  const double across[3] = {-std::sin(a), std::cos(a), 0.0};
  const double down[3] = {-z * std::cos(a), -z * std::sin(a), r};
  for (int c = 0; c < 3; ++c) {
    to->column[c][i] = static_cast<float>(n[c]);
    to->column[3 + c][i] = static_cast<float>(size * across[c]);
    to->column[6 + c][i] = static_cast<float>(size * down[c]);
  }
}

void project(const Kind& kind, Directions* to) {
  shd_context* context = make_context(SHD_SIMD_BEST);
  shd_directions in = shd_directions_default();
  shd_projected_points out = shd_projected_points_default();
  in.projection = kind.projection;
  in.count = kLookupCount;
  for (int c = 0; c < 3; ++c) {
    in.direction[c] = shd_f32_column(to->column[c].data(), 0);
    in.direction_dx[c] = shd_f32_column(to->column[3 + c].data(), 0);
    in.direction_dy[c] = shd_f32_column(to->column[6 + c].data(), 0);
  }
  shd_f32_out* const columns[6] = {&out.u, &out.v, &out.dudx, &out.dvdx, &out.dudy, &out.dvdy};
  for (int c = 0; c < 6; ++c) *columns[c] = shd_f32_out_column(to->point[c].data(), 0);
  out.face = shd_u32_out_column(to->face.data(), 0);
  check(shd_projection_project(context, &in, &out));
  shd_context_release(context);
}

const Directions& directions(const Kind& kind, const std::string& pattern) {
  static std::map<std::string, Directions> cache;
  Directions& to = cache[kind.name + pattern];
  if (!to.face.empty()) return to;
  for (auto& column : to.column) column.resize(kLookupCount);
  for (auto& column : to.point) column.resize(kLookupCount);
  to.face.resize(kLookupCount);
  uint32_t bits = 1;
  for (size_t i = 0; i < kLookupCount; ++i) {
    if (pattern == "sphere")
      add_sphere(i, &to);
    else
      add_random(i, kind.angle, &bits, &to);
  }
  project(kind, &to);
  return to;
}

shd_lookups lookups_of(const Directions& q, bool plane) {
  shd_lookups in = shd_lookups_default();
  in.count = kLookupCount;
  shd_f32_in* const points[6] = {&in.u, &in.v, &in.dudx, &in.dvdx, &in.dudy, &in.dvdy};
  shd_f32_in* const all[9] = {&in.u, &in.v, &in.w, &in.dudx, &in.dvdx, &in.dwdx, &in.dudy, &in.dvdy, &in.dwdy};
  for (int c = 0; plane && c < 6; ++c) *points[c] = shd_f32_column(q.point[c].data(), 0);
  for (int c = 0; !plane && c < 9; ++c) *all[c] = shd_f32_column(q.column[c].data(), 0);
  if (plane) in.layer = shd_u32_column(q.face.data(), 0);
  return in;
}

/// Rates of the rows with a plane, by the name of the row of directions.
std::map<std::string, double>& plane_rates() {
  static std::map<std::string, double> rates;
  return rates;
}

void run(benchmark::State& state, const Target& target, const Kind& kind, shd_filter filter, const std::string& pattern,
         bool plane, const std::string& row) {
  const shd_lookups in = lookups_of(directions(kind, pattern), plane);
  shd_context* context = make_context(target.simd);
  shd_texture_desc desc = shd_texture_desc_default();
  static const std::vector<uint8_t> texels = make_rgba8(2048);
  desc.format = SHD_FORMAT_RGBA8;
  desc.width = kind.width, desc.height = kind.height, desc.layer_count = kind.layers;
  desc.texels = texels.data();
  desc.tables = SHD_TABLE_MIPMAP;
  desc.projection = plane ? SHD_PROJECTION_NONE : kind.projection;
  if (!plane) desc.kind = SHD_TEXTURE_KIND_DIRECTIONS;
  shd_texture* texture = nullptr;
  check(shd_texture_create(context, &desc, &texture));
  shd_sampler_desc sampler_desc = shd_sampler_desc_default();
  sampler_desc.filter = filter;
  sampler_desc.wrap_u = sampler_desc.wrap_v = SHD_WRAP_CLAMP;
  shd_sampler* sampler = nullptr;
  check(shd_sampler_create(context, &sampler_desc, &sampler));
  std::vector<float> channels[4];
  shd_texels out = shd_texels_default();
  for (int c = 0; c < 4; ++c) {
    channels[c].resize(in.count);
    out.channel[c].data = channels[c].data();
  }
  const Stopwatch watch;
  for (auto _ : state) check(shd_texture_sample(texture, sampler, &in, &out));
  const double rate = watch.items_per_second(static_cast<double>(state.iterations()) * in.count);
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(in.count));
  if (plane)
    plane_rates()[row] = rate;
  else if (plane_rates()[row] > 0.0)
    state.counters["ratio_plane"] = rate / plane_rates()[row];
  shd_sampler_release(sampler);
  shd_texture_release(texture);
  shd_context_release(context);
}

}  // namespace

void register_directions() {
  for (const Target& target : targets()) {
    for (const Kind& kind : kKinds) {
      for (const DirectionFilter& filter : kDirectionFilters) {
        for (const std::string pattern : {"sphere", "random"}) {
          const std::string row = std::string(kind.name) + "_" + filter.name + "/rgba8/" + target.name + "/" + pattern;
          for (const bool plane : {true, false}) {
            const std::string name = std::string("texture/") + (plane ? "plane_of_" : "") + row;
            benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
              run(state, target, kind, filter.filter, pattern, plane, row);
            })->Unit(benchmark::kMillisecond);
          }
        }
      }
    }
  }
}

}  // namespace shd::bench
