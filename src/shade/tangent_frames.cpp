// SPDX-License-Identifier: MIT
#include "shade/tangent_frames.h"

#include <algorithm>
#include <cmath>

#include "data/data.h"

namespace shd::shade {
namespace {

/// Calls body(triangle, begin, end) for runs of points of one triangle; the last run ends at a whole vector.
template <class Body>
void for_each_triangle(const raster::Fragments& points, const Body& body) {
  for (size_t begin = 0, end; begin < points.count; begin = end) {
    const uint32_t triangle = points.triangle[begin];
    for (end = begin + 1; end < points.count && points.triangle[end] == triangle;) ++end;
    body(triangle, begin, end == points.count ? data::padded(end) : end);
  }
}

struct TangentFrame {
  float dpdu[3], dpdv[3];
  float tangent[3], side;
};

// Computed in double, where products of floats neither overflow nor underflow.
TangentFrame tangent_frame_of(const geometry::Vertices& vertices, uint32_t uv_set, uint32_t triangle) {
  double p[3][3], uv[3][2];
  for (size_t k = 0; k < 3; ++k) {
    const size_t row = geometry::row_of(vertices, triangle, k);
    for (size_t c = 0; c < 3; ++c) p[k][c] = double{vertices.world[4 * row + c]};
    const bool has_second = vertices.texture1.size() != 0;
    uv[k][0] = uv_set == 0 ? double{u_of(vertices)[row]} : has_second ? double{u1_of(vertices)[row]} : 0.0;
    uv[k][1] = uv_set == 0 ? double{v_of(vertices)[row]} : has_second ? double{v1_of(vertices)[row]} : 0.0;
  }
  const double du1 = uv[1][0] - uv[0][0], dv1 = uv[1][1] - uv[0][1];
  const double du2 = uv[2][0] - uv[0][0], dv2 = uv[2][1] - uv[0][1];
  const double area = du1 * dv2 - du2 * dv1;
  TangentFrame frame = {};
  double dpdu[3], dpdv[3], squared = 0.0, largest = 0.0;
  for (int c = 0; c < 3; ++c) {
    const double e1 = p[1][c] - p[0][c], e2 = p[2][c] - p[0][c];
    dpdu[c] = (e1 * dv2 - e2 * dv1) / area;
    dpdv[c] = (e2 * du1 - e1 * du2) / area;
    squared += dpdu[c] * dpdu[c];
    largest = std::fmax(largest, std::fmax(std::fabs(dpdu[c]), std::fabs(dpdv[c])));
  }
  if (area == 0.0 || !(squared > 0.0) || !(largest < 1e18)) return frame;
  const double length = std::sqrt(squared);
  for (int c = 0; c < 3; ++c) {
    frame.dpdu[c] = static_cast<float>(dpdu[c]);
    frame.dpdv[c] = static_cast<float>(dpdv[c]);
    frame.tangent[c] = static_cast<float>(dpdu[c] / length);
  }
  frame.side = area > 0.0 ? 1.0f : -1.0f;
  return frame;
}

/// Whether the back of a triangle faces the eye: the sign of its homogeneous area on the screen, valid also for
/// vertices behind the eye.
bool is_seen_from_behind(const geometry::Vertices& vertices, float orientation, uint32_t triangle) {
  double v[3][3];
  for (size_t k = 0; k < 3; ++k) {
    const float* raster = &vertices.raster[4 * size_t{geometry::row_of(vertices, triangle, k)}];
    v[k][0] = double{raster[0]};
    v[k][1] = double{raster[1]};
    v[k][2] = double{raster[3]};
  }
  const double area = v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) -
                      v[0][1] * (v[1][0] * v[2][2] - v[1][2] * v[2][0]) +
                      v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
  return area * double{orientation} > 0.0;  // y runs down
}

}  // namespace

void make_tangent_frames(const geometry::Vertices& vertices, float orientation, uint32_t uv_set, bool sets_tangents,
                         raster::Fragments* points, Columns* columns) {
  for_each_triangle(*points, [&](uint32_t triangle, size_t begin, size_t end) {
    const TangentFrame frame = tangent_frame_of(vertices, uv_set, triangle);
    for (int c = 0; c < 3; ++c) {
      std::fill(columns->tangent_frame[c] + begin, columns->tangent_frame[c] + end, frame.dpdu[c]);
      std::fill(columns->tangent_frame[3 + c] + begin, columns->tangent_frame[3 + c] + end, frame.dpdv[c]);
    }
    if (!sets_tangents) return;
    std::fill(points->tx + begin, points->tx + end, frame.tangent[0]);
    std::fill(points->ty + begin, points->ty + end, frame.tangent[1]);
    std::fill(points->tz + begin, points->tz + end, frame.tangent[2]);
    // w (n x t) points against v, upwards in the image; n x dp/du does so if uv and the triangle have the same
    // orientation.
    std::fill(points->tw + begin, points->tw + end, -orientation * frame.side);
  });
}

void face_normals(const geometry::Vertices& vertices, float orientation, raster::Fragments* points) {
  for_each_triangle(*points, [&](uint32_t triangle, size_t begin, size_t end) {
    if (!is_seen_from_behind(vertices, orientation, triangle)) return;
    for (float* column : {points->nx, points->ny, points->nz}) {
      for (size_t i = begin; i < end; ++i) column[i] = -column[i];
    }
  });
}

}  // namespace shd::shade
