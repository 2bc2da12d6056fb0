// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "core/status.h"
#include "data/trig.h"
#include "projection/projection.h"

namespace shd::projection {
namespace {

using data::kPi;

/// A part of the plane of (2u - 1, 2v - 1).
struct Rectangle {
  double x0, x1, y0, y1;

  double area() const { return (x1 - x0) * (y1 - y0); }
};

struct Point {
  double x, y, z;
};

double dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Solid angle of a triangle seen from the origin, whose determinant is known (Van Oosterom and Strackee, "The Solid
/// Angle of a Plane Triangle", 1983).
double solid_angle(const Point& a, const Point& b, const Point& c, double determinant) {
  const double la = std::sqrt(dot(a, a)), lb = std::sqrt(dot(b, b)), lc = std::sqrt(dot(c, c));
  const double below = la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la;
  return 2.0 * data::angle_of(std::fabs(determinant), below);
}

/// On the plane z = 1 the determinant of a triangle is twice its area.
double on_cube(const Rectangle& r) {
  const Point a = {r.x0, r.y0, 1.0}, b = {r.x1, r.y0, 1.0}, c = {r.x1, r.y1, 1.0}, e = {r.x0, r.y1, 1.0};
  return solid_angle(a, b, c, r.area()) + solid_angle(a, c, e, r.area());
}

/// A polygon of the side x, y, z >= 0 of the octahedron, whose corners are given by x and y.
struct Polygon {
  Point corner[8];
  int count = 0;

  void add(double x, double y) { corner[count++] = {x, y, 1.0 - x - y}; }
  double seen() const {
    double sum = 0.0;
    for (int i = 2; i < count; ++i) {
      const Point &a = corner[0], &b = corner[i - 1], &c = corner[i];
      sum += solid_angle(a, b, c, (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
    }
    return sum;
  }
};

/// A rectangle of the quadrant x, y >= 0. The line x + y = 1 divides it into the part in front and the part
/// behind, whose fold is a reflection in this line.
double on_octahedron(const Rectangle& r) {
  const double x[4] = {r.x0, r.x1, r.x1, r.x0}, y[4] = {r.y0, r.y0, r.y1, r.y1};
  Polygon front, behind;
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    const double here = 1.0 - x[i] - y[i], next = 1.0 - x[j] - y[j];
    if (here >= 0.0) front.add(x[i], y[i]);
    if (here <= 0.0) behind.add(1.0 - y[i], 1.0 - x[i]);
    if ((here > 0.0 && next < 0.0) || (here < 0.0 && next > 0.0)) {
      const double t = here / (here - next), cx = x[i] + t * (x[j] - x[i]);
      front.add(cx, 1.0 - cx);
      behind.add(cx, 1.0 - cx);
    }
  }
  return front.seen() + behind.seen();
}

/// Area under the unit circle from 0 to x.
double area_below_circle(double x) {
  const double y = std::sqrt(std::max(0.0, 1.0 - x * x));
  return 0.5 * (x * y + data::angle_of(x, y));
}

/// Area of the part of the unit disc in [0, x] x [0, y].
double disc_area(double x, double y) {
  if (x * x + y * y <= 1.0) return x * y;
  const double corner = std::sqrt(std::max(0.0, 1.0 - y * y));
  return corner * y + (area_below_circle(std::min(x, 1.0)) - area_below_circle(corner));
}

/// The mirror ball keeps areas: the disc of area pi shows 4 pi.
double on_mirror_ball(const Rectangle& r) {
  if (r.x1 * r.x1 + r.y1 * r.y1 <= 1.0) return 4.0 * r.area();
  if (r.x0 * r.x0 + r.y0 * r.y0 >= 1.0) return 0.0;
  const double inside =
      (disc_area(r.x1, r.y1) - disc_area(r.x0, r.y1)) - (disc_area(r.x1, r.y0) - disc_area(r.x0, r.y0));
  return 4.0 * std::max(0.0, inside);
}

/// Solid angle per area of the angular map, at the distance r from its centre.
double angular_density(double squared) {
  const double r = std::sqrt(squared);
  if (r >= 1.0) return 0.0;
  if (r < 1e-8) return kPi * kPi;
  return kPi * data::sin(kPi * std::min(r, 1.0 - r)) / r;
}

/// Integral of f from a to b by the Gauss-Legendre rule of four points on each of `parts` parts.
template <class F>
double integrate(double a, double b, int parts, const F& f) {
  constexpr double kNode[2] = {0.33998104358485626, 0.86113631159405258};
  constexpr double kWeight[2] = {0.65214515486254614, 0.34785484513745386};
  double sum = 0.0;
  for (int i = 0; i < parts; ++i) {
    const double half = 0.5 * (b - a) / parts, middle = a + (2 * i + 1) * half;
    for (int k = 0; k < 2; ++k) sum += half * kWeight[k] * (f(middle - half * kNode[k]) + f(middle + half * kNode[k]));
  }
  return sum;
}

double on_angular_map(const Rectangle& r) {
  if (r.x0 * r.x0 + r.y0 * r.y0 >= 1.0) return 0.0;
  const int parts = r.x1 - r.x0 > 0.05 || r.y1 - r.y0 > 0.05 ? 8 : 1;
  const auto column = [&](double x) {
    const double top = std::min(r.y1, std::sqrt(std::max(0.0, 1.0 - x * x)));
    if (top <= r.y0) return 0.0;
    return integrate(r.y0, top, parts, [&](double y) { return angular_density(x * x + y * y); });
  };
  if (r.x1 * r.x1 + r.y1 * r.y1 <= 1.0) return integrate(r.x0, r.x1, parts, column);
  // Columns are cut by the rim from the first break on, and are empty from the second one on.
  const double end = std::min(r.x1, std::sqrt(std::max(0.0, 1.0 - r.y0 * r.y0)));
  const double cut = std::min(end, std::max(r.x0, std::sqrt(std::max(0.0, 1.0 - r.y1 * r.y1))));
  // end - x = t^2 makes the integrand smooth where the rim is vertical.
  const auto reversed = [&](double t) { return 2.0 * t * column(end - t * t); };
  return integrate(r.x0, cut, parts, column) + integrate(0.0, std::sqrt(end - cut), 8, reversed);
}

/// Sum over the parts of a rectangle in the four quadrants, each reflected into the first one.
template <class Part>
double sum_of_quadrants(const Rectangle& r, const Part& part) {
  double sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    Rectangle q = r;
    if (i % 2) q.x0 = -r.x1, q.x1 = -r.x0;
    if (i / 2) q.y0 = -r.y1, q.y1 = -r.y0;
    q.x0 = std::max(0.0, q.x0), q.y0 = std::max(0.0, q.y0);
    if (q.x1 > q.x0 && q.y1 > q.y0) sum += part(q);
  }
  return sum;
}

/// sin(pi i / (2 n)) for i in 0..2n.
double sine(uint32_t i, uint32_t n) {
  return data::sin(0.5 * kPi * (static_cast<double>(std::min(i, 2 * n - i)) / n));
}

double edge(uint32_t i, uint32_t n) {
  return (2.0 * i - n) / n;
}

}  // namespace

double texel_solid_angle(shd_projection projection, uint32_t width, uint32_t height, uint32_t x, uint32_t y) {
  const Rectangle r = {edge(x, width), edge(x + 1, width), edge(y, height), edge(y + 1, height)};
  switch (projection) {
    case SHD_PROJECTION_LAT_LONG: return 4.0 * kPi / width * sine(2 * y + 1, height) * sine(1, height);
    case SHD_PROJECTION_MIRROR_BALL: return sum_of_quadrants(r, on_mirror_ball);
    case SHD_PROJECTION_ANGULAR: return sum_of_quadrants(r, on_angular_map);
    case SHD_PROJECTION_OCTAHEDRAL: return sum_of_quadrants(r, on_octahedron);
    case SHD_PROJECTION_CUBE: return on_cube(r);
    case SHD_PROJECTION_NONE:
    case SHD_PROJECTION_MAX_ENUM: break;
  }
  SHD_UNREACHABLE();
}

}  // namespace shd::projection
