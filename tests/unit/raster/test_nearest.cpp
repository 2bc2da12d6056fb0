// SPDX-License-Identifier: MIT
// Conservative coverage of a tile against exact tests of every texel with every triangle.
#include "raster/nearest.h"

#include <memory>

#include "support/check.h"

#include "ref/bake_ref.h"
#include "support/random.h"

namespace shd::tests {
namespace {

using geometry::ScreenTriangle;

struct nearest_case {
  const char* name;
  int32_t left, top;  // position of the tile
  int32_t low, high;  // corners relative to the tile [1/256 pixel]
  int32_t size;       // largest extent of a triangle
  int32_t step;       // corners are multiples of it
  size_t count;
};

constexpr nearest_case k_cases[] = {
    {"large", 0, 0, -20000, 40000, 60000, 1, 7},
    {"small", 64, 128, 0, 16384, 700, 1, 130},
    {"tiny", 0, 64, 0, 16384, 90, 1, 300},
    {"slivers", 0, 0, 0, 16384, 16384, 1, 60},
    {"on_centres", 128, 0, 0, 16384, 4000, 128, 60},
    {"on_texels", 0, 0, 0, 16384, 4000, 256, 60},
    {"far", 16320, 16320, -1000, 20000, 9000, 1, 40},
    {"outside", 64, 64, -9000, -300, 8000, 1, 20},
};

/// A random triangle, turned clockwise; slivers have two corners close together.
bool make_triangle(const nearest_case& c, Random* random, ScreenTriangle* out) {
  const int32_t x = random->whole(c.low, c.high), y = random->whole(c.low, c.high);
  *out = {};
  for (int k = 0; k < 3; ++k) {
    const bool near = std::strcmp(c.name, "slivers") == 0 && k == 1;
    const int32_t size = near ? 40 : c.size;
    const int32_t dx = k ? random->whole(-size, size) : 0, dy = k ? random->whole(-size, size) : 0;
    out->x[k] = 256 * c.left + (x + dx) / c.step * c.step;
    out->y[k] = 256 * c.top + (y + dy) / c.step * c.step;
  }
  const int64_t area = (int64_t{out->x[1]} - out->x[0]) * (int64_t{out->y[2]} - out->y[0]) -
                       (int64_t{out->x[2]} - out->x[0]) * (int64_t{out->y[1]} - out->y[0]);
  if (area < 0) {
    std::swap(out->x[1], out->x[2]);
    std::swap(out->y[1], out->y[2]);
  }
  return area != 0;
}

void check_texel(const nearest_case& c, const std::vector<ScreenTriangle>& triangles, const geometry::PixelBox& box,
                 int32_t x, int32_t y, const raster::NearestTriangles& got) {
  size_t centre = 0, first = 0;
  double nearest = INFINITY;
  bool touched = false;
  const bool is_open = x >= box.min_x && x <= box.max_x && y >= box.min_y && y <= box.max_y;
  for (size_t i = 0; i < triangles.size() && is_open; ++i) {
    if (!ref::shares_area(triangles[i], x, y)) continue;
    if (ref::covers(triangles[i], x, y) && centre++ == 0) first = i;
    nearest = std::fmin(nearest, ref::nearest_point(triangles[i], x, y).distance);
    touched = true;
  }
  const size_t at = static_cast<size_t>(y - c.top) * 64 + static_cast<size_t>(x - c.left);
  const auto want = centre    ? raster::TexelCover::kCentre
                    : touched ? raster::TexelCover::kTouched
                              : raster::TexelCover::kEmpty;
  if (got.cover[at] != want) fail_msg("texel %d %d: %d, not %d", x, y, int(got.cover[at]), int(want));
  assert_int_equal(got.is_shared[at], centre > 1);
  if (!touched) return assert_int_equal(got.slot[at], raster::kNoSlot);
  if (centre) {
    assert_int_equal(got.slot[at], first);
    assert_true(got.x[at] == float(x) + 0.5f && got.y[at] == float(y) + 0.5f);
    return;
  }
  const ref::NearestPoint point = ref::nearest_point(triangles[got.slot[at]], x, y);
  shd_assert_close("distance", at, point.distance, nearest, 1e-9, 1e-9);
  // Two edges may be equally near: the point is on the winner, as far away as the nearest one.
  const double dx = 256 * double{got.x[at]} - (256.0 * x + 128), dy = 256 * double{got.y[at]} - (256.0 * y + 128);
  shd_assert_close("point", at, std::sqrt(dx * dx + dy * dy), nearest, 0.3, 0);
}

void test_nearest(void** state) {
  const auto& c = *static_cast<const nearest_case*>(*state);
  auto got = std::make_unique<raster::NearestTriangles>();
  std::vector<ScreenTriangle> triangles;
  Random random = {77};
  const geometry::PixelBox box = {c.left, c.top + 3, c.left + 60, c.top + 63};
  raster::clear(got.get());
  while (triangles.size() < c.count) {
    ScreenTriangle triangle;
    if (!make_triangle(c, &random, &triangle)) continue;
    raster::add_triangle(triangle, static_cast<uint32_t>(triangles.size()), c.left, c.top, box, got.get());
    triangles.push_back(triangle);
  }
  for (int32_t y = c.top; y < c.top + 64; ++y) {
    for (int32_t x = c.left; x < c.left + 64; ++x) {
      if ((x + y) % SHD_ORACLE_STRIDE == 0) check_texel(c, triangles, box, x, y, *got);
    }
  }
}

/// Texels at a shared edge belong to one of its triangles, with no overlap, and a chart on texel borders touches no
/// texel outside.
void test_quad(void**) {
  auto got = std::make_unique<raster::NearestTriangles>();
  const ScreenTriangle quad[2] = {{{512, 2560, 512}, {512, 512, 2560}, {0, 0, 0}, 0, 0, 0},
                                  {{2560, 2560, 512}, {512, 2560, 2560}, {0, 0, 0}, 0, 1, 0}};
  raster::clear(got.get());
  for (uint32_t i = 0; i < 2; ++i) raster::add_triangle(quad[i], i, 0, 0, {0, 0, 63, 63}, got.get());
  for (size_t at = 0; at < raster::kTilePixels; ++at) {
    const size_t x = at % 64, y = at / 64;
    const bool inside = x >= 2 && x < 10 && y >= 2 && y < 10;
    assert_int_equal(int(got->cover[at]), int(inside ? raster::TexelCover::kCentre : raster::TexelCover::kEmpty));
    assert_false(got->is_shared[at]);
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  CMUnitTest tests[16];
  size_t n = 0;
  for (const nearest_case& c : k_cases)
    tests[n++] = {c.name, test_nearest, nullptr, nullptr, const_cast<nearest_case*>(&c)};
  tests[n++] = {"quad", test_quad, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.raster.nearest", tests, n, nullptr, nullptr);
}
