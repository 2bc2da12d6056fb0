// SPDX-License-Identifier: MIT
#include "scene/read/polygon.h"

#include <cmath>

namespace shd::scene {
namespace {

struct Flat {
  double x, y;
};

double cross(const Flat& a, const Flat& b, const Flat& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool is_same(const Flat& a, const Flat& b) {
  return a.x == b.x && a.y == b.y;
}

/// The corners along the axis in which the normal is longest, counter-clockwise.
std::vector<Flat> flatten(const std::vector<Point>& corners) {
  const Point n = newell_normal(corners);
  const size_t axis = std::fabs(n[0]) > std::fabs(n[1]) ? (std::fabs(n[0]) > std::fabs(n[2]) ? 0 : 2)
                                                        : (std::fabs(n[1]) > std::fabs(n[2]) ? 1 : 2);
  const size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
  std::vector<Flat> out;
  out.reserve(corners.size());
  for (const Point& p : corners) {
    const Flat flat = {p[x] - corners[0][x], p[y] - corners[0][y]};
    out.push_back(n[axis] < 0 ? Flat{flat.y, flat.x} : flat);
  }
  return out;
}

/// A ring of corners that loses its ears.
struct Ring {
  const std::vector<Flat>& at;
  std::vector<uint32_t> before, after;
  uint32_t left;

  explicit Ring(const std::vector<Flat>& corners)
      : at(corners), before(corners.size()), after(corners.size()), left(static_cast<uint32_t>(corners.size())) {
    for (uint32_t i = 0; i < left; ++i) {
      before[i] = (i + left - 1) % left;
      after[i] = (i + 1) % left;
    }
  }
  double turn(uint32_t i) const { return cross(at[before[i]], at[i], at[after[i]]); }
  void remove(uint32_t i) {
    after[before[i]] = after[i];
    before[after[i]] = before[i];
    --left;
  }
};

/// No other corner that is not convex lies in the triangle at `i`. Corners at the places of its own are those of
/// bridges; a part of the border that enters the triangle there has another corner inside.
bool is_ear(const Ring& ring, uint32_t i) {
  const uint32_t p = ring.before[i], n = ring.after[i];
  const Flat &a = ring.at[p], &b = ring.at[i], &c = ring.at[n];
  if (!(ring.turn(i) > 0)) return false;
  for (uint32_t k = ring.after[n]; k != p; k = ring.after[k]) {
    const Flat& q = ring.at[k];
    if (ring.turn(k) > 0 || is_same(q, a) || is_same(q, b) || is_same(q, c)) continue;
    if (cross(a, b, q) >= 0 && cross(b, c, q) >= 0 && cross(c, a, q) >= 0) return false;
  }
  return true;
}

void clip_ears(const std::vector<Flat>& corners, const Deadline& deadline, std::vector<std::array<uint32_t, 3>>& out) {
  Ring ring(corners);
  uint32_t i = 0, failures = 0, steps = 0;
  while (ring.left > 3) {
    if (++steps % 64 == 0) deadline.check();
    const uint32_t next = ring.after[i];
    const bool flat = ring.turn(i) == 0 && failures >= ring.left;  // no ear is left but those without area
    if (is_ear(ring, i) || flat || failures > 2 * ring.left) {
      out.push_back({ring.before[i], i, next});
      ring.remove(i);
      failures = 0;
      i = ring.after[next];  // not the neighbour, so that no fan of slivers arises
    } else {
      ++failures;
      i = next;
    }
  }
  out.push_back({ring.before[i], i, ring.after[i]});
}

}  // namespace

Point newell_normal(const std::vector<Point>& corners) {
  Point sum = {0, 0, 0};
  const Point& o = corners[0];
  for (size_t i = 1; i + 1 < corners.size(); ++i) {
    const Point &p = corners[i], &q = corners[i + 1];
    for (size_t c = 0; c < 3; ++c) {
      const size_t d = (c + 1) % 3, e = (c + 2) % 3;
      sum[c] += (p[d] - o[d]) * (q[e] - o[e]) - (p[e] - o[e]) * (q[d] - o[d]);
    }
  }
  return sum;
}

void triangulate(const std::vector<Point>& corners, const Deadline& deadline,
                 std::vector<std::array<uint32_t, 3>>& out) {
  if (corners.size() == 3) {
    out.push_back({0, 1, 2});
    return;
  }
  const std::vector<Flat> flat = flatten(corners);
  const auto turn = [&flat](size_t a, size_t b, size_t c) { return cross(flat[a], flat[b], flat[c]); };
  if (corners.size() == 4 && turn(0, 1, 2) >= 0 && turn(0, 2, 3) >= 0) {
    out.push_back({0, 1, 2});
    out.push_back({0, 2, 3});
    return;
  }
  clip_ears(flat, deadline, out);
}

}  // namespace shd::scene
