// SPDX-License-Identifier: MIT
// Binning against a test of every triangle with every tile.
#include "support/check.h"

#include <algorithm>

#include "core/context.h"
#include "raster/bin.h"
#include "raster/sample_pattern.h"
#include "raster/tile.h"
#include "support/random.h"

namespace shd::tests {
namespace {

using geometry::PixelBox;
using geometry::ScreenTriangle;

core::Context* g_context;

struct Fixture {
  core::Buffer<ScreenTriangle> triangles;  // all groups, one after the other
  core::Objects<raster::TriangleGroup> groups;
  raster::Bins bins = {};

  explicit Fixture(size_t group_count) : triangles(g_context->allocator), groups(g_context->allocator, group_count) {
    for (size_t g = 0; g < group_count; ++g) groups[g].attach(g_context->allocator);
  }
};
Fixture* g;

int set_up(void**) {
  g_context = core::create_context(shd_context_desc_default());
  return 0;
}
int tear_down(void**) {
  core::release(*g_context);
  return 0;
}
int drop(void**) {
  delete g;
  g = nullptr;
  return 0;
}

/// Whether a centre of the tile lies within the triangle's bounding box, ends included.
bool touches(const ScreenTriangle& t, uint32_t tile_x, uint32_t tile_y, uint32_t width, uint32_t height) {
  const auto axis = [](const int32_t* v, uint32_t tile, uint32_t size) {
    const int64_t low = std::min({v[0], v[1], v[2]}), high = std::max({v[0], v[1], v[2]});
    for (int64_t p = int64_t{tile} * 64; p < std::min<int64_t>(int64_t{tile} * 64 + 64, size); ++p) {
      if (256 * p + 128 >= low && 256 * p + 128 <= high) return true;
    }
    return false;
  };
  return axis(t.x, tile_x, width) && axis(t.y, tile_y, height);
}

struct bin_case {
  const char* name;
  uint32_t width, height;
  int triangles;
  uint32_t groups;
  int32_t reach;  // largest offset of a vertex from its triangle's centre, in fixed point
};
const bin_case k_cases[] = {
    {"bin/no_groups", 640, 480, 0, 0, 0},           {"bin/empty_group", 640, 480, 0, 1, 0},
    {"bin/one_pixel_frame", 1, 1, 50, 1, 300},      {"bin/one_tile", 64, 64, 200, 3, 2000},
    {"bin/65_by_63", 65, 63, 200, 2, 5000},         {"bin/one_group", 640, 480, 700, 1, 20000},
    {"bin/2_groups", 640, 480, 700, 2, 20000},      {"bin/7_groups", 640, 480, 700, 7, 20000},
    {"bin/700_groups", 640, 480, 700, 700, 20000},  {"bin/guard_band", 1000, 300, 300, 5, 1 << 28},
    {"bin/row_of_65536", 65536, 1, 100, 3, 100000}, {"bin/column_of_65536", 1, 65536, 100, 3, 100000},
};

/// Every third triangle has its vertices on tile borders and centres.
void make_triangles(const bin_case& c) {
  Random random = {17};
  for (int i = 0; i < c.triangles; ++i) {
    ScreenTriangle t = {};
    const int32_t x = random.whole(0, c.width * 256 - 1), y = random.whole(0, c.height * 256 - 1);
    for (int k = 0; k < 3; ++k) {
      t.x[k] = std::clamp(x + random.whole(-c.reach, c.reach), -(1 << 28), 1 << 28);
      t.y[k] = std::clamp(y + random.whole(-c.reach, c.reach), -(1 << 28), 1 << 28);
      if (i % 3 == 0) {
        t.x[k] = (t.x[k] & ~0x3fff) + random.whole(-1, 1) * 128;
        t.y[k] = (t.y[k] & ~0x3fff) + random.whole(-1, 1) * 128;
      }
    }
    t.primitive = static_cast<uint32_t>(i);
    // As after assembly: triangles without a centre of the frame in their box are removed.
    const PixelBox box = geometry::intersection(geometry::pixel_box(t, raster::sample_pattern(1).extent),
                                                geometry::viewport_box(c.width, c.height));
    if (geometry::is_empty(box)) continue;
    g->triangles.push_back(t);
  }
  for (size_t i = 0; i < g->triangles.size(); ++i) {
    g->groups[i * c.groups / g->triangles.size()].push_back(g->triangles[i]);
  }
}

void test_bin(void** state) {
  const auto* c = static_cast<const bin_case*>(*state);
  g = new Fixture(c->groups);
  make_triangles(*c);
  const geometry::PixelBox frame = geometry::viewport_box(c->width, c->height);
  raster::bin_triangles(*g_context, g->groups.data(), c->groups, frame, frame, raster::sample_pattern(1).extent,
                        &g->bins);
  assert_int_equal(g->bins.tiles_x, (c->width + 63) / 64);
  assert_int_equal(g->bins.tiles_y, (c->height + 63) / 64);
  size_t entries = 0;
  for (uint32_t tile = 0; tile < g->bins.tiles_x * g->bins.tiles_y; ++tile) {
    // The tile's lists, one group after the other, must be the touching triangles in submission order.
    size_t next = 0;
    const auto skip_others = [&] {
      while (next < g->triangles.size() &&
             !touches(g->triangles[next], tile % g->bins.tiles_x, tile / g->bins.tiles_x, c->width, c->height)) {
        ++next;
      }
    };
    for (uint32_t group = 0; group < c->groups; ++group) {
      const raster::BinSegment segment = raster::segment(g->bins, tile, group);
      entries += segment.count;
      for (size_t i = 0; i < segment.count; ++i) {
        skip_others();
        const uint32_t got = g->groups[group][segment.entries[i]].primitive;
        if (next == g->triangles.size() || g->triangles[next].primitive != got) {
          fail_msg("tile %u group %u entry %zu: triangle %u", tile, group, i, got);
        }
        ++next;
      }
    }
    skip_others();
    if (next != g->triangles.size()) fail_msg("tile %u lacks triangle %u", tile, g->triangles[next].primitive);
  }
  assert_int_equal(entries, g->bins.entries.size());
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  CMUnitTest tests[16];
  size_t n = 0;
  for (const bin_case& c : k_cases) tests[n++] = {c.name, test_bin, nullptr, drop, const_cast<bin_case*>(&c)};
  return _cmocka_run_group_tests("unit.raster.bin", tests, n, set_up, tear_down);
}
