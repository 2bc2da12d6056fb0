// SPDX-License-Identifier: MIT
#include "texture/domain/exact_footprint.h"

#include <cmath>
#include <cstring>

#include "texture/domain/lod.h"
#include "texture/store/storage.h"

namespace shd::texture {
namespace {

constexpr double kThinnest = 0x1p-20;

struct Sides {
  Vec2 a, b;
};

double zero_if_nan(float value) {
  return std::isnan(value) ? 0.0 : static_cast<double>(value);
}
double zero_if_not_finite(float value) {
  return std::isfinite(value) ? static_cast<double>(value) : 0.0;
}

/// Returns 2^x for x clamped to -200..200, by the Taylor series of the fraction. |relative error| < 1e-15; exact for
/// whole x.
double power_of_two(double x) {
  const double clamped = x < -200 ? -200 : x > 200 ? 200 : x;
  const double whole = std::floor(clamped + 0.5), t = (clamped - whole) * 0x1.62e42fefa39efp-1;
  double power = 1;
  for (int k = 14; k >= 1; --k) power = 1 + power * t / k;
  const auto bits = static_cast<uint64_t>(static_cast<int64_t>(whole) + 1023) << 52;
  double scale;
  std::memcpy(&scale, &bits, sizeof scale);
  return power * scale;
}

/// Applies width and blur to the sides, as Widen() of footprint-inl.h does in floats.
void widen(const Sampler& sampler, Sides* s) {
  const auto scaled = [](double value, float width) {
    const double product = value * static_cast<double>(width);
    return std::isnan(product) ? 0.0 : product;
  };
  s->a = {scaled(s->a.x, sampler.width_x), scaled(s->a.y, sampler.width_x)};
  s->b = {scaled(s->b.x, sampler.width_y), scaled(s->b.y, sampler.width_y)};
  const double blur_u = static_cast<double>(sampler.blur_u), blur_v = static_cast<double>(sampler.blur_v);
  if (blur_u == 0 && blur_v == 0) return;
  const double uu = s->a.x * s->a.x + s->b.x * s->b.x + blur_u * blur_u;
  if (!std::isfinite(uu + s->a.y + s->b.y)) return;
  const double length = std::sqrt(uu);
  const double scale = uu > 0 ? (s->a.x * s->a.y + s->b.x * s->b.y) / uu : 0.0;
  const double rest_a = s->a.y - scale * s->a.x, rest_b = s->b.y - scale * s->b.x, rest_blur = scale * blur_u;
  const double rest = rest_a * rest_a + rest_b * rest_b + rest_blur * rest_blur + blur_v * blur_v;
  *s = {{length, scale * length}, {0, std::sqrt(rest)}};
}

/// Returns the sides of a footprint in normalised coordinates, with width, blur and bias. A given level of detail has a
/// square of 2^lod base texels.
Sides load_sides(const Texture& texture, const Sampler& sampler, const Lookups& in, size_t i) {
  const double bias = static_cast<double>(sampler.lod_bias);
  if (in.lod) {
    const double edge = power_of_two(zero_if_nan(in.lod[i]) + bias);
    return {{edge / texture.width, 0}, {0, edge / texture.height}};
  }
  const auto load = [i](const float* column) { return column ? zero_if_nan(column[i]) : 0.0; };
  Sides s = {{load(in.dudx), load(in.dvdx)}, {load(in.dudy), load(in.dvdy)}};
  widen(sampler, &s);
  const double scale = power_of_two(bias);
  for (Vec2* side : {&s.a, &s.b}) *side = {side->x * scale, side->y * scale};
  return s;
}

bool is_finite(const Lookups& in, size_t i) {
  const float* columns[] = {in.u,
                            in.v,
                            in.lod,
                            in.lod ? nullptr : in.dudx,
                            in.lod ? nullptr : in.dvdx,
                            in.lod ? nullptr : in.dudy,
                            in.lod ? nullptr : in.dvdy};
  for (const float* column : columns) {
    if (column && !std::isfinite(column[i])) return false;
  }
  return true;
}

Vec2 shortened(Vec2 side, double limit) {
  const auto direction = [](double v) { return std::isinf(v) ? (v > 0 ? 1.0 : -1.0) : 0.0; };
  if (std::isinf(side.x) || std::isinf(side.y)) return {limit * direction(side.x), limit * direction(side.y)};
  const double longest = std::fabs(side.x) > std::fabs(side.y) ? std::fabs(side.x) : std::fabs(side.y);
  if (longest <= limit) return side;
  const double scale = limit / longest;
  return {side.x * scale, side.y * scale};
}

/// Shortens both sides until their components are at most 1 / 32 of the limit, and then until the area is at most half
/// of the limit. cell_bound() is then at most the limit plus 16.
Sides shortened(const Sides& s, double limit) {
  Sides out = {shortened(s.a, limit / 32), shortened(s.b, limit / 32)};
  const double area = std::fabs(cross(out.a, out.b));
  if (area <= limit / 2) return out;
  const double scale = std::sqrt(limit / 2 / area);
  for (Vec2* side : {&out.a, &out.b}) *side = {side->x * scale, side->y * scale};
  return out;
}

double length_of(Vec2 v) {
  return std::sqrt(v.x * v.x + v.y * v.y);
}

/// Makes a parallelogram counter-clockwise and at least kThinnest wide across its longer side. Returns whether it was
/// thinner.
bool give_width(Sides* s) {
  if (length_of(s->a) < length_of(s->b)) *s = {s->b, s->a};
  const double length = length_of(s->a);
  if (length < kThinnest) {
    *s = {{kThinnest, 0}, {0, kThinnest}};
    return true;
  }
  if (cross(s->a, s->b) < 0) s->b = {-s->b.x, -s->b.y};
  const double width = cross(s->a, s->b) / length;
  if (width >= kThinnest) return false;
  const double missing = (kThinnest - width) / length;
  s->b = {s->b.x - s->a.y * missing, s->b.y + s->a.x * missing};
  return true;
}

/// Returns the texel coordinate of a finite u. Wraps that repeat remove whole periods; the others clamp the coordinate
/// at a distance where the whole footprint lies outside the image.
double place(shd_wrap wrap, double u, double size, double extent) {
  if (wrap == SHD_WRAP_REPEAT) return (u - std::floor(u)) * size - 0.5;
  if (wrap == SHD_WRAP_MIRROR) return (u - 2 * std::floor(u / 2)) * size - 0.5;
  const double x = u * size - 0.5, reach = extent + 2 * size + 2;
  return x < -reach ? -reach : x > reach ? reach : x;
}

}  // namespace

double exact_cell_limit(float tolerance) {
  const double t = static_cast<double>(tolerance), limit = 16 / (t * t);
  return limit < 0x1p10 ? 0x1p10 : limit > 0x1p24 ? 0x1p24 : limit;
}

ExactFootprint exact_footprint(const Texture& texture, const Sampler& sampler, const Lookups& in, size_t i) {
  const Sides given = load_sides(texture, sampler, in, i);
  const LodRange range = lod_range(texture, sampler);
  const auto lowest = static_cast<uint32_t>(-std::floor(-static_cast<double>(range.low)));
  const auto floor = static_cast<uint32_t>(range.high), highest = floor > lowest ? floor : lowest;
  const double limit = exact_cell_limit(sampler.tolerance);

  ExactFootprint out = {};
  double width, height;
  Sides s;
  for (out.level = lowest;; ++out.level) {
    width = level_size(texture.width, out.level);
    height = level_size(texture.height, out.level);
    s = {{given.a.x * width, given.a.y * height}, {given.b.x * width, given.b.y * height}};
    if (cell_bound(s.a, s.b) <= limit) break;
    if (out.level < highest) continue;
    s = shortened(s, limit);
    break;
  }
  out.point = out.level == 0 && length_of(s.a) < kThinnest && length_of(s.b) < kThinnest;
  out.thin = give_width(&s);
  out.a = s.a;
  out.b = s.b;
  const double x = place(sampler.wrap_u, zero_if_not_finite(in.u[i]), width, std::fabs(s.a.x) + std::fabs(s.b.x));
  const double y = place(sampler.wrap_v, zero_if_not_finite(in.v[i]), height, std::fabs(s.a.y) + std::fabs(s.b.y));
  out.x = static_cast<int64_t>(std::floor(x));
  out.y = static_cast<int64_t>(std::floor(y));
  out.center = {x - std::floor(x), y - std::floor(y)};
  const uint32_t last = texture.layers - 1;
  out.layer = in.layer ? (in.layer[i] < last ? in.layer[i] : last) : 0;
  out.finite = is_finite(in, i);
  return out;
}

}  // namespace shd::texture
