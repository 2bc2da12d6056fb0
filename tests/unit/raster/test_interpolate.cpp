// SPDX-License-Identifier: MIT
// Interpolation against 113-bit arithmetic with running error bounds; its tails and bits.
#include "raster/texture_places.h"
#include "ref/raster_ref.h"
#include "unit/raster/interpolate_fixture.h"

namespace shd::tests {
namespace {

using ref::Bounded;
using ref::Real;

/// Vertices 3t, 3t + 1, 3t + 2 around raster position (x, y).
using Scene = void (*)(Random* random, float x, float y, float (*v)[4]);

void place(float* v, double x, double y, double w) {
  v[0] = static_cast<float>(x * w);
  v[1] = static_cast<float>(y * w);
  v[2] = static_cast<float>(0.5 * w);
  v[3] = static_cast<float>(w);
}

void triangle_around(Random* random, float x, float y, double reach, double w_low, double w_high, float (*v)[4]) {
  const double turn = random->in(0.0, 6.28);
  for (int k = 0; k < 3; ++k) {
    const double angle = turn + 2.0944 * k + random->in(-0.5, 0.5), r = reach * random->in(0.5, 1.5);
    place(v[k], double{x} + r * std::cos(angle), double{y} + r * std::sin(angle), std::exp2(random->in(w_low, w_high)));
  }
}

void ordinary(Random* random, float x, float y, float (*v)[4]) {
  triangle_around(random, x, y, random->in(1.0, 300.0), 0.0, 2.0, v);
}
void pixel_sized(Random* random, float x, float y, float (*v)[4]) {
  triangle_around(random, x, y, random->in(0.1, 1.0), 0.0, 0.1, v);
}
void same_w(Random* random, float x, float y, float (*v)[4]) {
  triangle_around(random, x, y, 50.0, 0.0, 0.0, v);
}
/// Triangles of one w, small and large.
void same_w_any_size(Random* random, float x, float y, float (*v)[4]) {
  const double w = std::ldexp(1.0, random->whole(-20, 20));
  triangle_around(random, x, y, std::exp2(random->in(-2.0, 11.0)), 0.0, 0.0, v);
  for (int k = 0; k < 3; ++k) {
    for (int c = 0; c < 4; ++c) v[k][c] = static_cast<float>(v[k][c] * w);
  }
}
/// Triangles of one w among others.
void some_of_same_w(Random* random, float x, float y, float (*v)[4]) {
  (random->whole(0, 1) ? same_w_any_size : ordinary)(random, x, y, v);
}
void w_ratio_2_40(Random* random, float x, float y, float (*v)[4]) {
  triangle_around(random, x, y, 50.0, -20.0, 20.0, v);
}
void tiny_w(Random* random, float x, float y, float (*v)[4]) {
  triangle_around(random, x, y, 50.0, -52.0, -50.0, v);
}
void large_w(Random* random, float x, float y, float (*v)[4]) {
  triangle_around(random, x, y, 50.0, 30.0, 32.0, v);
}
/// One or two vertices behind the eye, in general position: any three points with W of either sign.
void behind_the_eye(Random* random, float x, float y, float (*v)[4]) {
  triangle_around(random, x, y, 200.0, 0.0, 3.0, v);
  const int count = random->whole(1, 2);
  for (int k = 0; k < count; ++k) {
    for (int c = 0; c < 4; ++c) v[k][c] = 0.0f - v[k][c];
  }
}
void w_exactly_zero(Random* random, float x, float y, float (*v)[4]) {
  triangle_around(random, x, y, 200.0, 0.0, 3.0, v);
  v[0][3] = 0.0f;
}
/// A needle through the pixel, 0.02 pixel wide.
void sliver(Random* random, float x, float y, float (*v)[4]) {
  const double angle = random->in(0.0, 6.28), c = std::cos(angle), s = std::sin(angle);
  const double along[3] = {-random->in(20.0, 200.0), random->in(20.0, 200.0), random->in(20.0, 200.0)};
  for (int k = 0; k < 3; ++k) {
    const double across = k == 0 ? 0.0 : k == 1 ? 0.01 : -0.01;
    place(v[k], double{x} + along[k] * c - across * s, double{y} + along[k] * s + across * c,
          std::exp2(random->in(0.0, 1.0)));
  }
}

struct scene_case {
  const char* name;
  Scene scene;
  double error;  // largest |error| of a barycentric coordinate, from measurements; 0 = only the running bound
};
const scene_case k_scenes[] = {
    {"oracle/ordinary", ordinary, 2e-6},
    {"oracle/pixel_sized", pixel_sized, 1e-4},
    {"oracle/same_w", same_w, 5e-7},
    {"oracle/same_w_any_size", same_w_any_size, 4e-5},
    {"oracle/some_of_same_w", some_of_same_w, 4e-5},
    {"oracle/w_ratio_2^40", w_ratio_2_40, 2e-5},
    {"oracle/w_2^-52", tiny_w, 5e-7},
    {"oracle/w_2^32", large_w, 5e-7},
    {"oracle/behind_the_eye", behind_the_eye, 0.0},
    {"oracle/w_exactly_zero", w_exactly_zero, 0.0},
    {"oracle/sliver", sliver, 1e-3},
};

void set_attributes(Random* random, size_t vertex, double size) {
  double n[3], length = 0.0;
  for (double& c : n) {
    c = random->in(-1.0, 1.0);
    length += c * c;
  }
  float *world = row(g->vertices.world, vertex), *normal = row(g->vertices.normal, vertex);
  for (int c = 0; c < 3; ++c) {
    world[c] = random->real(-size, size);
    normal[c] = static_cast<float>(n[c] / std::sqrt(length));
  }
  world[3] = random->real(-size, size);
  normal[3] = random->real(-size, size);
}

/// A whole batch of `scene` in one tile, a new triangle every `run` rows.
void make_batch(Random* random, Scene scene, size_t run) {
  choose_tile(random);
  uint32_t pixel = 0;
  for (size_t i = 0; i < kBatch; ++i, ++pixel) {
    const auto t = static_cast<uint32_t>(i / run);
    if (i % run == 0) {
      pixel = static_cast<uint32_t>(random->whole(0, kTile * kTile - 1));
      float v[3][4];
      scene(random, centre_of(pixel).x, centre_of(pixel).y, v);
      for (size_t k = 0; k < 3; ++k) {
        memcpy(row(g->vertices.raster, 3 * t + k), v[k], sizeof v[k]);
        set_attributes(random, 3 * t + k, 10.0);
      }
    }
    set_fragment(i, t, pixel);
  }
  finish(kBatch);
}

/// A plane in units of the largest inverse of w in the tile, whose coefficients are computed in double and rounded.
struct BoundedPlane {
  Bounded at_middle, dx, dy;

  Bounded at(double x, double y) const { return (at_middle + dy * ref::exactly(y)) + dx * ref::exactly(x); }
};

/// A linear function of the position relative to the middle of the tile, with a bound of the errors in double.
struct Linear {
  Real at_middle, dx, dy;
  double error;

  Real at(Real x, Real y) const { return at_middle + dx * x + dy * y; }
};
Linear operator+(const Linear& a, const Linear& b) {
  return {a.at_middle + b.at_middle, a.dx + b.dx, a.dy + b.dy, a.error + b.error};
}
Linear operator*(Real scale, const Linear& a) {
  return {scale * a.at_middle, scale * a.dx, scale * a.dy, static_cast<double>(ref::magnitude(scale)) * a.error};
}
BoundedPlane rounded(const Linear& a) {
  return {ref::rounded(a.at_middle, a.error), ref::rounded(a.dx, a.error), ref::rounded(a.dy, a.error)};
}

/// The weights of the corners over the tile, and where their sum is 1.
struct TileWeights {
  Linear e[3], sum;
  Real reference_x, reference_y;
};
TileWeights tile_weights(const float (*v)[4]) {
  constexpr int32_t kHalf = raster::kTile / 2;
  const Real middle_x = g->fragments.left + kHalf, middle_y = g->fragments.top + kHalf, half = kHalf;
  Real x[3], y[3], determinant = 0;
  double size[3];
  for (int k = 0; k < 3; ++k) {
    const double w = double{v[k][3]};
    x[k] = v[k][0] - middle_x * w;
    y[k] = v[k][1] - middle_y * w;
    size[k] = std::fabs(double{v[k][0]}) + std::fabs(double{v[k][1]}) + 2049.0 * std::fabs(w);
  }
  TileWeights result;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const Real wi = v[i][3], wj = v[j][3];
    result.e[k] = {x[i] * y[j] - x[j] * y[i], wj * y[i] - wi * y[j], wi * x[j] - wj * x[i],
                   size[i] * size[j] * 0x1p-50};
    determinant += v[k][3] * result.e[k].at_middle;
  }
  for (Linear& e : result.e) e = Real{determinant < 0 ? -1.0 : 1.0} * e;
  result.sum = result.e[0] + result.e[1] + result.e[2];
  result.reference_x = result.sum.dx < 0 ? -half : half;
  result.reference_y = result.sum.dy < 0 ? -half : half;
  if (8 * result.sum.at_middle >= result.sum.at(result.reference_x, result.reference_y)) {
    result.reference_x = result.reference_y = 0;
  }
  const Real scale = 1 / result.sum.at(result.reference_x, result.reference_y);
  for (Linear& e : result.e) e = scale * e;
  result.sum = scale * result.sum;
  return result;
}

void check_within(const char* what, size_t i, double got, double want, double bound) {
  if (std::isfinite(bound)) {
    shd_assert_close(what, i, got, want, bound, 0.0);
  } else if (!std::isfinite(got)) {
    fail_msg("%s[%zu]: %g is not finite", what, i, got);
  }
}

double g_worst;          // largest error of a barycentric coordinate
size_t g_rows, g_ahead;  // rows, and those in front of the eye

/// A row of the batch with its corners, and the oracle's values.
struct OracleRow {
  size_t i;
  double x, y;  // relative to the middle of the tile
  const float *world[3], *normal[3];
  float v[3][4];
  ref::Weights want;
  TileWeights tile;
  Bounded factor;
};
OracleRow oracle_row(size_t i) {
  const raster::Fragments& f = g->fragments;
  OracleRow r;
  r.i = i;
  r.x = double{f.x[i]} - (f.left + raster::kTile / 2);
  r.y = double{f.y[i]} - (f.top + raster::kTile / 2);
  for (size_t k = 0; k < 3; ++k) {
    const uint32_t vertex = vertex_of(f.triangle[i], k);
    memcpy(r.v[k], row(g->vertices.raster, vertex), sizeof r.v[k]);
    r.world[k] = row(g->vertices.world, vertex);
    r.normal[k] = row(g->vertices.normal, vertex);
  }
  const bool any_zero = r.v[0][3] == 0.0f || r.v[1][3] == 0.0f || r.v[2][3] == 0.0f;
  r.want = any_zero ? ref::homogeneous_weights(r.v, f.x[i], f.y[i]) : ref::perspective_weights(r.v, f.x[i], f.y[i]);
  r.tile = tile_weights(r.v);
  r.factor = ref::inverse(rounded(r.tile.sum).at(r.x, r.y));
  return r;
}

/// Compares a texture coordinate, which is component 3 of the rows `values`, and its derivatives.
void check_coordinate(const OracleRow& r, const float* const* values, const char* what, const float* got,
                      const float* got_dx, const float* got_dy) {
  const float a[3] = {values[0][3], values[1][3], values[2][3]};
  const auto range = std::minmax({a[0], a[1], a[2]});
  Real near = 0, raw = 0, raw_dx = 0, raw_dy = 0, w = 0, w_dx = 0, w_dy = 0;
  for (int k = 0; k < 3; ++k) {
    near += a[k] * r.tile.e[k].at(r.tile.reference_x, r.tile.reference_y);
    raw += r.want.b[k] * a[k], raw_dx += r.want.dx[k] * a[k], raw_dy += r.want.dy[k] * a[k];
    w += r.want.b[k] * r.v[k][3], w_dx += r.want.dx[k] * r.v[k][3], w_dy += r.want.dy[k] * r.v[k][3];
  }
  const Real low = range.first, high = range.second;
  const double base = static_cast<double>(static_cast<float>(static_cast<double>(std::min(std::max(near, low), high))));
  const Real clamped = std::min(std::max(raw, low), high);
  Linear offset = {0, 0, 0, 0.0};
  for (int k = 0; k < 3; ++k) offset = offset + (Real{a[k]} - base) * r.tile.e[k];
  const BoundedPlane plane = rounded(offset), sum = rounded(r.tile.sum);
  const double rest = static_cast<double>(clamped) - base;
  const Bounded part = {Real{rest}, (plane.at(r.x, r.y) * r.factor).error + std::fabs(rest) * 0x1p-23};
  check_within(what, r.i, double{got[r.i]}, static_cast<double>(clamped), (ref::exactly(base) + part).error);
  // The derivatives are those of the quotient at the clamped coordinate.
  const Real beyond = raw - clamped;
  const auto step = [&](Bounded a_step, Bounded sum_step) { return (a_step - part * sum_step) * r.factor; };
  check_within(what, r.i, double{got_dx[r.i]}, static_cast<double>(raw_dx - beyond * w_dx / w),
               step(plane.dx, sum.dx).error + 0x1p-140);
  check_within(what, r.i, double{got_dy[r.i]}, static_cast<double>(raw_dy - beyond * w_dy / w),
               step(plane.dy, sum.dy).error + 0x1p-140);
}

/// Compares row i with the oracle, if it is in front of the eye.
void check_row(size_t i) {
  const raster::Fragments& f = g->fragments;
  const OracleRow r = oracle_row(i);
  ++g_rows;
  if (!(ref::interpolated_w(r.v, r.want) > 0)) return;
  ++g_ahead;
  double b[3], error[3];
  b[1] = std::min(std::max(static_cast<double>(r.want.b[1]), 0.0), 1.0);
  b[2] = std::min(std::max(static_cast<double>(r.want.b[2]), 0.0), 1.0 - b[1]);
  b[0] = 1.0 - b[1] - b[2];
  for (int k = 1; k < 3; ++k) error[k] = (rounded(r.tile.e[k]).at(r.x, r.y) * r.factor).error;
  error[0] = error[2] = error[1] + error[2] + 0x1p-23;
  for (int k = 0; k < 3; ++k) {
    check_within("bary", i, double{f.bary[k][i]}, b[k], error[k]);
    g_worst = std::max(g_worst, std::fabs(double{f.bary[k][i]} - b[k]));
  }
  const auto position = [&](int c, const float* got, const char* what) {
    const double a0 = double{r.world[0][c]}, a1 = double{r.world[1][c]} - a0, a2 = double{r.world[2][c]} - a0;
    const double size = std::fabs(a0) + std::fabs(a1) + std::fabs(a2);
    check_within(what, i, double{got[i]}, a0 + b[1] * a1 + b[2] * a2,
                 error[2] * (std::fabs(a1) + std::fabs(a2)) + size * 0x1p-22);
  };
  position(0, f.px, "px");
  position(1, f.py, "py");
  position(2, f.pz, "pz");
  check_coordinate(r, r.world, "u", f.u, f.dudx, f.dudy);
  check_coordinate(r, r.normal, "v", f.v, f.dvdx, f.dvdy);
}

/// Fails unless three columns are unit vectors, or zero if allowed.
void check_unit(const char* what, const float* x, const float* y, const float* z, bool may_be_zero) {
  for (size_t i = 0; i < g->fragments.count; ++i) {
    const double length = std::sqrt(double{x[i]} * x[i] + double{y[i]} * y[i] + double{z[i]} * z[i]);
    if (may_be_zero && length == 0.0) continue;
    shd_assert_close(what, i, length, 1.0, 4e-7, 0.0);
  }
}

void test_oracle(void** state) {
  const auto* c = static_cast<const scene_case*>(*state);
  Random random = {static_cast<uint64_t>(c - k_scenes) + 1};
  g_worst = 0.0;
  g_rows = g_ahead = 0;
  for (int batch = 0; batch < 12; ++batch) {
    make_batch(&random, c->scene, batch % 2 ? 5 : 37);
    for_each_target([&](const core::SimdTarget& target, bool first) {
      raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
      if (!first) return compare_rows(target.name);
      keep_rows();
      for (size_t i = 0; i < kBatch; ++i) check_row(i);
      check_unit("n", g->fragments.nx, g->fragments.ny, g->fragments.nz, false);
      check_unit("wo", g->fragments.ox, g->fragments.oy, g->fragments.oz, false);
    });
  }
  if (c->error > 0.0 && g_worst > c->error) fail_msg("largest error of a barycentric coordinate %g", g_worst);
  if (4 * g_ahead < g_rows) fail_msg("only %zu of %zu rows are in front of the eye", g_ahead, g_rows);
  print_message("  largest error of a barycentric coordinate: %.3g\n", g_worst);
}

/// Rows of one triangle have the same bits in spans of any length, and with rows of another triangle between them.
void test_spans(void**) {
  Random random = {31};
  for (int batch = 0; batch < 10; ++batch) {
    make_batch(&random, batch % 3 == 0 ? same_w : batch % 3 == 1 ? ordinary : behind_the_eye, kBatch);
    for (size_t i = 3; i < kVertices; ++i) g->indices[i] = g->indices[i % 3];
    for_each_target([&](const core::SimdTarget& target, bool) {
      for (size_t i = 0; i < kBatch; ++i) g->fragments.triangle[i] = 0;
      raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
      keep_rows();
      for (size_t length : {1, 2, 3, 7, 17, 64}) {
        for (size_t i = 0; i < kBatch; ++i) g->fragments.triangle[i] = static_cast<uint32_t>(i / length);
        raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
        compare_rows(target.name);
      }
      for (uint32_t period = 2; period <= 17; ++period) {
        for (uint32_t i = 0; i < kBatch; ++i) g->fragments.triangle[i] = i % period == period / 2;
        raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
        compare_rows(target.name);
      }
    });
    for (uint32_t i = 0; i < kVertices; ++i) g->indices[i] = i;
  }
}

/// The columns of most lit materials have the same bits if others are wanted, in long and in short spans.
void test_lit(void**) {
  Random random = {67};
  for (int batch = 0; batch < 60; ++batch) {
    const size_t lengths[] = {1, 5, 11, 12, 23, 24, 37, 47, 48, 100, kBatch};
    make_batch(&random, batch % 3 == 0 ? same_w : batch % 3 == 1 ? ordinary : behind_the_eye, lengths[batch % 11]);
    if (batch % 7 == 0) g->fragments.left += 17, g->fragments.top += 40;
    if (batch % 5 == 0) finish(static_cast<size_t>(random.whole(1, kBatch)));
    for_each_target([&](const core::SimdTarget& target, bool) {
      raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
      keep_rows();
      compare_lit(target);
    });
  }
}

/// Texture coordinates of runs of pixels of one triangle have the bits of interpolate().
void test_runs(void**) {
  Random random = {59};
  for (int batch = 0; batch < 60; ++batch) {
    make_batch(&random, batch % 3 == 0 ? same_w : batch % 3 == 1 ? ordinary : behind_the_eye, kBatch);
    raster::PixelRun runs[16];
    size_t count = 0, rows = 0;
    for (uint32_t next = 0; count < 16; ++count) {
      const auto begin = next + static_cast<uint32_t>(random.whole(0, 200)), end = begin + random.whole(1, 150);
      if (rows + (end - begin) > kBatch || end > kTile * kTile) break;
      runs[count] = {static_cast<uint16_t>(begin), static_cast<uint16_t>(end), 1};
      for (uint32_t pixel = begin; pixel < end; ++pixel) set_fragment(rows++, 0, pixel);
      next = end;
    }
    finish(rows);
    raster::TrianglePixels pixels = {{}, g->fragments.left, g->fragments.top, runs, count};
    raster::find_planes(g->vertices, {0, 1, 2}, {pixels.left, pixels.top}, raster::kTexture, &pixels.planes);
    for_each_target([&](const core::SimdTarget& target, bool) {
      raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
      keep_rows();
      raster::interpolate_texture(target, pixels, &g->fragments);
      compare_rows(target.name);
    });
  }
}

/// A row has the same bits in a batch of any size, and rows past the last vector do not change.
void test_counts(void**) {
  Random random = {37};
  make_batch(&random, some_of_same_w, 7);
  raster::interpolate(best_target(), g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
  keep_rows();
  uint32_t pixel[kBatch];
  memcpy(pixel, g->first.pixel, sizeof pixel);
  for_each_target([&](const core::SimdTarget& target, bool) {
    for (size_t count = 1; count <= kBatch; ++count) {
      raster::Fragments& f = g->fragments;
      for (size_t i = 0; i < count; ++i) set_fragment(i, static_cast<uint32_t>(i / 7), pixel[i]);
      finish(count);
      const ColumnList columns = columns_of(f);
      for (float* column : columns.column) std::fill_n(column, raster::kColumn, -77.0f);
      raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &f);
      compare_rows(target.name);
      for (float* column : columns.column) {
        for (size_t i = data::padded(count) + 16; i < raster::kColumn; ++i) {
          if (column[i] != -77.0f) fail_msg("%s: count %zu row %zu written", target.name, count, i);
        }
      }
    }
  });
}

/// A pixel has the same bits in tiles that begin anywhere: in a tile over four cells, and in the tile of its cell.
void test_windows(void**) {
  Random random = {61};
  raster::Fragments& f = g->fragments;
  for (int batch = 0; batch < 40; ++batch) {
    make_batch(&random, batch % 2 ? ordinary : some_of_same_w, 37);
    f.left += random.whole(0, 63), f.top += random.whole(0, 63);
    for (size_t i = 0; i < kBatch; ++i) set_fragment(i, f.triangle[i], f.pixel[i]);
    const int32_t left = f.left, top = f.top;
    uint32_t triangle[kBatch], pixel[kBatch];
    memcpy(triangle, f.triangle, sizeof triangle);
    memcpy(pixel, f.pixel, sizeof pixel);
    for_each_target([&](const core::SimdTarget& target, bool) {
      f.left = left, f.top = top;
      for (size_t i = 0; i < kBatch; ++i) set_fragment(i, triangle[i], pixel[i]);
      finish(kBatch);
      raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &f);
      keep_rows();
      const ColumnList whole = columns_of(g->first), columns = columns_of(f);
      for (size_t i = 0; i < kBatch; ++i) {
        const raster::Cell cell = raster::cell_of(left, top, pixel[i]);
        const auto x = static_cast<int32_t>(pixel[i] % kTile) + left - cell.left;
        const auto y = static_cast<int32_t>(pixel[i] / kTile) + top - cell.top;
        f.left = cell.left, f.top = cell.top;
        set_fragment(0, triangle[i], static_cast<uint32_t>(y * raster::kTile + x));
        finish(1);
        raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &f);
        for (size_t c = 0; c < kColumns; ++c) {
          if (memcmp(columns.column[c], whole.column[c] + i, sizeof(float)) != 0)
            fail_msg("%s: row %zu has other bits in column %zu", target.name, i, c);
        }
      }
    });
  }
}

/// A constant attribute keeps its bits, wherever the triangle is.
void test_constant(void**) {
  Random random = {43};
  for (const Scene scene : {behind_the_eye, some_of_same_w}) {
    make_batch(&random, scene, 5);
    for (size_t v = 0; v < kVertices; ++v) row(g->vertices.world, v)[3] = 0.1f;
    for_each_target([&](const core::SimdTarget& target, bool) {
      raster::interpolate(target, g->vertices, kEye, raster::kInterpolateAll, &g->fragments);
      for (size_t i = 0; i < kBatch; ++i) {
        if (g->fragments.u[i] != 0.1f || g->fragments.dudx[i] != 0.0f)
          fail_msg("%s: row %zu u %a", target.name, i, double{g->fragments.u[i]});
      }
    });
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  CMUnitTest tests[48];
  size_t n = 0;
  for (const scene_case& c : k_scenes)
    tests[n++] = {c.name, test_oracle, nullptr, nullptr, const_cast<scene_case*>(&c)};
  tests[n++] = {"bits/spans", test_spans, nullptr, nullptr, nullptr};
  tests[n++] = {"bits/lit", test_lit, nullptr, nullptr, nullptr};
  tests[n++] = {"bits/windows", test_windows, nullptr, nullptr, nullptr};
  tests[n++] = {"bits/runs", test_runs, nullptr, nullptr, nullptr};
  tests[n++] = {"bits/counts_1..kBatch", test_counts, nullptr, nullptr, nullptr};
  tests[n++] = {"constant", test_constant, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.raster.interpolate", tests, n, set_up, tear_down);
}
