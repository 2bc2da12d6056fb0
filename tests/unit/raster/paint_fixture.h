// SPDX-License-Identifier: MIT
// Scenes for the tests of the order of painting.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/context.h"
#include "raster/newell.h"
#include "raster/painter.h"  // before cmocka, whose fail() is a macro
#include "ref/painter_ref.h"
#include "support/check.h"
#include "support/random.h"

namespace shd::tests {

constexpr int kEdge = 64; /* pixels of the picture */
using geometry::ScreenTriangle;
using Triangles = std::vector<ScreenTriangle>;

/// Appends a triangle given in pixels, with the winding of the rasteriser; leaves it out if it has no area.
inline void append(Triangles& out, const double (&corner)[3][3]) {
  ScreenTriangle t = {};
  for (int k = 0; k < 3; ++k) {
    t.x[k] = static_cast<int32_t>(std::floor(corner[k][0] * 256 + 0.5));
    t.y[k] = static_cast<int32_t>(std::floor(corner[k][1] * 256 + 0.5));
    t.z[k] = static_cast<float>(corner[k][2]);
  }
  if (raster::doubled_area(t) < 0) {
    std::swap(t.x[1], t.x[2]);
    std::swap(t.y[1], t.y[2]);
    std::swap(t.z[1], t.z[2]);
  }
  t.primitive = static_cast<uint32_t>(out.size());
  if (raster::doubled_area(t) > 0) out.push_back(t);
}

/// Triangles of any size and tilt that intersect each other.
inline Triangles make_tangle(Random random, int count, double size) {
  Triangles out;
  for (int i = 0; i < count; ++i) {
    double corner[3][3];
    const double x = random.in(0, kEdge), y = random.in(0, kEdge), z = random.in(0.1, 0.9);
    for (auto& c : corner) {
      c[0] = x + random.in(-size, size);
      c[1] = y + random.in(-size, size);
      c[2] = std::min(std::max(z + random.in(-0.3, 0.3), 0.0), 1.0);
    }
    append(out, corner);
  }
  return out;
}

/// Each triangle covers the next and the last covers the first: no order is correct, although no two intersect.
inline Triangles make_circle(int count, double turn) {
  Triangles out;
  for (int i = 0; i < count; ++i) {
    const double angle = turn + 6.283185307179586 * i / count, c = std::cos(angle), s = std::sin(angle);
    const double from = -20, to = 20, off = 6, width = 4;
    const double corner[3][3] = {{32 + c * from - s * off, 32 + s * from + c * off, 0.2},
                                 {32 + c * to - s * (off - width), 32 + s * to + c * (off - width), 0.8},
                                 {32 + c * to - s * (off + width), 32 + s * to + c * (off + width), 0.8}};
    append(out, corner);
  }
  return out;
}

/// Sheets that are separate in depth, from near to far.
inline Triangles make_layers(Random random, int count) {
  Triangles out;
  for (int i = 0; i < count; ++i) {
    double corner[3][3];
    for (auto& c : corner) {
      c[0] = random.in(-20, kEdge + 20);
      c[1] = random.in(-20, kEdge + 20);
      c[2] = 0.05 + 0.9 * (i + random.in(0.0, 0.9)) / count;
    }
    append(out, corner);
  }
  return out;
}

/// A hilly floor in perspective, seen from the side, and objects standing in it.
inline Triangles make_floor(Random random, int cells) {
  Triangles out;
  std::vector<double> height(static_cast<size_t>((cells + 1) * (cells + 1)));
  for (double& h : height) h = random.in(0, 0.4);
  const auto project = [](double x, double y, double z, double(&to)[3]) {
    const double w = 1.2 + 4 * z;
    to[0] = kEdge * (0.5 + 2.2 * x / w);
    to[1] = kEdge * (0.5 + (0.8 - y) / w);
    to[2] = 1.02 - 1.2 / w;
  };
  const auto vertex = [&](int i, int k, double(&to)[3]) {
    project(static_cast<double>(i) / cells - 0.5, height[static_cast<size_t>(i + k * (cells + 1))],
            static_cast<double>(k) / cells, to);
  };
  for (int k = 0; k < cells; ++k) {
    for (int i = 0; i < cells; ++i) {
      double corner[3][3];
      vertex(i, k, corner[0]);
      vertex(i + 1, k, corner[1]);
      vertex(i, k + 1, corner[2]);
      append(out, corner);
      vertex(i + 1, k + 1, corner[0]);
      append(out, corner);
    }
  }
  for (int i = 0; i < cells; ++i) {
    double corner[3][3];
    const double x = random.in(-0.4, 0.4), z = random.in(0.1, 0.9);
    project(x, -0.2, z, corner[0]);
    project(x + 0.2, -0.1, z + 0.05, corner[1]);
    project(x + 0.1, 0.8, z, corner[2]);
    append(out, corner);
  }
  return out;
}

/// Group of triangles `begin`..`end` - 1.
inline void fill_groups(const core::Context& context, const Triangles& triangles,
                        core::Objects<raster::TriangleGroup>* groups) {
  for (size_t g = 0; g < groups->size(); ++g) {
    (*groups)[g].attach(context.allocator);
    for (size_t i = triangles.size() * g / groups->size(); i < triangles.size() * (g + 1) / groups->size(); ++i) {
      (*groups)[g].push_back(triangles[i]);
    }
  }
}

inline Triangles read_groups(const core::Objects<raster::TriangleGroup>& groups) {
  Triangles out;
  for (size_t g = 0; g < groups.size(); ++g)
    out.insert(out.end(), groups[g].data(), groups[g].data() + groups[g].size());
  return out;
}

}  // namespace shd::tests
