// SPDX-License-Identifier: MIT
#include "geometry/assemble.h"

#include "geometry/clip.h"
#include "geometry/emit.h"
#include "geometry/outline.h"

namespace shd::geometry {
namespace {

/// Clips a triangle, emits the pieces as a fan and returns their highest outcome.
TriangleOutcome clip_and_emit(const Assembly& assembly, const uint32_t row[3], uint32_t primitive,
                              core::Buffer<ScreenTriangle>* out) {
  ScreenVertex polygon[kMaxClipped];
  const int count = clip_triangle(*assembly.vertices, row, polygon);
  TriangleOutcome outcome = TriangleOutcome::kUnseen;
  for (int i = 2; i < count; ++i) {
    outcome = std::max(outcome, emit(assembly, polygon[0], polygon[i - 1], polygon[i], primitive, out));
  }
  return outcome;
}

}  // namespace

void assemble(const Assembly& assembly, size_t begin, size_t end, core::Buffer<ScreenTriangle>* out,
              shd_render_stats* stats) {
  if (assembly.outline.fill != SHD_FILL_SOLID) return assemble_outlines(assembly, begin, end, out, stats);
  const Vertices& vertices = *assembly.vertices;
  const ScreenVertex* screen = vertices.screen.data();
  const uint32_t first = vertices.first_index;
  const uint32_t* index = vertices.indices + 3 * (begin - vertices.first_triangle);
  for (size_t i = begin; i < end; ++i, index += 3) {
    const uint32_t row[3] = {index[0] - first, index[1] - first, index[2] - first};
    const ScreenVertex &a = screen[row[0]], &b = screen[row[1]], &c = screen[row[2]];
    const uint32_t any = a.outcode | b.outcode | c.outcode;
    if (any & kOutNonfinite) {
      ++stats->nonfinite_triangle_count;
      continue;
    }
    if (a.outcode & b.outcode & c.outcode & kOutside) {
      ++stats->outside_triangle_count;
      continue;
    }
    TriangleOutcome outcome;
    if (any & kMustClip) {
      ++stats->clipped_triangle_count;
      outcome = clip_and_emit(assembly, row, static_cast<uint32_t>(i), out);
    } else {
      outcome = emit(assembly, a, b, c, static_cast<uint32_t>(i), out);
    }
    count(outcome, stats);
  }
  stats->triangle_count += end - begin;
}

}  // namespace shd::geometry
