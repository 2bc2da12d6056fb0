// SPDX-License-Identifier: MIT
#include "raster/planes.h"

#include <algorithm>
#include <cmath>

#include "raster/tile.h"

namespace shd::raster {
namespace {

/// Planes of larger coefficients are not used: products with them might overflow.
constexpr double kLargest = 0x1p90;

/// A linear function of the raster position relative to the middle of a cell.
struct Linear {
  double at_middle, dx, dy;

  double at(double x, double y) const { return at_middle + dx * x + dy * y; }
};

Linear operator+(const Linear& a, const Linear& b) {
  return {a.at_middle + b.at_middle, a.dx + b.dx, a.dy + b.dy};
}
Linear operator*(double a, const Linear& b) {
  return {a * b.at_middle, a * b.dx, a * b.dy};
}

double size_of(const Linear& a) {
  return std::fabs(a.at_middle) + std::fabs(a.dx) + std::fabs(a.dy);
}

Plane rounded(const Linear& a) {
  return {static_cast<float>(a.at_middle), static_cast<float>(a.dx), static_cast<float>(a.dy)};
}

/// Weights of the corners of a triangle, up to a common factor, and their sum. All are 0 without area.
struct CornerWeights {
  Linear e[3], sum;
};

/// Whether all corners have places on the screen, near enough for sums of their products.
bool are_on_screen(const geometry::Vertices& vertices, const uint32_t (&row)[3]) {
  for (const uint32_t k : row) {
    const float* corner = vertices.raster.data() + 4 * size_t{k};
    const double reach = 0x1p60 * double{corner[3]};
    if (!(corner[3] >= geometry::kMinW)) return false;
    if (!(std::fabs(double{corner[0]}) <= reach && std::fabs(double{corner[1]}) <= reach)) return false;
  }
  return true;
}

/// The weights are the cross products of the corners, translated to the middle of the cell. Their sum is a multiple of
/// the inverse of w, whose sign is that of the determinant of the corners. Weights that are linear on the screen are
/// those of the projected corners, whose w is 1.
CornerWeights weights_of(const geometry::Vertices& vertices, const uint32_t (&row)[3], double middle_x,
                         double middle_y) {
  double x[3], y[3], w[3], determinant = 0.0;
  CornerWeights result;
  const bool projects = vertices.affine && are_on_screen(vertices, row);
  for (size_t k = 0; k < 3; ++k) {
    const float* corner = vertices.raster.data() + 4 * size_t{row[k]};
    w[k] = double{corner[3]};
    x[k] = double{corner[0]} - middle_x * w[k];
    y[k] = double{corner[1]} - middle_y * w[k];
    if (!projects) continue;
    x[k] /= w[k];
    y[k] /= w[k];
    w[k] = 1.0;
  }
  for (size_t k = 0; k < 3; ++k) {
    const size_t i = (k + 1) % 3, j = (k + 2) % 3;
    result.e[k] = {x[i] * y[j] - x[j] * y[i], w[j] * y[i] - w[i] * y[j], w[i] * x[j] - w[j] * x[i]};
    determinant += w[k] * result.e[k].at_middle;
  }
  result.sum = result.e[0] + result.e[1] + result.e[2];
  if (w[0] == w[1] && w[0] == w[2]) result.sum.dx = result.sum.dy = 0.0;
  const double sign = determinant < 0.0 ? -1.0 : 1.0;
  for (Linear& e : result.e) e = sign * e;
  result.sum = sign * result.sum;
  return result;
}

/// A position in the cell, relative to its middle.
struct Place {
  double x, y;
};

/// Where planes are compared: the middle of the cell, or its corner of largest `sum` if the middle has much less.
Place reference_of(const Linear& sum) {
  constexpr double kHalfCell = kTile / 2;
  const Place corner = {std::copysign(kHalfCell, sum.dx), std::copysign(kHalfCell, sum.dy)};
  return 8.0 * sum.at_middle >= sum.at(corner.x, corner.y) ? Place{0.0, 0.0} : corner;
}

/// The plane of a texture coordinate, from weights in units of their sum at the reference; constant if it is too steep.
CoordinatePlane coordinate_plane(const geometry::RowComponent& from, const uint32_t (&row)[3],
                                 const CornerWeights& weights, const Place& reference) {
  const double a[3] = {double{from[row[0]]}, double{from[row[1]]}, double{from[row[2]]}};
  const double low = std::min({a[0], a[1], a[2]}), high = std::max({a[0], a[1], a[2]});
  double near = 0.0;
  for (size_t k = 0; k < 3; ++k) near += a[k] * weights.e[k].at(reference.x, reference.y);
  const auto base = static_cast<float>(std::min(std::max(near, low), high));
  Linear offset = {0.0, 0.0, 0.0};
  for (size_t k = 0; k < 3; ++k) offset = offset + (a[k] - double{base}) * weights.e[k];
  const double range = std::max(high - double{base}, double{base} - low);
  if (!(size_of(offset) + range * size_of(weights.sum) < kLargest)) {
    return {{0.0f, 0.0f, 0.0f}, static_cast<float>((a[0] + a[1] + a[2]) / 3.0), 0.0f, 0.0f};
  }
  return {rounded(offset), base, static_cast<float>(low - double{base}), static_cast<float>(high - double{base})};
}

}  // namespace

void find_planes(const geometry::Vertices& vertices, const uint32_t (&row)[3], const Cell& cell, uint32_t wanted,
                 TrianglePlanes* out) {
  out->middle_x = static_cast<float>(cell.left + kTile / 2);
  out->middle_y = static_cast<float>(cell.top + kTile / 2);
  CornerWeights weights = weights_of(vertices, row, double{out->middle_x}, double{out->middle_y});
  const Place reference = reference_of(weights.sum);
  const double scale = 1.0 / weights.sum.at(reference.x, reference.y);
  double size = 0.0;  // NaN stays NaN in a sum
  for (Linear& e : weights.e) {
    e = scale * e;
    size += size_of(e);
  }
  weights.sum = scale * weights.sum;
  if (!(scale > 0.0) || !(size + size_of(weights.sum) < kLargest)) {
    for (Linear& e : weights.e) e = {1.0 / 3.0, 0.0, 0.0};
    weights.sum = {1.0, 0.0, 0.0};
  }
  out->inverse_w = rounded(weights.sum);
  out->b1 = rounded(weights.e[1]);
  out->b2 = rounded(weights.e[2]);
  if (wanted & kTexture) {
    out->u = coordinate_plane(geometry::u_of(vertices), row, weights, reference);
    out->v = coordinate_plane(geometry::v_of(vertices), row, weights, reference);
  }
  if (!(wanted & kTexture1) || vertices.texture1.size() == 0) return;
  out->u1 = coordinate_plane(geometry::u1_of(vertices), row, weights, reference);
  out->v1 = coordinate_plane(geometry::v1_of(vertices), row, weights, reference);
}

}  // namespace shd::raster
