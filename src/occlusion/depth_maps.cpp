// SPDX-License-Identifier: MIT
#include "occlusion/depth_maps.h"

#include <algorithm>
#include <cmath>

#include "core/executor.h"
#include "data/hash.h"
#include "data/trig.h"
#include "frame/shadow_map.h"
#include "occlusion/blockers.h"

namespace shd::occlusion {
namespace {

constexpr size_t kPiece = 1024;  // points, whose columns lie on the stack

light::Light distant_light(const float (&to_light)[3]) {
  shd_light_desc desc = shd_light_desc_default();
  desc.kind = SHD_LIGHT_KIND_DIRECTIONAL;
  for (int c = 0; c < 3; ++c) desc.direction[c] = -to_light[c];
  return light::make_light(desc, nullptr, nullptr);
}

light::Shadow make_shadow(const Options& options) {
  const shd_shadow_desc defaults = shd_shadow_desc_default();
  light::Shadow shadow = {};
  shadow.options.size = options.map_size;
  shadow.options.filter = SHD_SHADOW_FILTER_HARD;
  shadow.options.taps = defaults.taps;
  shadow.options.bias = options.bias;
  shadow.options.bias_slope = defaults.bias_slope;
  return shadow;
}

/// Unit normals of points, and sums over directions: of cosines, and of those in whose direction a point is open.
/// Points that are not finite have the normal 0.
struct Sums {
  core::Array<float> normal[3];
  core::Array<double> open, all;

  Sums(const core::Allocator& allocator, const Points& points)
      : open(allocator, points.count), all(allocator, points.count) {
    open.fill_zero();
    all.fill_zero();
    for (core::Array<float>& column : normal) column = core::Array<float>(allocator, points.count);
    for (size_t i = 0; i < points.count; ++i) set_normal(points, i);
  }

 private:
  void set_normal(const Points& points, size_t i) {
    double n[3], squared = 0.0;
    bool is_finite = true;
    for (int c = 0; c < 3; ++c) {
      n[c] = static_cast<double>(points.normal[c][i]);
      squared += n[c] * n[c];
      is_finite &= std::isfinite(points.position[c][i]);
    }
    const bool usable = is_finite && squared > 0.0 && std::isfinite(squared);
    for (int c = 0; c < 3; ++c) normal[c][i] = usable ? static_cast<float>(n[c] / std::sqrt(squared)) : 0.0f;
  }
};

/// Adds one direction for the points [begin, end).
void add_direction(const core::Context& context, const Options& options, const light::Shadow& shadow,
                   const float (&direction)[3], const Points& points, size_t begin, size_t end, Sums* sums) {
  float is_open[kPiece];
  light::ShadowLookups lookups = {end - begin, {}, {}};
  for (int c = 0; c < 3; ++c) {
    lookups.position[c] = points.position[c] + begin;
    lookups.normal[c] = sums->normal[c].data() + begin;
  }
  find_open(context.simd, shadow, options.radius, lookups, is_open);
  for (size_t i = begin; i < end; ++i) {
    double cosine = 0.0;
    for (int c = 0; c < 3; ++c) {
      cosine += static_cast<double>(sums->normal[c][i]) * static_cast<double>(direction[c]);
    }
    if (!(cosine > 0.0)) continue;
    sums->all[i] += cosine;
    sums->open[i] += cosine * static_cast<double>(is_open[i - begin]);
  }
}

}  // namespace

/// A spherical Fibonacci set (Keinert, Innmann, Saenger and Stamminger, "Spherical Fibonacci Mapping", 2015), shifted
/// along its spiral and turned around its axis.
void sky_direction(uint32_t i, uint32_t n, uint32_t seed, float (&out)[3]) {
  const double shift = static_cast<double>(data::mix_bits(seed + 1u)) * 0x1p-32;
  const double y = 1.0 - 2.0 * (static_cast<double>(i) + shift) / static_cast<double>(n);
  const data::CirclePoint turn =
      data::circle_point((i * data::kHashStep + data::mix_bits(seed + data::kHashStep)) >> 8, 1u << 24);
  const double radius = std::sqrt(std::max(0.0, 1.0 - y * y));
  out[0] = static_cast<float>(radius * turn.cosine);
  out[1] = static_cast<float>(y);
  out[2] = static_cast<float>(radius * turn.sine);
}

void sum_depth_maps(const core::Context& context, const Options& options, const frame::Draw* draws, size_t draw_count,
                    const Points& points) {
  if (points.count == 0) return;
  std::fill_n(points.value, points.count, 1.0f);
  if (draw_count == 0) return;
  Sums sums(context.allocator, points);
  light::Shadow shadow = make_shadow(options);
  const auto pieces = static_cast<uint32_t>((points.count + kPiece - 1) / kPiece);
  const uint32_t directions = 2 * options.rays;
  for (uint32_t i = 0; i < directions; ++i) {
    float direction[3];
    sky_direction(i, directions, options.seed, direction);
    const light::Light light = distant_light(direction);
    frame::ShadowFrame frame = {};
    frame.light = &light;
    frame.draws = draws;
    frame.draw_count = draw_count;
    frame::render_shadow(context, context, frame, &shadow);
    core::parallel_for(context, pieces, [&](uint32_t piece, uint32_t) {
      const size_t begin = piece * kPiece, end = std::min(points.count, begin + kPiece);
      add_direction(context, options, shadow, direction, points, begin, end, &sums);
    });
  }
  for (size_t i = 0; i < points.count; ++i) {
    if (sums.all[i] > 0.0) points.value[i] = static_cast<float>(sums.open[i] / sums.all[i]);
  }
}

}  // namespace shd::occlusion
