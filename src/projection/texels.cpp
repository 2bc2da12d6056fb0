// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "core/status.h"
#include "data/trig.h"
#include "projection/projection.h"

namespace shd::projection {
namespace {

constexpr size_t kBlock = 256;

/// Nearest and farthest number to 0 in an interval of the length 2 / n.
struct Distance {
  double least, most;

  Distance(uint32_t i, uint32_t n) {
    const double low = (2.0 * i - n) / n, high = (2.0 * i + 2.0 - n) / n;
    least = low <= 0.0 && high >= 0.0 ? 0.0 : std::min(std::fabs(low), std::fabs(high));
    most = std::max(std::fabs(low), std::fabs(high));
  }
};

/// Moves a centre outside the disc to the middle between the rim and the nearest corner, if that lies inside.
void move_into_disc(float half, float* u, float* v) {
  const float p = *u + *u - 1.0f, q = *v + *v - 1.0f;
  if (p * p + q * q <= 1.0f) return;
  const float x = std::fabs(p) - half, y = std::fabs(q) - half, r = std::sqrt(x * x + y * y);
  if (!(r < 1.0f) || !(r > 0.0f)) return;
  const float scale = 0.5f * (0.5f * (r + 1.0f) / r);
  *u = 0.5f + std::copysign(scale * x, p), *v = 0.5f + std::copysign(scale * y, q);
}

/// Returns whether the density is not smooth in a texel: it holds a fold of the octahedron, or a part of the rim.
bool is_cut(shd_projection projection, const Distance& p, const Distance& q) {
  switch (projection) {
    case SHD_PROJECTION_LAT_LONG:
    case SHD_PROJECTION_CUBE: return false;
    case SHD_PROJECTION_MIRROR_BALL:
    case SHD_PROJECTION_ANGULAR: return p.most * p.most + q.most * q.most > 1.0;
    case SHD_PROJECTION_OCTAHEDRAL: {
      const bool on_axis = (p.least == 0.0 && p.most < 1.0) || (q.least == 0.0 && q.most < 1.0);
      return on_axis || (p.least + q.least < 1.0 && p.most + q.most > 1.0);
    }
    case SHD_PROJECTION_NONE:
    case SHD_PROJECTION_MAX_ENUM: break;
  }
  SHD_UNREACHABLE();
}

/// Points of a part of a row.
struct RowPoints {
  float u[kBlock], v[kBlock];
  uint32_t face[kBlock];
};

/// Solid angles per area: means over the four points of the Gauss-Legendre rule.
void find_densities(shd_projection projection, const core::SimdTarget& simd, const TexelRow& row, size_t first,
                    size_t count, RowPoints* points, float* out) {
  constexpr float kNode = 0.288675135f;  // 1 / (2 sqrt(3))
  float density[kBlock];
  std::fill_n(out, count, 0.0f);
  for (int k = 0; k < 4; ++k) {
    const float dx = 0.5f + (k % 2 ? kNode : -kNode), dy = 0.5f + (k / 2 ? kNode : -kNode);
    std::fill_n(points->v, count, (static_cast<float>(row.y) + dy) / static_cast<float>(row.height));
    for (size_t i = 0; i < count; ++i) {
      points->u[i] = (static_cast<float>(first + i) + dx) / static_cast<float>(row.width);
    }
    unproject(projection, simd, {count, points->u, points->v, points->face}, {{}, density});
    for (size_t i = 0; i < count; ++i) out[i] += 0.25f * density[i];
  }
}

/// Upper bound of the speed of the direction in a texel of an octahedral map, for steps along its sides.
double octahedral_speed(const Distance& p, const Distance& q) {
  constexpr double kLargest = 2.4494897427831781;  // sqrt(6), in the middle of a side
  const double a = 0.5 * (p.least + p.most), b = 0.5 * (q.least + q.most), c = 1.0 - a - b;
  const double x = c < 0.0 ? 1.0 - b : a, y = c < 0.0 ? 1.0 - a : b, z = std::fabs(c);
  const double square = x * x + y * y + z * z;
  // A step adds 1 to one coordinate and -1 to another one. The part of the step across the direction counts.
  const double along = std::min(std::fabs(x - z), std::fabs(y - z));
  const double speed = std::sqrt(2.0 * square - along * along) / square;
  return std::min(kLargest, speed * (1.0 + 1.5 * (p.most - p.least)));
}

/// Angle of a point of a mirror ball from the rim, negative inside.
double beyond_rim(double r) {
  const double inner = std::max(0.0, std::min(r, 2.0 - r));
  const double angle = 2.0 * data::angle_of(std::sqrt(1.0 - inner * inner), inner);
  return r < 1.0 ? -angle : angle;
}

/// Bounds for lines of the length `side` in a disc, from those of the radial and the tangential part.
TexelExtent on_disc(shd_projection projection, const Distance& p, const Distance& q, double side) {
  const double nearest = std::sqrt(p.least * p.least + q.least * q.least);
  const double farthest = std::sqrt(p.most * p.most + q.most * q.most);
  const double inner = std::max(0.0, std::min(nearest, 2.0 - farthest));  // beyond the rim it continues at 2 - r
  const double cosine = nearest > 0.0 ? std::min(1.0, p.most / nearest) : 1.0;
  const double sine = nearest > 0.0 ? std::min(1.0, q.most / nearest) : 1.0;
  double radial = data::kPi, tangential = data::kPi;
  if (projection == SHD_PROJECTION_MIRROR_BALL) {
    tangential = 2.0 * std::sqrt(1.0 - inner * inner);
    if (farthest >= 1.0) {                                                // the speed at the rim is infinite
      const double turns = p.least == 0.0 || q.least == 0.0 ? 2.0 : 1.0;  // lines towards the centre and back
      const double length = turns * (beyond_rim(farthest) - beyond_rim(nearest)) + side * tangential;
      return {length, length};
    }
    radial = 2.0 / std::sqrt(1.0 - farthest * farthest);
  } else if (inner > 0.0) {
    const double sine_of_inner = data::sin(data::kPi * std::min(inner, 1.0 - inner));
    if (inner >= 0.5 || farthest <= 1.0) tangential = sine_of_inner / inner;
  }
  const auto length = [&](double outwards, double around) {
    const double a = radial * outwards, b = tangential * around;
    return side * std::sqrt(a * a + b * b);
  };
  return {length(cosine, sine), length(sine, cosine)};
}

}  // namespace

void find_texels(shd_projection projection, const core::SimdTarget& simd, const TexelRow& row,
                 const PointDirections& out) {
  const Distance q(row.y, row.height);
  const bool even = projection == SHD_PROJECTION_LAT_LONG;
  const auto area = static_cast<float>(1.0 / (static_cast<double>(row.width) * row.height));
  const auto of_row = even ? static_cast<float>(texel_solid_angle(projection, row.width, row.height, 0, row.y)) : 0.0f;
  RowPoints points;
  std::fill_n(points.face, kBlock, row.face);
  for (size_t first = 0; first < row.width; first += kBlock) {
    const size_t count = std::min<size_t>(kBlock, row.width - first);
    float* const solid_angle = out.solid_angle + first;
    if (even) std::fill_n(solid_angle, count, of_row);
    if (!even) find_densities(projection, simd, row, first, count, &points, solid_angle);
    std::fill_n(points.v, count, (static_cast<float>(row.y) + 0.5f) / static_cast<float>(row.height));
    for (size_t i = 0; i < count; ++i) {
      const auto x = static_cast<uint32_t>(first + i);
      points.u[i] = (static_cast<float>(x) + 0.5f) / static_cast<float>(row.width);
      if (even) continue;
      solid_angle[i] *= area;
      if (!is_cut(projection, Distance(x, row.width), q)) continue;
      solid_angle[i] = static_cast<float>(texel_solid_angle(projection, row.width, row.height, x, row.y));
      if (is_disc(projection)) move_into_disc(1.0f / static_cast<float>(row.width), &points.u[i], &points.v[i]);
    }
    unproject(projection, simd, {count, points.u, points.v, points.face},
              {{out.direction[0] + first, out.direction[1] + first, out.direction[2] + first}, nullptr});
  }
}

TexelExtent texel_extent(shd_projection projection, uint32_t width, uint32_t height, uint32_t x, uint32_t y) {
  const Distance p(x, width), q(y, height);
  const double side = 2.0 / width;
  switch (projection) {
    case SHD_PROJECTION_LAT_LONG: {
      const double sine = data::cos(0.5 * data::kPi * q.least);
      return {2.0 * data::kPi / width * sine, data::kPi / height};
    }
    case SHD_PROJECTION_CUBE: {
      const double s = p.least * p.least, t = q.least * q.least, square = 1.0 + s + t;
      return {side * std::sqrt(1.0 + t) / square, side * std::sqrt(1.0 + s) / square};
    }
    case SHD_PROJECTION_OCTAHEDRAL: {
      const double length = side * octahedral_speed(p, q);
      return {length, length};
    }
    case SHD_PROJECTION_MIRROR_BALL:
    case SHD_PROJECTION_ANGULAR: return on_disc(projection, p, q, side);
    case SHD_PROJECTION_NONE:
    case SHD_PROJECTION_MAX_ENUM: break;
  }
  SHD_UNREACHABLE();
}

}  // namespace shd::projection
