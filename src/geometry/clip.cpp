// SPDX-License-Identifier: MIT
#include "geometry/clip.h"

#include <cmath>

namespace shd::geometry {
namespace {

struct ClipVertex {
  double x, y, z, w;
  const ScreenVertex* original;  // null for a vertex made by clipping
};

struct ClippedPolygon {
  ClipVertex vertex[kMaxClipped];
  int count;
};

/// Signed distance to a plane, up to a positive factor; >= 0 is inside.
double distance(int plane, const ClipVertex& v) {
  const double guard = static_cast<double>(kGuardBand);
  switch (plane) {
    case 0: return v.w - static_cast<double>(kMinW);
    case 1: return v.z;
    case 2: return v.w - v.z;
    case 3: return v.x + guard * v.w;
    case 4: return guard * v.w - v.x;
    case 5: return v.y + guard * v.w;
    default: return guard * v.w - v.y;
  }
}

/// Intersection of an edge with a plane. The arithmetic is the same from either side of the edge, so that both
/// neighbouring triangles get the same vertex. The interpolation starts from the end nearer to the plane: starting
/// from a distant end cancels the low digits of the result.
ClipVertex intersect(const ClipVertex& in, const ClipVertex& out, double in_distance, double out_distance) {
  const bool from_in = in_distance <= -out_distance;
  const ClipVertex &a = from_in ? in : out, &b = from_in ? out : in;
  const double t = (from_in ? in_distance : -out_distance) / (in_distance - out_distance);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z), a.w + t * (b.w - a.w), nullptr};
}

void clip_plane(int plane, const ClippedPolygon& in, ClippedPolygon* out) {
  out->count = 0;
  for (int i = 0; i < in.count; ++i) {
    const ClipVertex& a = in.vertex[i];
    const ClipVertex& b = in.vertex[(i + 1) % in.count];
    const double da = distance(plane, a), db = distance(plane, b);
    if (da >= 0.0) out->vertex[out->count++] = a;
    if (da >= 0.0 && db < 0.0) out->vertex[out->count++] = intersect(a, b, da, db);
    if (da < 0.0 && db >= 0.0) out->vertex[out->count++] = intersect(b, a, db, da);
  }
}

double clamp(double value, double low, double high) {
  return value < low ? low : value > high ? high : value;
}

ScreenVertex project(const ClipVertex& v) {
  if (v.original && !(v.original->outcode & kMustClip)) return *v.original;
  const double w = v.w > 0.0 ? v.w : static_cast<double>(kMinW);
  const double guard = static_cast<double>(kGuardBand);
  const auto snap = [&](double numerator) {
    return static_cast<int32_t>(std::floor(clamp(numerator / w, -guard, guard) * kSubpixels + 0.5));
  };
  return {snap(v.x), snap(v.y), static_cast<float>(clamp(v.z / w, 0.0, 1.0)), 0};
}

ClipVertex clip_vertex(const Vertices& vertices, uint32_t row) {
  const float* v = &vertices.raster[4 * size_t{row}];
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]), static_cast<double>(v[3]),
          &vertices.screen[row]};
}

constexpr int kPlanes = 7;

}  // namespace

int clip_triangle(const Vertices& vertices, const uint32_t row[3], ScreenVertex* out) {
  ClippedPolygon polygon[2];
  polygon[0].count = 3;
  for (int k = 0; k < 3; ++k) polygon[0].vertex[k] = clip_vertex(vertices, row[k]);
  int current = 0;
  for (int plane = 0; plane < kPlanes && polygon[current].count >= 3; ++plane) {
    clip_plane(plane, polygon[current], &polygon[1 - current]);
    current = 1 - current;
  }
  const ClippedPolygon& result = polygon[current];
  if (result.count < 3) return 0;
  for (int i = 0; i < result.count; ++i) out[i] = project(result.vertex[i]);
  return result.count;
}

bool clip_segment(const Vertices& vertices, uint32_t first, uint32_t second, ScreenVertex out[2]) {
  ClipVertex a = clip_vertex(vertices, first), b = clip_vertex(vertices, second);
  for (int plane = 0; plane < kPlanes; ++plane) {
    const double da = distance(plane, a), db = distance(plane, b);
    if (da < 0.0 && db < 0.0) return false;
    if (db < 0.0) {
      b = intersect(a, b, da, db);
    } else if (da < 0.0) {
      a = intersect(b, a, db, da);
    }
  }
  out[0] = project(a);
  out[1] = project(b);
  return true;
}

}  // namespace shd::geometry
