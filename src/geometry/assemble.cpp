// SPDX-License-Identifier: MIT
#include "geometry/assemble.h"

#include "geometry/clip.h"

namespace shd::geometry {
namespace {

enum class Fate { kOutside, kCulled, kEmpty, kRasterised };

/// Appends the triangle unless it cannot be seen.
Fate emit(const Assembly& assembly, const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c,
          uint32_t primitive, core::Buffer<ScreenTriangle>* out) {
  const int64_t area = (int64_t{b.x} - a.x) * (int64_t{c.y} - a.y) - (int64_t{c.x} - a.x) * (int64_t{b.y} - a.y);
  // Counter-clockwise with y up is negative with y down.
  if (area == 0 || (assembly.cull == SHD_CULL_BACK && area > 0) || (assembly.cull == SHD_CULL_FRONT && area < 0)) {
    return Fate::kCulled;
  }
  const ScreenVertex& second = area > 0 ? b : c;
  const ScreenVertex& third = area > 0 ? c : b;
  const ScreenTriangle triangle = {
      {a.x, second.x, third.x}, {a.y, second.y, third.y}, {a.z, second.z, third.z}, assembly.draw, primitive, 0};
  const PixelBox box = pixel_box(triangle, assembly.samples);
  if (is_empty(box)) return Fate::kEmpty;
  if (is_empty(intersection(box, assembly.visible))) return Fate::kOutside;
  out->push_back(triangle);
  return Fate::kRasterised;
}

/// Clips and emits the fan; the best fate of its pieces counts.
Fate clip_and_emit(const Assembly& assembly, const uint32_t row[3], uint32_t primitive,
                   core::Buffer<ScreenTriangle>* out) {
  ScreenVertex polygon[kMaxClipped];
  const int count = clip_triangle(*assembly.vertices, row, polygon);
  Fate fate = Fate::kOutside;
  for (int i = 2; i < count; ++i) {
    fate = std::max(fate, emit(assembly, polygon[0], polygon[i - 1], polygon[i], primitive, out));
  }
  return fate;
}

}  // namespace

void assemble(const Assembly& assembly, size_t begin, size_t end, core::Buffer<ScreenTriangle>* out,
              shd_render_stats* stats) {
  const Vertices& vertices = *assembly.vertices;
  const ScreenVertex* screen = vertices.screen.data();
  const uint32_t first = vertices.first_index;
  const uint32_t* index = vertices.indices + 3 * (begin - vertices.first_triangle);
  for (size_t i = begin; i < end; ++i, index += 3) {
    const uint32_t row[3] = {index[0] - first, index[1] - first, index[2] - first};
    const ScreenVertex &a = screen[row[0]], &b = screen[row[1]], &c = screen[row[2]];
    const uint32_t any = a.outcode | b.outcode | c.outcode;
    if (any & kOutNonfinite) {
      ++stats->nonfinite;
      continue;
    }
    if (a.outcode & b.outcode & c.outcode & kOutside) {
      ++stats->outside;
      continue;
    }
    Fate fate;
    if (any & kMustClip) {
      ++stats->clipped;
      fate = clip_and_emit(assembly, row, static_cast<uint32_t>(i), out);
    } else {
      fate = emit(assembly, a, b, c, static_cast<uint32_t>(i), out);
    }
    stats->outside += fate == Fate::kOutside;
    stats->culled += fate == Fate::kCulled;
    stats->empty += fate == Fate::kEmpty;
    stats->rasterised += fate == Fate::kRasterised;
  }
  stats->triangles += end - begin;
}

}  // namespace shd::geometry
