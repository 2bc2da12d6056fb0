// SPDX-License-Identifier: MIT
// SHD_FILTER_EXACT on textures of directions, by many samples in double. On CUBE a sample is a direction, and its
// bilinear value counts by the area that it has on its own face. On the others it is a point of the lattice of texels.
#pragma once

#include "ref/direction_filter_ref.h"

namespace shd::ref {

/// A footprint on an image: its centre (u, v), its sides, and its face.
struct DirectionFootprint {
  ref_place center;
  double a[2], b[2];
};

inline bool is_disc(shd_projection projection) {
  return projection == SHD_PROJECTION_MIRROR_BALL || projection == SHD_PROJECTION_ANGULAR;
}

/// The footprint of a direction with its changes: at most one circle along a parallel, and half of the image of a disc.
inline DirectionFootprint direction_footprint(shd_projection projection, const long double* n, const long double* dx,
                                              const long double* dy) {
  const auto side = [&](const long double* dn, double(&out)[2]) {
    const ref_change step = ref_step(projection, n, dn);
    out[0] = static_cast<double>(step.du), out[1] = static_cast<double>(step.dv);
    if (projection == SHD_PROJECTION_LAT_LONG) out[0] = std::fmax(std::fmin(out[0], 1.0), -1.0);
    const double largest = std::fmax(std::fabs(out[0]), std::fabs(out[1]));
    for (double& x : out) x *= is_disc(projection) && largest > 0.5 ? 0.5 / largest : 1.0;
  };
  DirectionFootprint out = {ref_project(projection, n), {}, {}};
  side(dx, out.a);
  side(dy, out.b);
  return out;
}

/// The square of `edge` texels that a level of detail has.
inline DirectionFootprint square_footprint(const DirectionTexels& image, const long double* n, double edge) {
  DirectionFootprint out = {ref_project(image.projection, n), {edge / image.width, 0}, {0, edge / image.height}};
  if (image.projection == SHD_PROJECTION_LAT_LONG) {
    const double cosine = std::sin(M_PI * static_cast<double>(out.center.v));
    out.a[0] = std::fmin(out.a[0] / cosine, 1.0);
  }
  if (is_disc(image.projection)) out.a[0] = out.b[1] = std::fmin(out.a[0], 0.5);
  return out;
}

/// The texel of a disc at (x, y): beyond the rim, the nearest one to the point at 2 - r on the other side.
inline double disc_texel(const DirectionTexels& image, int x, int y) {
  const double n = image.width, p = (2.0 * x + 1.0) / n - 1.0, q = (2.0 * y + 1.0) / n - 1.0, r = std::hypot(p, q);
  if (r <= 1.0) return image.at(x, y, 0);
  const double inner = std::fmax(std::fmin(2.0 - r, 1.0 - std::sqrt(2.0) / n), 0.0);
  const auto along = [&](double at) {
    const int texel = static_cast<int>(std::floor((1.0 - at * inner / r) / 2.0 * n));
    return std::min(std::max(texel, 0), image.width - 1);
  };
  return image.at(along(p), along(q), 0);
}

/// The texel that continues the lattice of an image at (x, y). Not for CUBE.
inline double lattice_texel(const DirectionTexels& image, int x, int y) {
  const int w = image.width, h = image.height;
  if (is_disc(image.projection)) return disc_texel(image, x, y);
  if (image.projection == SHD_PROJECTION_OCTAHEDRAL) {
    // Every second tile of the plane is the image, and the others are the image turned by half a circle.
    const int across = modulo(x, w), down = modulo(y, h), tiles = (x - across) / w + (y - down) / h;
    return tiles % 2 == 0 ? image.at(across, down, 0) : image.at(w - 1 - across, h - 1 - down, 0);
  }
  const int row = modulo(y, 2 * h);
  if (row < h) return image.at(modulo(x, w), row, 0);
  const int left = modulo(x + w / 2, w), right = modulo(x + (w + 1) / 2, w);
  return (image.at(left, 2 * h - 1 - row, 0) + image.at(right, 2 * h - 1 - row, 0)) / 2.0;
}

inline double lattice_value(const DirectionTexels& image, double x, double y) {
  const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
  const double s = x - left, t = y - top;
  return (1 - t) * ((1 - s) * lattice_texel(image, left, top) + s * lattice_texel(image, left + 1, top)) +
         t * ((1 - s) * lattice_texel(image, left, top + 1) + s * lattice_texel(image, left + 1, top + 1));
}

/// Average of n x n samples of an image.
inline double direction_average(const DirectionTexels& image, const DirectionFootprint& f, int n) {
  double sum = 0.0, weights = 0.0;
  const double u = static_cast<double>(f.center.u), v = static_cast<double>(f.center.v);
  for (int k = 0; k < n * n; ++k) {
    const double s = (k % n + 0.5) / n - 0.5, t = (k / n + 0.5) / n - 0.5;
    const double at_u = u + s * f.a[0] + t * f.b[0], at_v = v + s * f.a[1] + t * f.b[1];
    if (image.projection != SHD_PROJECTION_CUBE) {
      sum += lattice_value(image, at_u * image.width - 0.5, at_v * image.height - 0.5), weights += 1.0;
      continue;
    }
    const int* row = ref_cube_table[f.center.face];
    const double part[3] = {1.0, 2.0 * at_u - 1.0, 2.0 * at_v - 1.0};
    long double direction[3];
    for (int c = 0; c < 3; ++c) direction[std::abs(row[c]) - 1] = row[c] > 0 ? part[c] : -part[c];
    const double largest = std::fmax(1.0, std::fmax(std::fabs(part[1]), std::fabs(part[2])));
    const double weight = 1.0 / (largest * largest * largest);  // area on the face that the direction meets
    sum += weight * bilinear(image, direction), weights += weight;
  }
  return sum / weights;
}

}  // namespace shd::ref
