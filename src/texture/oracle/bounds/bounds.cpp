// SPDX-License-Identifier: MIT
#include "texture/oracle/bounds/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "texture/format/formats.h"
#include "texture/oracle/bounds/compare.h"
#include "texture/oracle/bounds/directions.h"
#include "texture/oracle/bounds/filters.h"

namespace shd::texture {
namespace {

/// Inputs of a lookup in doubles, without NaN, and without infinite coordinates.
struct Lookup {
  double point[3];  // (u, v), (u, v, w) or a direction
  double dx[3], dy[3];
  double lod;
  bool has_lod, finite;
  uint32_t layer;
};

double value_at(const float* column, size_t i) {
  return column ? static_cast<double>(column[i]) : 0.0;
}

/// A direction without length, or with a component that is not finite, counts as +Z.
void check_direction(Lookup* lookup) {
  bool valid = false;
  for (const double x : lookup->point) valid = valid || x != 0.0;
  for (const double x : lookup->point) valid = valid && std::isfinite(x);
  if (valid) return;
  lookup->finite = false;
  lookup->point[0] = lookup->point[1] = 0.0;
  lookup->point[2] = 1.0;
}

Lookup load(const Texture& texture, const Lookups& in, size_t i) {
  Lookup lookup = {
      {value_at(in.u, i), value_at(in.v, i), value_at(in.w, i)}, {}, {}, value_at(in.lod, i), in.lod != nullptr, true,
      in.layer ? std::min(in.layer[i], texture.layers - 1) : 0};
  lookup.finite = std::isfinite(lookup.lod);
  if (std::isnan(lookup.lod)) lookup.lod = 0.0;
  if (texture.projection == SHD_PROJECTION_NONE) {
    for (double& x : lookup.point) {
      lookup.finite = lookup.finite && std::isfinite(x);
      if (!std::isfinite(x)) x = 0.0;
    }
  } else {
    check_direction(&lookup);
  }
  if (in.lod) return lookup;
  const float* const columns[2][3] = {{in.dudx, in.dvdx, in.dwdx}, {in.dudy, in.dvdy, in.dwdy}};
  for (int axis = 0; axis < 2; ++axis) {
    for (int c = 0; c < 3; ++c) {
      const double given = value_at(columns[axis][c], i);
      lookup.finite = lookup.finite && std::isfinite(given);
      (axis == 0 ? lookup.dx : lookup.dy)[c] = std::isnan(given) ? 0.0 : given;
    }
  }
  return lookup;
}

/// Derivatives times the widths of the sampler. A width of 0 removes an infinite derivative.
Steps widened_steps(const Sampler& sampler, const Steps& steps) {
  const auto scaled = [](double x, float width) {
    const double product = x * static_cast<double>(width);
    return std::isnan(product) ? 0.0 : product;
  };
  Steps out;
  for (int c = 0; c < 3; ++c) {
    out.x.part[c] = scaled(steps.x.part[c], sampler.width_x);
    out.y.part[c] = scaled(steps.y.part[c], sampler.width_y);
  }
  out.error_x = scaled(steps.error_x, sampler.width_x);
  out.error_y = scaled(steps.error_y, sampler.width_y);
  return out;
}

BoundsFootprint footprint_of(const BoundsCall& call, const Lookup& lookup, const Steps& steps) {
  return bounds_footprint(call.texture, call.sampler, call.model, widened_steps(call.sampler, steps),
                          lookup.has_lod ? &lookup.lod : nullptr);
}

void add_direction(const BoundsCall& call, const Lookup& lookup, Color* out) {
  const DirectionPlaces places = places_of(call, lookup.point, lookup.dx, lookup.dy, lookup.layer);
  if (places.count == 0) return out->add(format_range(call.texture, call.sampler));
  for (int k = 0; k < places.count; ++k) {
    add_filtered(call, places.place[k], footprint_of(call, lookup, places.steps[k]), out);
  }
}

Color legal_values(const BoundsCall& call, const Lookup& lookup) {
  Color color;
  if (call.texture.projection != SHD_PROJECTION_NONE) {
    add_direction(call, lookup, &color);
    return color;
  }
  Steps steps = {};
  for (int c = 0; c < axes_of(call.texture); ++c) steps.x.part[c] = lookup.dx[c], steps.y.part[c] = lookup.dy[c];
  add_filtered(call, place_of(call, lookup.point, lookup.layer), footprint_of(call, lookup, steps), &color);
  return color;
}

float round_down(double x) {
  const auto rounded = static_cast<float>(std::max(x, -HUGE_VAL));
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  return static_cast<double>(rounded) > x ? std::nextafter(rounded, -kInfinity) : rounded;
}

/// The error of results. Rounding to `result_step` moves values of unorm formats only.
Range with_result_error(const BoundsCall& call, const Range& range) {
  const bool floats = !call.sampler.compares && !image::is_unorm(call.texture.component);
  const double largest = std::max(std::fabs(range.low), std::fabs(range.high));
  if (!std::isfinite(largest)) return range;
  const double error = call.model.relative_error * largest + (floats ? 0.0 : call.model.result_step);
  return widened(range, error + 1e-13 * largest);
}

/// Returns the range of an output. Comparison lookups give (r, 0, 0, 1).
Range result_range(const BoundsCall& call, const Color& color, int c) {
  const bool compares = call.sampler.compares;
  const uint32_t source = compares && c > 0 ? kFill : call.texture.channel_source[c];
  if (source != kFill) return with_result_error(call, color.channel[source]);
  const double fill = !compares || c == 0 ? static_cast<double>(call.texture.fill[c]) : c == 3 ? 1.0 : 0.0;
  return compares && c == 0 ? compared_range(call.sampler, call.reference, {fill, fill}) : Range{fill, fill};
}

void store(const BoundsCall& call, const Color& color, size_t i, float* const (&lower)[4], float* const (&upper)[4]) {
  for (int c = 0; c < 4; ++c) {
    const Range range = result_range(call, color, c);
    if (lower[c]) lower[c][i] = round_down(range.low);
    if (upper[c]) upper[c][i] = -round_down(-range.high);
  }
}

}  // namespace

size_t find_bounds(const Texture& texture, const Sampler& sampler, const BoundsModel& model, const Lookups& lookups,
                   float* const (&lower)[4], float* const (&upper)[4]) {
  TexelReader reader(texture);
  size_t nonfinite = 0;
  for (size_t i = 0; i < lookups.count; ++i) {
    const BoundsCall call = {texture, sampler, model, reader, reference_range(texture, lookups, i)};
    const Lookup lookup = load(texture, lookups, i);
    nonfinite += !lookup.finite;
    store(call, legal_values(call, lookup), i, lower, upper);
  }
  return nonfinite;
}

}  // namespace shd::texture
