// SPDX-License-Identifier: MIT
// Filters on level 0 of a texture of directions, in double, from the projections of projection_ref.h. Texels beyond an
// edge are found on the cube, on the octahedron and on the sphere.
#pragma once

#include <algorithm>
#include <cmath>

#include "ref/projection_ref.h"
#include "ref/texture_ref.h"

namespace shd::ref {

/// One channel, [face][height][width].
struct DirectionTexels {
  shd_projection projection;
  int width, height;
  const float* texels;

  double at(int x, int y, uint32_t face) const {
    return static_cast<double>(texels[(static_cast<int>(face) * height + y) * width + x]);
  }
};

struct FaceTexel {
  int x, y;
  uint32_t face;
};

inline bool is_outside(int x, int size) {
  return x < 0 || x >= size;
}
inline int modulo(int x, int size) {
  return (x % size + size) % size;
}

/// The texel of the cube at (x, y) of a face: a path over an edge goes on along its grid line. Beyond a corner the path
/// goes over the left or right edge, in the row beside the corner. A path ends on the last row of the adjacent face.
inline FaceTexel cube_texel(int size, int x, int y, uint32_t face) {
  if (!is_outside(x, size) && !is_outside(y, size)) return {x, y, face};
  const int* row = ref_cube_table[face];
  const bool sideways = is_outside(x, size);
  if (sideways) y = y < 0 ? 0 : y >= size ? size - 1 : y;
  const double n = size, p = (2.0 * x + 1.0) / n - 1.0, q = (2.0 * y + 1.0) / n - 1.0;
  const double over = std::fabs(sideways ? p : q) - 1.0;  // on the adjacent face, from the edge
  const double depth = std::fmax(1.0 - over, 1.0 / n - 1.0);
  const double part[3] = {depth, sideways ? std::copysign(1.0, p) : p, sideways ? q : std::copysign(1.0, q)};
  long double v[3] = {};
  for (int k = 0; k < 3; ++k) v[std::abs(row[k]) - 1] = row[k] > 0 ? part[k] : -part[k];
  uint32_t on = static_cast<uint32_t>(2 * (std::abs(row[sideways ? 1 : 2]) - 1));
  on += v[on / 2] < 0.0L;
  const ref_place place = ref_on_face(v, on);
  return {static_cast<int>(std::floor(static_cast<double>(place.u) * n)),
          static_cast<int>(std::floor(static_cast<double>(place.v) * n)), on};
}

/// The texel that continues the image at (x, y), which may lie outside. Not for discs.
inline FaceTexel texel_at(const DirectionTexels& image, int x, int y, uint32_t face) {
  const int w = image.width, h = image.height;
  if (image.projection == SHD_PROJECTION_CUBE) return cube_texel(w, x, y, face);
  if (image.projection == SHD_PROJECTION_OCTAHEDRAL) {
    const bool beside_x = is_outside(x, w), beside_y = is_outside(y, h);
    const int in_x = x < 0 ? -1 - x : x >= w ? 2 * w - 1 - x : x, in_y = y < 0 ? -1 - y : y >= h ? 2 * h - 1 - y : y;
    const int x_in = std::min(std::max(in_x, 0), w - 1), y_in = std::min(std::max(in_y, 0), h - 1);  // one texel
    return {beside_y ? w - 1 - x_in : x_in, beside_x ? h - 1 - y_in : y_in, 0};
  }
  const int row = modulo(y, 2 * h);
  const double middle = x + 0.5 + (row >= h ? 0.5 * w : 0.0);
  return {modulo(static_cast<int>(std::floor(middle)), w), row >= h ? 2 * h - 1 - row : row, face};
}

/// Weight of the second of two texels, from the fraction s of the way between them.
using TwoWeights = double (*)(double s);
inline double linear_weight(double s) {
  return s;
}

/// The value of a row of LAT_LONG at u. Rows beyond a pole go on along the opposite meridian.
inline double lat_long_row(const DirectionTexels& image, double u, int y, TwoWeights weight) {
  if (is_outside(y, image.height)) u += 0.5, y = y < 0 ? -1 - y : 2 * image.height - 1 - y;
  const double x = u * image.width - 0.5, left = std::floor(x);
  const int i = static_cast<int>(left);
  const double a = image.at(modulo(i, image.width), y, 0), b = image.at(modulo(i + 1, image.width), y, 0);
  return a + weight(x - left) * (b - a);
}

/// The bilinear value in a direction. Not for discs.
inline double bilinear(const DirectionTexels& image, const long double* n, TwoWeights weight_of = linear_weight) {
  const ref_place place = ref_project(image.projection, n);
  const double u = static_cast<double>(place.u), v = static_cast<double>(place.v);
  const double x = u * image.width - 0.5, y = v * image.height - 0.5;
  const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
  const double s = weight_of(x - left), t = weight_of(y - top);
  if (image.projection == SHD_PROJECTION_LAT_LONG)
    return (1.0 - t) * lat_long_row(image, u, top, weight_of) + t * lat_long_row(image, u, top + 1, weight_of);
  double sum = 0.0, weights = 0.0, values = 0.0, missing = 0.0;
  for (int k = 0; k < 4; ++k) {
    const int tx = left + k % 2, ty = top + k / 2;
    const double weight = (k % 2 ? s : 1.0 - s) * (k / 2 ? t : 1.0 - t);
    if (image.projection == SHD_PROJECTION_CUBE && is_outside(tx, image.width) && is_outside(ty, image.height)) {
      missing = weight;
      continue;
    }
    const FaceTexel texel = texel_at(image, tx, ty, place.face);
    const double value = image.at(texel.x, texel.y, texel.face);
    sum += weight * value, weights += weight, values += value;
  }
  return weights + missing > 0.0 ? sum + missing * values / 3.0 : 0.0;
}

/// The bicubic value in a direction. Not for discs.
inline double bicubic(const DirectionTexels& image, shd_cubic cubic, const long double* n) {
  const ref_place place = ref_project(image.projection, n);
  const double x = static_cast<double>(place.u) * image.width - 0.5;
  const double y = static_cast<double>(place.v) * image.height - 0.5;
  const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
  double sum = 0.0, weights = 0.0;
  for (int k = 0; k < 16; ++k) {
    const int tx = left - 1 + k % 4, ty = top - 1 + k / 4;
    const double weight = ::ref::cubic_weight(cubic, x - tx) * ::ref::cubic_weight(cubic, y - ty);
    const FaceTexel texel = texel_at(image, tx, ty, place.face);
    sum += weight * image.at(texel.x, texel.y, texel.face), weights += weight;
  }
  return sum / weights;
}

}  // namespace shd::ref
