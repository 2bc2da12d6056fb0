// SPDX-License-Identifier: MIT
#include "texture/domain/exact_footprint.h"

#include <cmath>
#include <cstring>

#include "core/status.h"
#include "projection/projection.h"
#include "texture/domain/lod.h"
#include "texture/store/storage.h"

namespace shd::texture {
namespace {

constexpr double kThinnest = 0x1p-20;

struct Sides {
  Vec3 a, b;
};

Vec3 vector_of(double x, double y, double z) {
  return {{x, y}, z};
}
Vec3 scaled(const Vec3& v, double x, double y, double z) {
  return vector_of(v.x * x, v.y * y, v.z * z);
}
Vec3 scaled(const Vec3& v, double by) {
  return scaled(v, by, by, by);
}

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
  const auto widened = [](const Vec3& side, float width) {
    const auto product = [width](double value) {
      const double wide = value * static_cast<double>(width);
      return std::isnan(wide) ? 0.0 : wide;
    };
    return vector_of(product(side.x), product(side.y), product(side.z));
  };
  s->a = widened(s->a, sampler.width_x);
  s->b = widened(s->b, sampler.width_y);
  const double blur_u = static_cast<double>(sampler.blur_u), blur_v = static_cast<double>(sampler.blur_v);
  if (blur_u == 0 && blur_v == 0) return;
  const double uu = s->a.x * s->a.x + s->b.x * s->b.x + blur_u * blur_u;
  if (!std::isfinite(uu + s->a.y + s->b.y)) return;
  const double length = std::sqrt(uu);
  const double scale = uu > 0 ? (s->a.x * s->a.y + s->b.x * s->b.y) / uu : 0.0;
  const double rest_a = s->a.y - scale * s->a.x, rest_b = s->b.y - scale * s->b.x, rest_blur = scale * blur_u;
  const double rest = rest_a * rest_a + rest_b * rest_b + rest_blur * rest_blur + blur_v * blur_v;
  *s = {vector_of(length, scale * length, 0), vector_of(0, std::sqrt(rest), 0)};
}

/// Returns the sides of a footprint in normalised coordinates, with width, blur and bias. A given level of detail has a
/// square of 2^lod base texels; in a 3D texture it is the face of a box whose edge in z is `depth`.
Sides load_sides(const Texture& texture, const Sampler& sampler, const Lookups& in, size_t i,
                 const DirectionPoint* point, double* depth) {
  const double bias = static_cast<double>(sampler.lod_bias);
  if (in.lod) {
    const double edge = power_of_two(zero_if_nan(in.lod[i]) + bias);
    *depth = texture.depth != 0 ? edge / texture.depth : 0;
    return {vector_of(edge / texture.width, 0, 0), vector_of(0, edge / texture.height, 0)};
  }
  const auto load = [i](const float* column) { return column ? zero_if_nan(column[i]) : 0.0; };
  const bool deep = texture.depth != 0;
  Sides s = {vector_of(load(in.dudx), load(in.dvdx), deep ? load(in.dwdx) : 0.0),
             vector_of(load(in.dudy), load(in.dvdy), deep ? load(in.dwdy) : 0.0)};
  if (point) {
    s = {vector_of(*point->step[0], *point->step[1], 0), vector_of(*point->step[2], *point->step[3], 0)};
  }
  widen(sampler, &s);
  const double scale = power_of_two(bias);
  return {scaled(s.a, scale), scaled(s.b, scale)};
}

bool is_finite(const Texture& texture, const Lookups& in, size_t i) {
  const auto unless = [](bool absent, const float* column) { return absent ? nullptr : column; };
  const bool flat = texture.depth == 0, lod = in.lod != nullptr;
  const float* columns[] = {in.u,
                            in.v,
                            in.lod,
                            unless(flat, in.w),
                            unless(lod, in.dudx),
                            unless(lod, in.dvdx),
                            unless(lod, in.dudy),
                            unless(lod, in.dvdy),
                            unless(lod || flat, in.dwdx),
                            unless(lod || flat, in.dwdy)};
  for (const float* column : columns) {
    if (column && !std::isfinite(column[i])) return false;
  }
  return true;
}

double longest_of(const Vec3& v) {
  const double x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z), longer = x > y ? x : y;
  return longer > z ? longer : z;
}

Vec3 shortened(const Vec3& side, double limit) {
  const auto direction = [](double v) { return std::isinf(v) ? (v > 0 ? 1.0 : -1.0) : 0.0; };
  const double longest = longest_of(side);
  if (std::isinf(longest)) return scaled(vector_of(direction(side.x), direction(side.y), direction(side.z)), limit);
  if (longest <= limit) return side;
  return scaled(side, limit / longest);
}

/// Shortens both sides until their components are at most 1 / 16 of the limit divided by the number of axes, and then
/// until the area is at most half of the limit. cell_bound() is then at most the limit plus 16.
Sides shortened(const Sides& s, double limit, double axes) {
  const double longest = limit / (16 * axes);
  const Sides out = {shortened(s.a, longest), shortened(s.b, longest)};
  const double area = area_bound(out.a, out.b);
  if (area <= limit / 2) return out;
  const double scale = std::sqrt(limit / 2 / area);
  return {scaled(out.a, scale), scaled(out.b, scale)};
}

double length_of(const Vec3& v) {
  return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

/// Makes a parallelogram of 2D counter-clockwise and at least kThinnest wide across its longer side. Returns whether it
/// was thinner.
bool give_width(Sides* s) {
  if (length_of(s->a) < length_of(s->b)) *s = {s->b, s->a};
  const double length = length_of(s->a);
  if (length < kThinnest) {
    *s = {vector_of(kThinnest, 0, 0), vector_of(0, kThinnest, 0)};
    return true;
  }
  if (cross(s->a, s->b) < 0) s->b = vector_of(-s->b.x, -s->b.y, 0);
  const double width = cross(s->a, s->b) / length;
  if (width >= kThinnest) return false;
  const double missing = (kThinnest - width) / length;
  s->b = vector_of(s->b.x - s->a.y * missing, s->b.y + s->a.x * missing, 0);
  return true;
}

/// Brings the sides of a direction from the equator to its parallel, and limits their reach beyond edges.
Sides placed(shd_projection projection, const DirectionPoint& point, const Sides& s) {
  const auto along = [&](double u) {
    const double wide = u * *point.stretch;
    return wide < -1 ? -1 : wide > 1 ? 1 : wide;
  };
  switch (projection) {
    case SHD_PROJECTION_LAT_LONG: return {vector_of(along(s.a.x), s.a.y, 0), vector_of(along(s.b.x), s.b.y, 0)};
    case SHD_PROJECTION_MIRROR_BALL:
    case SHD_PROJECTION_ANGULAR: return {shortened(s.a, 0.5), shortened(s.b, 0.5)};
    case SHD_PROJECTION_CUBE:
    case SHD_PROJECTION_OCTAHEDRAL: return s;
    case SHD_PROJECTION_NONE:
    case SHD_PROJECTION_MAX_ENUM: break;
  }
  SHD_UNREACHABLE();
}

/// Fits the sides of a level, and the depth of a box, to the limit of cells. Returns whether they did fit; if `shorten`
/// is set they do fit afterwards.
bool fit(Sides* s, double* depth, double axes, double limit, bool shorten) {
  const auto boxes = [&] { return (s->a.x + 2) * (s->b.y + 2) * (*depth + 2); };
  const bool box = *depth > 0;
  if ((box ? boxes() : cell_bound(s->a, s->b)) <= limit) return true;
  if (!shorten) return false;
  if (!box) *s = shortened(*s, limit, axes);
  while (box && boxes() > limit) {
    *s = {scaled(s->a, 0.5), scaled(s->b, 0.5)};
    *depth *= 0.5;
  }
  return false;
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

ExactFootprint exact_footprint(const Texture& texture, const Sampler& sampler, const Lookups& in, size_t i,
                               const DirectionPoint* point) {
  double box = 0;
  Sides given = load_sides(texture, sampler, in, i, point, &box);
  if (point) given = placed(texture.projection, *point, given);
  const LodRange range = lod_range(texture, sampler);
  const auto lowest = static_cast<uint32_t>(-std::floor(-static_cast<double>(range.low)));
  const auto floor = static_cast<uint32_t>(range.high), highest = floor > lowest ? floor : lowest;
  const double limit = exact_cell_limit(sampler.tolerance);
  const bool deep = texture.depth != 0;

  ExactFootprint out = {};
  double width, height, depth;
  Sides s;
  for (out.level = lowest;; ++out.level) {
    width = level_size(texture.width, out.level);
    height = level_size(texture.height, out.level);
    depth = level_size(texture.depth, out.level);
    s = {scaled(given.a, width, height, depth), scaled(given.b, width, height, depth)};
    out.depth = box * depth;
    if (fit(&s, &out.depth, deep ? 3 : 2, limit, out.level >= highest) || out.level >= highest) break;
  }
  out.point = out.level == 0 && length_of(s.a) < kThinnest && length_of(s.b) < kThinnest && out.depth < kThinnest;
  out.thin = !deep && give_width(&s);
  out.a = s.a;
  out.b = s.b;
  const auto along = [&](shd_wrap wrap, double at, double size, double extent, int64_t* texel) {
    const double x = place(wrap, at, size, extent);
    *texel = static_cast<int64_t>(std::floor(x));
    return x - std::floor(x);
  };
  out.center.x = along(sampler.wrap_u, point ? *point->u : zero_if_not_finite(in.u[i]), width,
                       std::fabs(s.a.x) + std::fabs(s.b.x), &out.x);
  out.center.y = along(sampler.wrap_v, point ? *point->v : zero_if_not_finite(in.v[i]), height,
                       std::fabs(s.a.y) + std::fabs(s.b.y), &out.y);
  if (deep) {
    const double extent = std::fabs(s.a.z) + std::fabs(s.b.z) + out.depth;
    out.center.z = along(sampler.wrap_w, zero_if_not_finite(in.w[i]), depth, extent, &out.z);
  }
  const uint32_t last = texture.layers - 1;
  out.layer = in.layer ? (in.layer[i] < last ? in.layer[i] : last) : 0;
  if (projection::face_count(texture.projection) > 1) out.layer = static_cast<uint32_t>(*point->face);
  out.finite = point ? point->finite : is_finite(texture, in, i);
  return out;
}

}  // namespace shd::texture
