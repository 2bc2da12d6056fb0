// SPDX-License-Identifier: MIT
// Projections of directions and their derivatives, and directions of points, against the published formulas in long
// double, on every target, and bit for bit between targets.
#include <hwy/highway.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "projection/projection.h"
#include "ref/projection_ref.h"
#include "support/check.h"

namespace {

using namespace shd;

constexpr shd_projection kProjections[] = {SHD_PROJECTION_LAT_LONG, SHD_PROJECTION_MIRROR_BALL, SHD_PROJECTION_ANGULAR,
                                           SHD_PROJECTION_CUBE, SHD_PROJECTION_OCTAHEDRAL};

bool is_disc(shd_projection projection) {
  return projection == SHD_PROJECTION_MIRROR_BALL || projection == SHD_PROJECTION_ANGULAR;
}

uint32_t g_state = 1;
float random_float() {
  g_state = g_state * 1664525u + 1013904223u;
  return static_cast<float>(g_state >> 8) * 0x1p-23f - 1.0f;
}

constexpr size_t kCount = 6007;

struct Case {
  float n[3][kCount], dx[3][kCount], dy[3][kCount];
  float u[kCount], v[kCount], du[2][kCount], dv[2][kCount];
  uint32_t face[kCount];

  /// Random directions, then directions near axes, edges and seams, of many lengths.
  void fill() {
    for (size_t i = 0; i < kCount; ++i) {
      const float length = i % 3 ? 1.0f : std::ldexp(1.0f, static_cast<int>(i % 200) - 100);
      for (int c = 0; c < 3; ++c) {
        float x = random_float();
        if (i % 4 == 1) x *= std::ldexp(1.0f, -static_cast<int>(g_state >> 27));
        if (i % 8 == 2) x = std::floor(2.0f * x + 1.0f);
        n[c][i] = x * length;
        dx[c][i] = random_float() * length;
        dy[c][i] = random_float() * length * 0.01f;
      }
      if (n[0][i] == 0.0f && n[1][i] == 0.0f && n[2][i] == 0.0f) n[0][i] = length;
    }
  }
  projection::Directions in() const {
    return {kCount, {n[0], n[1], n[2]}, {{dx[0], dx[1], dx[2]}, {dy[0], dy[1], dy[2]}}};
  }
  projection::Points out() { return {u, v, face, {du[0], du[1]}, {dv[0], dv[1]}}; }
};

Case g_case;

template <class Body>
void on_every_target(const Body& body) {
  for (int64_t bit : hwy::SupportedAndGeneratedTargets()) body(core::simd_target_from_bit(bit));
}

/// Distance of two points of an image, across the seam of LAT_LONG.
long double apart(shd_projection projection, long double a, long double b) {
  const long double d = std::fabs(a - b);
  return projection == SHD_PROJECTION_LAT_LONG ? std::fmin(d, 1.0L - d) : d;
}

void check_place(shd_projection projection, size_t i) {
  const long double n[3] = {g_case.n[0][i], g_case.n[1][i], g_case.n[2][i]};
  const ref_place want = ref_project(projection, n);
  if (g_case.face[i] != want.face) fail_msg("[%zu]: face %u instead of %u", i, g_case.face[i], want.face);
  double du = static_cast<double>(apart(projection, g_case.u[i], want.u));
  // Components below 2^-100 of the largest one may count as 0: another meridian of the pole, another corner for -Z.
  if (projection == SHD_PROJECTION_LAT_LONG && std::hypot(n[0], n[2]) < 0x1p-100L * std::fabs(n[1])) du = 0.0;
  double dv = static_cast<double>(std::fabs(g_case.v[i] - want.v));
  if (projection == SHD_PROJECTION_OCTAHEDRAL && std::fabs(n[0]) < -0x1p-100L * n[2]) {
    du = static_cast<double>(std::fabs(g_case.u[i] - 0.5L) - std::fabs(want.u - 0.5L));
  }
  if (projection == SHD_PROJECTION_OCTAHEDRAL && std::fabs(n[1]) < -0x1p-100L * n[2]) {
    dv = static_cast<double>(std::fabs(g_case.v[i] - 0.5L) - std::fabs(want.v - 0.5L));
  }
  // Directions within 2^-50 rad of -Z count as -Z.
  if (is_disc(projection) && std::hypot(n[0], n[1]) < -0x1p-50L * n[2]) {
    du = static_cast<double>(std::fabs(g_case.u[i] - 1.0L)), dv = static_cast<double>(std::fabs(g_case.v[i] - 0.5L));
  }
  if (!(std::fabs(du) <= 3e-7 && std::fabs(dv) <= 3e-7)) {
    fail_msg("projection %d [%zu] (%g, %g, %g): (%g, %g) is off by (%g, %g)", projection, i, double{g_case.n[0][i]},
             double{g_case.n[1][i]}, double{g_case.n[2][i]}, double{g_case.u[i]}, double{g_case.v[i]}, du, dv);
  }
}

/// Derivatives against central differences of the formulas. The derivative of a point grows towards poles and rims: the
/// tolerance is relative to the largest one of the point. Points next to a fold are left out.
bool check_steps(shd_projection projection, size_t i) {
  long double n[3] = {g_case.n[0][i], g_case.n[1][i], g_case.n[2][i]}, length = 0.0L;
  for (long double x : n) length += x * x;
  length = std::sqrt(length);
  const long double rho = projection == SHD_PROJECTION_LAT_LONG ? std::hypot(n[0], n[2]) : std::hypot(n[0], n[1]);
  const bool disc = is_disc(projection);
  const long double room = projection == SHD_PROJECTION_LAT_LONG || (disc && n[2] < 0) ? rho : length;
  if (room < 1e-4L * length) return false;
  if (projection == SHD_PROJECTION_OCTAHEDRAL) {
    for (long double x : n) {
      if (std::fabs(x) < 1e-4L * length) return false;
    }
  }
  const uint32_t face = ref_face_of(n);
  for (int axis = 0; axis < 2; ++axis) {
    const auto& step = axis ? g_case.dy : g_case.dx;
    const long double change = std::sqrt(static_cast<long double>(step[0][i]) * step[0][i] +
                                         static_cast<long double>(step[1][i]) * step[1][i] +
                                         static_cast<long double>(step[2][i]) * step[2][i]);
    const long double h = 1e-6L * room / change;
    long double a[3], b[3];
    for (int c = 0; c < 3; ++c) a[c] = n[c] - h * step[c][i], b[c] = n[c] + h * step[c][i];
    const bool cube = projection == SHD_PROJECTION_CUBE;
    const ref_place before = cube ? ref_on_face(a, face) : ref_project(projection, a);
    const ref_place after = cube ? ref_on_face(b, face) : ref_project(projection, b);
    if (apart(SHD_PROJECTION_CUBE, before.u, after.u) > 0.1L) return false;  // across the seam
    const double du = static_cast<double>((after.u - before.u) / (2.0L * h));
    const double dv = static_cast<double>((after.v - before.v) / (2.0L * h));
    const double tolerance = 1.5e-6 * static_cast<double>(change / room);
    shd_assert_close("du", i, double{g_case.du[axis][i]}, du, tolerance, 0.0);
    shd_assert_close("dv", i, double{g_case.dv[axis][i]}, dv, tolerance, 0.0);
    if (rho == 0.0L) continue;
    const long double dn[3] = {step[0][i], step[1][i], step[2][i]};
    const ref_change exact = ref_step(projection, n, dn);
    shd_assert_close("exact du", i, static_cast<double>(exact.du), du, 1e-2 * tolerance, 0.0);
    shd_assert_close("exact dv", i, static_cast<double>(exact.dv), dv, 1e-2 * tolerance, 0.0);
  }
  return true;
}

void test_project(void**) {
  g_case.fill();
  for (shd_projection projection : kProjections) {
    on_every_target([&](const core::SimdTarget& simd) {
      assert_int_equal(0, projection::project(projection, simd, g_case.in(), g_case.out()));
      size_t steps = 0;
      for (size_t i = 0; i < kCount; i += SHD_ORACLE_STRIDE) {
        check_place(projection, i);
        steps += check_steps(projection, i);
      }
      assert_true(steps > kCount / (2 * SHD_ORACLE_STRIDE));
    });
  }
}

/// Changes of far more than 2^60 times the direction, even where their lengths overflow, have the derivatives of the
/// formulas, or 1e30 if these are beyond.
void test_long_steps(void**) {
  g_case.fill();
  for (size_t i = 0; i < kCount; ++i) {
    const float length = std::ldexp(1.0f, i % 2 ? 0 : -90);
    for (int c = 0; c < 3; ++c) {
      g_case.n[c][i] = random_float() * length;
      g_case.dx[c][i] = std::ldexp(random_float(), i % 4 < 2 ? (i % 2 ? 70 : -10) : 127);
    }
  }
  for (shd_projection projection : kProjections) {
    on_every_target([&](const core::SimdTarget& simd) {
      assert_int_equal(0, projection::project(projection, simd, g_case.in(), g_case.out()));
      size_t checked = 0;
      for (size_t i = 0; i < kCount; i += SHD_ORACLE_STRIDE) {
        const long double n[3] = {g_case.n[0][i], g_case.n[1][i], g_case.n[2][i]};
        const long double dn[3] = {g_case.dx[0][i], g_case.dx[1][i], g_case.dx[2][i]};
        const ref_change want = ref_step(projection, n, dn);
        const long double length = std::hypot(std::hypot(n[0], n[1]), n[2]);
        const long double change = std::hypot(std::hypot(dn[0], dn[1]), dn[2]) / length;
        if (std::hypot(want.du, want.dv) < 0.02L * change) continue;  // along the direction
        const auto is_close = [&](float got, long double exact) {
          if (std::fabs(exact) < 1e-5L * change) return true;  // cancelled
          const long double bounded = std::fmax(std::fmin(exact, 1e30L), -1e30L);
          return std::fabs(got - bounded) <= 1e-4L * std::fmax(std::fabs(bounded), std::fmin(change, 1e30L));
        };
        if (!is_close(g_case.du[0][i], want.du) || !is_close(g_case.dv[0][i], want.dv)) {
          fail_msg("projection %d [%zu]: (%g, %g) instead of (%g, %g)", projection, i, double{g_case.du[0][i]},
                   double{g_case.dv[0][i]}, static_cast<double>(want.du), static_cast<double>(want.dv));
        }
        ++checked;
      }
      assert_true(checked > kCount / (2 * SHD_ORACLE_STRIDE));
    });
  }
}

constexpr float kBig = 3e38f, kSmall = 1e-44f, kNan = NAN, kInf = INFINITY;

/// Every combination of these components, with derivatives of the same: finite results in range, counted if no
/// direction.
void test_special_directions(void**) {
  const float values[] = {0.0f, -0.0f, 1.0f, -1.0f, kBig, -kBig, kSmall, -kSmall, 1e-20f, kNan, kInf, -kInf};
  constexpr size_t kValues = sizeof values / sizeof *values;
  size_t count = 0, want = 0;
  for (size_t i = 0; i < kValues * kValues * kValues; ++i, ++count) {
    const float n[3] = {values[i % kValues], values[i / kValues % kValues], values[i / kValues / kValues]};
    bool valid = false, finite = true;
    for (int c = 0; c < 3; ++c) {
      g_case.n[c][i] = n[c];
      g_case.dx[c][i] = values[(i * 7 + static_cast<size_t>(c) * 5) % kValues];
      g_case.dy[c][i] = values[(i * 5 + static_cast<size_t>(c)) % kValues];
      valid = valid || n[c] != 0.0f;
      finite = finite && std::isfinite(n[c]);
    }
    want += !(valid && finite);
  }
  for (shd_projection projection : kProjections) {
    on_every_target([&](const core::SimdTarget& simd) {
      projection::Directions in = g_case.in();
      in.count = count;
      assert_int_equal(want, projection::project(projection, simd, in, g_case.out()));
      for (size_t i = 0; i < count; ++i) {
        const float n[3] = {g_case.n[0][i], g_case.n[1][i], g_case.n[2][i]};
        const bool finite = std::isfinite(n[0]) && std::isfinite(n[1]) && std::isfinite(n[2]);
        if (!finite || (n[0] == 0.0f && n[1] == 0.0f && n[2] == 0.0f)) {
          assert_int_equal(projection == SHD_PROJECTION_CUBE ? 4 : 0, g_case.face[i]);
          assert_true(g_case.u[i] == 0.5f && g_case.v[i] == 0.5f);
        } else {
          check_place(projection, i);
        }
        for (int axis = 0; axis < 2; ++axis) {
          assert_true(std::fabs(g_case.du[axis][i]) <= 1e30f && std::fabs(g_case.dv[axis][i]) <= 1e30f);
        }
      }
    });
  }
}

/// Hash of all results for the same inputs.
uint64_t hash_of_case(shd_projection projection, const core::SimdTarget& simd) {
  std::memset(g_case.u, 0, sizeof(Case) - offsetof(Case, u));
  projection::project(projection, simd, g_case.in(), g_case.out());
  return shd_hash(SHD_HASH_START, g_case.u, sizeof(Case) - offsetof(Case, u));
}

void test_same_bits(void**) {
  g_case.fill();
  g_case.n[1][5] = kNan, g_case.n[2][6] = kInf, g_case.dx[0][7] = kNan, g_case.dy[0][8] = -kInf;
  for (shd_projection projection : kProjections) {
    uint64_t first = 0;
    on_every_target([&](const core::SimdTarget& simd) {
      const uint64_t hash = hash_of_case(projection, simd);
      if (!first) first = hash;
      if (hash != first) fail_msg("projection %d: %s has other bits", projection, simd.name);
    });
  }
}

struct Unprojected {
  float u[kCount], v[kCount], n[3][kCount], solid_angle[kCount];
  uint32_t face[kCount];

  projection::ImagePoints in() const { return {kCount, u, v, face}; }
  projection::PointDirections out() { return {{n[0], n[1], n[2]}, solid_angle}; }
};
Unprojected g_points;

void test_unproject(void**) {
  for (size_t i = 0; i < kCount; ++i) {
    g_points.u[i] = i % 5 ? 0.5f + 0.5f * random_float() : static_cast<float>(i % 9) / 8.0f;
    g_points.v[i] = i % 7 ? 0.5f + 0.5f * random_float() : static_cast<float>(i % 17) / 16.0f;
    g_points.face[i] = static_cast<uint32_t>(i) % 8;
  }
  for (shd_projection projection : kProjections) {
    on_every_target([&](const core::SimdTarget& simd) {
      assert_int_equal(0, projection::unproject(projection, simd, g_points.in(), g_points.out()));
      for (size_t i = 0; i < kCount; i += SHD_ORACLE_STRIDE) {
        const uint32_t face = g_points.face[i] < 5 ? g_points.face[i] : 5;
        const long double u = g_points.u[i], v = g_points.v[i], r = std::hypot(2.0L * u - 1.0L, 2.0L * v - 1.0L);
        long double n[3];
        const int inside = ref_unproject(projection, u, v, face, n);
        const bool disc = is_disc(projection);
        if (disc && std::fabs(r - 1.0L) < 1e-3L) continue;  // the rim
        const double tolerance = disc && inside ? 1e-7 / std::sqrt(1.0 - static_cast<double>(r)) : 0.0;
        for (int c = 0; c < 3; ++c) {
          shd_assert_close("n", i, double{g_points.n[c][i]}, static_cast<double>(n[c]), 4e-7 + tolerance, 0.0);
        }
        if (!inside) assert_true(g_points.solid_angle[i] == 0.0f);
        const bool fold = projection == SHD_PROJECTION_OCTAHEDRAL &&
                          (std::fabs(u - 0.5L) < 1e-5L || std::fabs(v - 0.5L) < 1e-5L ||
                           std::fabs(std::fabs(u - 0.5L) + std::fabs(v - 0.5L) - 0.5L) < 1e-5L);
        if (!inside || fold || u < 1e-5L || v < 1e-5L || u > 1 - 1e-5L || v > 1 - 1e-5L) continue;
        const double want = static_cast<double>(ref_density(projection, u, v, face));
        shd_assert_close("solid_angle", i, double{g_points.solid_angle[i]}, want, 4e-5, 0.0);
      }
    });
  }
}

/// A point, its direction, and the point of the direction agree.
void test_round_trip(void**) {
  for (shd_projection projection : kProjections) {
    for (size_t i = 0; i < kCount; ++i) {
      g_points.u[i] = 0.5f + 0.499f * random_float(), g_points.v[i] = 0.5f + 0.499f * random_float();
      g_points.face[i] = static_cast<uint32_t>(i) % projection::face_count(projection);
    }
    const core::SimdTarget simd = core::baseline_target();
    projection::unproject(projection, simd, g_points.in(), g_points.out());
    projection::Directions in = {kCount, {g_points.n[0], g_points.n[1], g_points.n[2]}, {}};
    projection::project(projection, simd, in, {g_case.u, g_case.v, g_case.face, {}, {}});
    const bool disc = is_disc(projection);
    for (size_t i = 0; i < kCount; ++i) {
      // Directions near the pole or the rim do not determine the point as well.
      const double from_pole = std::sin(M_PI * double{g_points.v[i]});
      const double from_rim = 1.0 - 2.0 * std::hypot(double{g_points.u[i]} - 0.5, double{g_points.v[i]} - 0.5);
      const double loss = disc ? from_rim : projection == SHD_PROJECTION_LAT_LONG ? from_pole : 1.0;
      if (loss < 0.01) continue;
      assert_int_equal(g_points.face[i], g_case.face[i]);
      shd_assert_close("u", i, double{g_case.u[i]}, double{g_points.u[i]}, 5e-7 / loss, 0.0);
      shd_assert_close("v", i, double{g_case.v[i]}, double{g_points.v[i]}, 5e-7 / loss, 0.0);
    }
  }
}

/// Sum of the density over a fine grid of a texel.
double brute_solid_angle(shd_projection projection, uint32_t width, uint32_t height, uint32_t x, uint32_t y) {
  constexpr int kSide = 61;  // odd, so that no point lies on a fold at the centre of the image
  long double sum = 0.0L;
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      const long double u = (x + (i + 0.4L) / kSide) / width, v = (y + (j + 0.6L) / kSide) / height;
      long double n[3];
      if (ref_unproject(projection, u, v, 0, n)) sum += ref_density(projection, u, v, 0);
    }
  }
  return static_cast<double>(sum / (kSide * kSide * static_cast<long double>(width) * height));
}

void test_texel_solid_angles(void**) {
  const uint32_t sizes[][2] = {{1, 1}, {2, 2}, {3, 3}, {8, 8}, {31, 31}, {64, 32}, {5, 11}};
  for (shd_projection projection : kProjections) {
    for (const auto& size : sizes) {
      double sum = 0.0;
      for (uint32_t y = 0; y < size[1]; ++y) {
        for (uint32_t x = 0; x < size[0]; ++x) {
          const double got = projection::texel_solid_angle(projection, size[0], size[1], x, y);
          sum += got * projection::face_count(projection);
          if ((x + y * size[0]) % 37 == 3 && size[0] > 2) {
            const double even = 16.0 / (size[0] * size[1]);
            const double want = brute_solid_angle(projection, size[0], size[1], x, y);
            shd_assert_close("texel", x + y * size[0], got, want, 0.01 * even, 0.0);
          }
        }
      }
      const double tolerance = projection == SHD_PROJECTION_ANGULAR ? 1e-7 : 1e-12;
      shd_assert_close("sum", size[0], sum, 4.0 * M_PI, tolerance, 0.0);
    }
  }
}

/// Rows of texels against the exact solid angles; directions are those of the centres.
void test_texel_rows(void**) {
  constexpr uint32_t kLargest = 70;
  float n[3][kLargest], solid_angle[kLargest], centre[3][1], u[1], v[1];
  for (shd_projection projection : kProjections) {
    for (uint32_t size : {32u, 35u, kLargest}) {
      double sum = 0.0;
      const double largest = 60.0 / (size * size);
      for (uint32_t y = 0; y < size; ++y) {
        const uint32_t face = y % projection::face_count(projection);
        const core::SimdTarget simd = core::baseline_target();
        projection::find_texels(projection, simd, {size, size, face, y}, {{n[0], n[1], n[2]}, solid_angle});
        for (uint32_t x = 0; x < size; ++x) {
          const double want = projection::texel_solid_angle(projection, size, size, x, y);
          sum += double{solid_angle[x]};
          shd_assert_close("solid angle", y * size + x, double{solid_angle[x]}, want, 1e-5 * largest, 0.0);
          u[0] = (static_cast<float>(x) + 0.5f) / static_cast<float>(size);
          v[0] = (static_cast<float>(y) + 0.5f) / static_cast<float>(size);
          const bool outside = std::hypot(2.0 * double{u[0]} - 1.0, 2.0 * double{v[0]} - 1.0) > 1.0;
          if (is_disc(projection) && outside) {
            if (want > 0.0) assert_true(n[2][x] < -0.85f);
            continue;
          }
          projection::unproject(projection, simd, {1, u, v, &face}, {{centre[0], centre[1], centre[2]}, nullptr});
          for (int c = 0; c < 3; ++c) assert_true(n[c][x] == centre[c][0]);
        }
      }
      shd_assert_close("sum", size, sum * projection::face_count(projection), 4.0 * M_PI, 1e-4, 0.0);
    }
  }
}

/// Length of a line through a texel, as the sum of short chords. Points outside a disc are those where it continues.
double line_length(shd_projection projection, uint32_t width, uint32_t height, double x, double y, double dx,
                   double dy) {
  constexpr int kSteps = 200;
  double sum = 0.0, last[3] = {};
  for (int i = 0; i <= kSteps; ++i) {
    double u = (x + dx * i / kSteps) / width, v = (y + dy * i / kSteps) / height;
    const double r = std::hypot(2.0 * u - 1.0, 2.0 * v - 1.0);
    if (is_disc(projection) && r > 1.0) {
      u = 0.5 + (u - 0.5) * (r - 2.0) / r, v = 0.5 + (v - 0.5) * (r - 2.0) / r;
    }
    long double n[3];
    ref_unproject(projection, static_cast<long double>(u), static_cast<long double>(v), 0, n);
    double square = 0.0;
    for (int c = 0; c < 3; ++c) {
      const auto here = static_cast<double>(n[c]);
      square += (here - last[c]) * (here - last[c]);
      last[c] = here;
    }
    if (i > 0) sum += std::sqrt(square);
  }
  return sum;
}

/// No line along a side of a texel is longer than the extent, and one is not much shorter.
void test_texel_extents(void**) {
  const uint32_t sizes[][2] = {{1, 1}, {2, 2}, {3, 3}, {1, 64}, {64, 1}, {8, 8}, {37, 37}};
  for (shd_projection projection : kProjections) {
    for (const auto& size : sizes) {
      if (size[0] != size[1] && projection != SHD_PROJECTION_LAT_LONG) continue;
      for (uint32_t i = 0; i < size[0] * size[1]; i += i < 4 ? 1 : 7) {
        const uint32_t x = i % size[0], y = i / size[0];
        const auto extent = projection::texel_extent(projection, size[0], size[1], x, y);
        double across = 0.0, down = 0.0;
        for (double t : {0.001, 0.25, 0.5, 0.75, 0.999}) {
          across = std::fmax(across, line_length(projection, size[0], size[1], x, y + t, 1.0, 0.0));
          down = std::fmax(down, line_length(projection, size[0], size[1], x + t, y, 0.0, 1.0));
        }
        const bool covers = extent.along_u >= across - 1e-6 && extent.along_v >= down - 1e-6;
        const bool close = extent.along_u <= 1.7 * across && extent.along_v <= 1.7 * down;
        const bool rim = projection == SHD_PROJECTION_MIRROR_BALL &&
                         std::hypot(2.0 * x + 1.0 - size[0], 2.0 * y + 1.0 - size[1]) > 0.6 * size[0];
        if (!covers || (!close && size[1] >= 8 && !rim)) {
          fail_msg("projection %d, %u x %u, texel %u: (%g, %g), lines (%g, %g)", projection, size[0], size[1], i,
                   extent.along_u, extent.along_v, across, down);
        }
      }
    }
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      {"project", test_project, nullptr, nullptr, nullptr},
      {"long_steps", test_long_steps, nullptr, nullptr, nullptr},
      {"special_directions", test_special_directions, nullptr, nullptr, nullptr},
      {"same_bits", test_same_bits, nullptr, nullptr, nullptr},
      {"unproject", test_unproject, nullptr, nullptr, nullptr},
      {"round_trip", test_round_trip, nullptr, nullptr, nullptr},
      {"texel_solid_angles", test_texel_solid_angles, nullptr, nullptr, nullptr},
      {"texel_rows", test_texel_rows, nullptr, nullptr, nullptr},
      {"texel_extents", test_texel_extents, nullptr, nullptr, nullptr},
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
