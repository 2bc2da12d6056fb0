// SPDX-License-Identifier: MIT
#include "geometry/outline.h"

#include <cmath>

#include "geometry/clip.h"
#include "geometry/emit.h"

namespace shd::geometry {
namespace {

/// One triangle of the mesh, and the destination of its pieces.
struct Outlined {
  Assembly assembly;  // with SHD_CULL_NONE, because pieces have no facing of their own
  uint32_t primitive;
  core::Buffer<ScreenTriangle>* out;
};

/// Emits a quadrilateral as two triangles; corners in order around it.
TriangleOutcome emit_piece(const Outlined& o, const ScreenVertex (&corner)[4]) {
  const TriangleOutcome first = emit(o.assembly, corner[0], corner[1], corner[2], o.primitive, o.out);
  return std::max(first, emit(o.assembly, corner[0], corner[2], corner[3], o.primitive, o.out));
}

ScreenVertex moved(const ScreenVertex& v, int32_t x, int32_t y) {
  return {v.x + x, v.y + y, v.z, 0};
}

TriangleOutcome emit_point(const Outlined& o, const ScreenVertex& v) {
  const int32_t r = o.assembly.outline.reach;
  return emit_piece(o, {moved(v, -r, -r), moved(v, r, -r), moved(v, r, r), moved(v, -r, r)});
}

TriangleOutcome emit_line(const Outlined& o, const ScreenVertex& a, const ScreenVertex& b) {
  const auto dx = static_cast<double>(b.x - a.x), dy = static_cast<double>(b.y - a.y);
  if (dx == 0.0 && dy == 0.0) return TriangleOutcome::kCulled;
  const double scale = static_cast<double>(o.assembly.outline.reach) / std::sqrt(dx * dx + dy * dy);
  const auto x = static_cast<int32_t>(std::floor(0.5 - dy * scale));
  const auto y = static_cast<int32_t>(std::floor(0.5 + dx * scale));
  return emit_piece(o, {moved(a, x, y), moved(a, -x, -y), moved(b, -x, -y), moved(b, x, y)});
}

/// Whether the edge is drawn from its second vertex, so that both triangles that share it emit identical lines.
bool starts_at_second(const Vertices& vertices, uint32_t first, uint32_t second) {
  const float *a = &vertices.raster[4 * size_t{first}], *b = &vertices.raster[4 * size_t{second}];
  return std::lexicographical_compare(b, b + 4, a, a + 4);
}

TriangleOutcome emit_edge(const Outlined& o, uint32_t first, uint32_t second) {
  const Vertices& vertices = *o.assembly.vertices;
  if (starts_at_second(vertices, first, second)) std::swap(first, second);
  const ScreenVertex &a = vertices.screen[first], &b = vertices.screen[second];
  if (!((a.outcode | b.outcode) & kMustClip)) return emit_line(o, a, b);
  ScreenVertex end[2];
  return clip_segment(vertices, first, second, end) ? emit_line(o, end[0], end[1]) : TriangleOutcome::kUnseen;
}

/// Emits all edges. A triangle whose rows repeat has one edge, which is emitted once.
TriangleOutcome emit_edges(const Outlined& o, const uint32_t row[3]) {
  const bool repeats = row[0] == row[1] || row[1] == row[2] || row[2] == row[0];
  TriangleOutcome outcome = TriangleOutcome::kUnseen;
  bool has_edge = false;
  for (int k = 0; k < 3 && !(repeats && has_edge); ++k) {
    const uint32_t first = row[k], second = row[k == 2 ? 0 : k + 1];
    if (first == second) continue;
    outcome = std::max(outcome, emit_edge(o, first, second));
    has_edge = true;
  }
  return has_edge ? outcome : TriangleOutcome::kCulled;
}

/// Emits the feature edges that this triangle owns.
TriangleOutcome emit_lines(const Outlined& o, const uint32_t row[3]) {
  uint32_t kinds[3];
  find_edge_kinds(*o.assembly.mesh, o.assembly.query, o.primitive, kinds);
  if (!(kinds[0] | kinds[1] | kinds[2])) return TriangleOutcome::kCulled;
  TriangleOutcome outcome = TriangleOutcome::kUnseen;
  for (int k = 0; k < 3; ++k) {
    if (kinds[k]) outcome = std::max(outcome, emit_edge(o, row[k], row[k == 2 ? 0 : k + 1]));
  }
  return outcome;
}

TriangleOutcome emit_points(const Outlined& o, const uint32_t row[3]) {
  TriangleOutcome outcome = TriangleOutcome::kUnseen;
  for (int k = 0; k < 3; ++k) {
    const ScreenVertex& v = o.assembly.vertices->screen[row[k]];
    const bool is_repeated = (k > 0 && row[k] == row[0]) || (k > 1 && row[k] == row[1]);
    if (is_repeated || v.outcode & kMustClip) continue;
    outcome = std::max(outcome, emit_point(o, v));
  }
  return outcome;
}

/// Twice the area of a triangle after clipping.
int64_t clipped_area(const Vertices& vertices, const uint32_t row[3]) {
  ScreenVertex polygon[kMaxClipped];
  const int count = clip_triangle(vertices, row, polygon);
  int64_t area = 0;
  for (int i = 2; i < count; ++i) area += twice_area(polygon[0], polygon[i - 1], polygon[i]);
  return area;
}

/// Whether all lines and points of a triangle lie outside the visible pixels. The triangle needs no clipping.
bool is_far(const Assembly& assembly, const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c) {
  const int32_t reach = assembly.outline.reach;
  const GridBox box = {std::min({a.x, b.x, c.x}) - reach, std::min({a.y, b.y, c.y}) - reach,
                       std::max({a.x, b.x, c.x}) + reach, std::max({a.y, b.y, c.y}) + reach};
  return is_empty(intersection(pixel_box(box, assembly.samples), assembly.visible));
}

TriangleOutcome outline(const Outlined& o, shd_cull cull, const uint32_t row[3], bool must_clip) {
  const Vertices& vertices = *o.assembly.vertices;
  const ScreenVertex &a = vertices.screen[row[0]], &b = vertices.screen[row[1]], &c = vertices.screen[row[2]];
  if (!must_clip && is_far(o.assembly, a, b, c)) return TriangleOutcome::kUnseen;
  if (cull != SHD_CULL_NONE && o.assembly.outline.fill != SHD_FILL_LINES) {
    const int64_t area = must_clip ? clipped_area(vertices, row) : twice_area(a, b, c);
    if (cull == SHD_CULL_BACK ? area >= 0 : area <= 0) return TriangleOutcome::kCulled;
  }
  switch (o.assembly.outline.fill) {
    case SHD_FILL_LINES: return emit_lines(o, row);
    case SHD_FILL_POINTS: return emit_points(o, row);
    default: return emit_edges(o, row);
  }
}

}  // namespace

void assemble_outlines(const Assembly& assembly, size_t begin, size_t end, core::Buffer<ScreenTriangle>* out,
                       shd_render_stats* stats) {
  const ScreenVertex* screen = assembly.vertices->screen.data();
  Outlined o = {assembly, 0, out};
  o.assembly.cull = SHD_CULL_NONE;
  for (size_t i = begin; i < end; ++i) {
    const uint32_t row[3] = {row_of(*assembly.vertices, i, 0), row_of(*assembly.vertices, i, 1),
                             row_of(*assembly.vertices, i, 2)};
    const uint32_t codes[3] = {screen[row[0]].outcode, screen[row[1]].outcode, screen[row[2]].outcode};
    const uint32_t any = codes[0] | codes[1] | codes[2];
    o.primitive = static_cast<uint32_t>(i);
    if (any & kOutNonfinite) {
      ++stats->nonfinite_triangle_count;
    } else if (codes[0] & codes[1] & codes[2] & (kOutNear | kOutFar | kOutBehind)) {
      ++stats->outside_triangle_count;
    } else {
      stats->clipped_triangle_count += (any & kMustClip) != 0;
      count(outline(o, assembly.cull, row, (any & kMustClip) != 0), stats);
    }
  }
  stats->triangle_count += end - begin;
}

}  // namespace shd::geometry
