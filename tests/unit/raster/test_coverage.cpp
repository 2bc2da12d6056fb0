// SPDX-License-Identifier: MIT
// Coverage against exact arithmetic: single triangles of every shape and position, fans and meshes that must cover each
// sample once, and depth.
#include "support/check.h"

#include <algorithm>

#include "raster/coverage.h"
#include "raster/fragments.h"
#include "raster/tile_words.h"
#include "ref/raster_ref.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {
namespace {

using geometry::ScreenTriangle;
using raster::kNoSlot;
using raster::kTile;
using raster::kTilePixels;
using raster::Tile;

const core::Allocator g_allocator = {core::default_allocator()};
Tile g_tile, g_first;
uint32_t g_hits[kTilePixels];
constexpr int32_t kFarthest = 1 << 28;  // guard band in fixed point

void clear(Tile* tile) {
  for (size_t i = 0; i < tile->samples * kTilePixels; ++i) {
    tile->depth[i] = 1.0f;
    tile->slot[i] = kNoSlot;
  }
  raster::forget_bounds(tile);
}
void copy(const Tile& from, Tile* to) {
  memcpy(to->depth.data(), from.depth.data(), from.samples * kTilePixels * sizeof(float));
  memcpy(to->slot.data(), from.slot.data(), from.samples * kTilePixels * sizeof(uint32_t));
}
bool are_same(const Tile& a, const Tile& b) {
  return memcmp(a.depth.data(), b.depth.data(), a.samples * kTilePixels * sizeof(float)) == 0 &&
         memcmp(a.slot.data(), b.slot.data(), a.samples * kTilePixels * sizeof(uint32_t)) == 0;
}

/// A whole tile.
raster::CoverArea area_at(int32_t left, int32_t top, uint32_t samples = 1) {
  return {raster::sample_pattern(samples), left, top, {left, top, left + kTile - 1, top + kTile - 1}};
}
void set_samples(uint32_t samples) {
  raster::allocate(g_allocator, samples, &g_tile);
  raster::allocate(g_allocator, samples, &g_first);
}
constexpr raster::DepthState kLess = {SHD_COMPARE_LESS, true, 0.0f, 0.0f};

/// Turns the triangle as assembly does. Returns false if it has no area.
bool turn(ScreenTriangle* t) {
  const int64_t area = (int64_t{t->x[1]} - t->x[0]) * (int64_t{t->y[2]} - t->y[0]) -
                       (int64_t{t->x[2]} - t->x[0]) * (int64_t{t->y[1]} - t->y[0]);
  if (area < 0) {
    std::swap(t->x[1], t->x[2]);
    std::swap(t->y[1], t->y[2]);
    std::swap(t->z[1], t->z[2]);
  }
  return area != 0;
}

void cover_one(const core::SimdTarget& target, const ScreenTriangle& t, int32_t left, int32_t top, Tile* tile) {
  const uint32_t entry = 0;
  raster::cover(target, area_at(left, top, tile->samples), kLess, &t, &entry, 1, 0, tile);
}

/// Three vertices around a tile whose corner is at (left, top), in fixed point.
using Shape = void (*)(Random* random, int32_t left, int32_t top, ScreenTriangle* t);

void place(ScreenTriangle* t, int k, int64_t x, int64_t y) {
  t->x[k] = static_cast<int32_t>(std::clamp<int64_t>(x, -kFarthest, kFarthest));
  t->y[k] = static_cast<int32_t>(std::clamp<int64_t>(y, -kFarthest, kFarthest));
}

/// Vertices within `reach` pixels of a point of the tile, on multiples of `grid` plus `offset`.
void around(Random* random, int32_t left, int32_t top, int64_t reach, int32_t grid, int32_t offset, ScreenTriangle* t) {
  const int64_t cx = 256 * (left + random->whole(0, kTile - 1)), cy = 256 * (top + random->whole(0, kTile - 1));
  for (int k = 0; k < 3; ++k) {
    const int64_t x = cx + random->whole(-256 * reach, 256 * reach), y = cy + random->whole(-256 * reach, 256 * reach);
    place(t, k, (x / grid) * grid + offset, (y / grid) * grid + offset);
  }
}

void tiny(Random* random, int32_t left, int32_t top, ScreenTriangle* t) {
  around(random, left, top, 1, 1, 0, t);
}
void small(Random* random, int32_t left, int32_t top, ScreenTriangle* t) {
  around(random, left, top, 8, 1, 0, t);
}
void tile_crossing(Random* random, int32_t left, int32_t top, ScreenTriangle* t) {
  around(random, left, top, 200, 1, 0, t);
}
void vertices_on_centres(Random* random, int32_t left, int32_t top, ScreenTriangle* t) {
  around(random, left, top, 40, 256, 128, t);
}
void edges_through_centres(Random* random, int32_t left, int32_t top, ScreenTriangle* t) {
  around(random, left, top, 400, 128, 0, t);
}
void axis_aligned(Random* random, int32_t left, int32_t top, ScreenTriangle* t) {
  around(random, left, top, 20, 64, 0, t);
  t->x[1] = t->x[0];
  t->y[2] = t->y[random->bits() & 1];
}
void sliver(Random* random, int32_t left, int32_t top, ScreenTriangle* t) {
  around(random, left, top, 90, 1, 0, t);
  place(t, 2, (int64_t{t->x[0]} + t->x[1]) / 2 + random->whole(-3, 3),
        (int64_t{t->y[0]} + t->y[1]) / 2 + random->whole(-3, 3));
}
void huge(Random* random, int32_t, int32_t, ScreenTriangle* t) {
  for (int k = 0; k < 3; ++k) {
    place(t, k, random->whole(-kFarthest, kFarthest), random->whole(-kFarthest, kFarthest));
  }
}
/// One edge exactly through a pixel centre of the tile, from one end of the guard band to the other.
void huge_edge_on_centre(Random* random, int32_t left, int32_t top, ScreenTriangle* t) {
  const int64_t cx = 256 * (left + random->whole(0, kTile - 1)) + 128;
  const int64_t cy = 256 * (top + random->whole(0, kTile - 1)) + 128;
  const int64_t far_x = random->whole(1, kFarthest / 2), far_y = random->whole(-kFarthest / 2, kFarthest / 2);
  place(t, 0, cx - far_x, cy - far_y);
  place(t, 1, cx + far_x, cy + far_y);
  place(t, 2, random->whole(-kFarthest, kFarthest), random->whole(-kFarthest, kFarthest));
}
void huge_sliver(Random* random, int32_t left, int32_t top, ScreenTriangle* t) {
  huge_edge_on_centre(random, left, top, t);
  place(t, 2, int64_t{t->x[1]} + random->whole(-200, 200), int64_t{t->y[1]} + random->whole(-200, 200));
}
/// Edge steps just below, at and above the limit of int32 arithmetic.
void step_limit(Random* random, int32_t left, int32_t top, ScreenTriangle* t) {
  around(random, left, top, 32, 1, 0, t);
  const int64_t step = (int64_t{1} << 23) + random->whole(-1, 1);
  place(t, 1, t->x[0] + (random->bits() & 1 ? step : -step), int64_t{t->y[0]} + random->whole(-30000, 30000));
  if (random->bits() & 1) {
    std::swap(t->x[0], t->y[0]);
    std::swap(t->x[1], t->y[1]);
  }
}

struct shape_case {
  const char* name;
  Shape shape;
  int count;
};
const shape_case k_shapes[] = {
    {"coverage/tiny", tiny, 2000},
    {"coverage/small", small, 1000},
    {"coverage/tile_crossing", tile_crossing, 1000},
    {"coverage/vertices_on_centres", vertices_on_centres, 1000},
    {"coverage/edges_through_centres", edges_through_centres, 1000},
    {"coverage/axis_aligned", axis_aligned, 1000},
    {"coverage/sliver", sliver, 2000},
    {"coverage/guard_band", huge, 1000},
    {"coverage/guard_band_edge_on_centre", huge_edge_on_centre, 1000},
    {"coverage/guard_band_sliver", huge_sliver, 1000},
    {"coverage/edge_step_2^23", step_limit, 1000},
};

constexpr int32_t kCorners[][2] = {{0, 0}, {64, 0}, {0, 64}, {1984, 1024}, {32768, 65472}, {65472, 65472}};

void check_triangle(const char* target, const ScreenTriangle& t, int32_t left, int32_t top) {
  const raster::SamplePattern& pattern = raster::sample_pattern(g_tile.samples);
  for (size_t i = 0; i < pattern.count * kTilePixels; ++i) {
    const raster::SamplePoint sample = pattern.point[i % pattern.count];
    const auto pixel = static_cast<int32_t>(i / pattern.count);
    const int32_t x = left + pixel % kTile, y = top + pixel / kTile;
    const bool want = ref::covers(t, x, y, sample.x, sample.y);
    const ref::Depth depth = want ? ref::depth_at(t, x, y, sample.x, sample.y) : ref::Depth{1.0, 0.0};
    if (want != (g_tile.slot[i] == 0) || (!want && g_tile.slot[i] != kNoSlot) ||
        !shd_is_close(g_tile.depth[i], depth.value, 3 * 0x1p-24 * depth.scale, 0.0)) {
      fail_msg("%s: (%d %d %g) (%d %d %g) (%d %d %g) pixel %d %d: slot %u depth %.9g, want %d %.9g", target, t.x[0],
               t.y[0], t.z[0], t.x[1], t.y[1], t.z[1], t.x[2], t.y[2], t.z[2], x, y, g_tile.slot[i], g_tile.depth[i],
               want, depth.value);
    }
  }
}

void check_shape(const shape_case& c, uint32_t samples) {
  Random random = {static_cast<uint64_t>(&c - k_shapes) + 100};
  set_samples(samples);
  for (int i = 0; i < c.count / static_cast<int>(samples); ++i) {
    const int32_t* corner = kCorners[i % 6];
    ScreenTriangle t = {};
    c.shape(&random, corner[0], corner[1], &t);
    for (float& z : t.z) z = random.real(0.0, 0.99);
    if (!turn(&t)) continue;
    for_each_target([&](const core::SimdTarget& target, bool first) {
      clear(&g_tile);
      cover_one(target, t, corner[0], corner[1], &g_tile);
      if (first) {
        if (i % SHD_ORACLE_STRIDE == 0) check_triangle(target.name, t, corner[0], corner[1]);
        copy(g_tile, &g_first);
      }
      if (!are_same(g_tile, g_first)) fail_msg("%s differs, triangle %d", target.name, i);
    });
  }
}

void test_shape(void** state) {
  for (const uint32_t samples : {16u, 8u, 4u, 2u, 1u}) check_shape(*static_cast<const shape_case*>(*state), samples);
}

/// Counts the pixels of a triangle in rows [begin, end), then restores the tile.
void count_hits(const core::SimdTarget& target, const ScreenTriangle& t, int32_t begin, int32_t end) {
  cover_one(target, t, 0, 0, &g_tile);
  for (int32_t i = begin * kTile; i < end * kTile; ++i) {
    g_hits[i] += g_tile.slot[i] != kNoSlot;
    g_tile.slot[i] = kNoSlot;
    g_tile.depth[i] = 1.0f;
  }
  raster::forget_bounds(&g_tile);
}

/// The point at a distance along the outline of a box.
void outline_point(const int32_t box[4], int64_t distance, int32_t* x, int32_t* y) {
  const int64_t width = box[2] - box[0], height = box[3] - box[1];
  distance %= 2 * (width + height);
  const int64_t from_right = distance - width, from_bottom = from_right - height, from_left = from_bottom - width;
  *x = static_cast<int32_t>(from_right < 0    ? box[0] + distance
                            : from_bottom < 0 ? box[2]
                            : from_left < 0   ? box[2] - from_bottom
                                              : box[0]);
  *y = static_cast<int32_t>(from_right < 0    ? box[1]
                            : from_bottom < 0 ? box[1] + from_right
                            : from_left < 0   ? box[3]
                                              : box[3] - from_left);
}

constexpr int kMaxSpokes = 64;

/// Makes spokes from a point to the outline of a box, including its corners, in order. Returns their number.
int make_spokes(Random* random, const int32_t box[4], int32_t (*spoke)[2]) {
  const int64_t width = box[2] - box[0], height = box[3] - box[1], length = 2 * (width + height);
  int64_t at[kMaxSpokes] = {0, width, width + height, 2 * width + height};
  const int count = random->whole(4, kMaxSpokes);
  for (int i = 4; i < count; ++i) {
    // Every other spoke is 1/256 to 3/256 pixel away from another.
    at[i] = i % 2 ? random->whole(0, length - 1) : (at[i - 1] + random->whole(1, 3)) % length;
  }
  std::sort(at, at + count);
  const int unique = static_cast<int>(std::unique(at, at + count) - at);
  for (int i = 0; i < unique; ++i) outline_point(box, at[i], &spoke[i][0], &spoke[i][1]);
  return unique;
}

/// Fans that fill a box: each centre inside is covered once, each centre outside never. Returns the triangles used.
int run_fan(const core::SimdTarget& target, Random* random) {
  int32_t box[4];
  const int32_t reach = random->bits() % 8 == 0 ? 1000 * 256 : 64 * 256;
  const bool on_centres = random->bits() % 4 == 0;
  const auto coordinate = [&](int32_t low, int32_t high) {
    const int32_t value = random->whole(low, high);
    return on_centres ? (value & ~255) | 128 : value;
  };
  for (int k = 0; k < 2; ++k) {
    const int32_t middle = random->whole(0, 64 * 256), half = 256 + random->whole(0, reach / 2);
    box[k] = coordinate(middle - half, middle - 256);
    box[k + 2] = coordinate(middle + 256, middle + half);
  }
  const int32_t cx = coordinate(box[0] + 1, box[2] - 1), cy = coordinate(box[1] + 1, box[3] - 1);
  int32_t spoke[kMaxSpokes][2];
  const int spokes = make_spokes(random, box, spoke);
  const int32_t begin = std::clamp(box[1] / 256 - 1, 0, kTile), end = std::clamp(box[3] / 256 + 2, 0, kTile);
  std::fill_n(g_hits, kTilePixels, 0u);
  for (int i = 0; i < spokes; ++i) {
    const int32_t *a = spoke[i], *b = spoke[(i + 1) % spokes];
    ScreenTriangle t = {{cx, a[0], b[0]}, {cy, a[1], b[1]}, {0.5f, 0.25f, 0.75f}, 0, 0, 0};
    if (turn(&t)) count_hits(target, t, begin, end);
  }
  for (int32_t i = 0; i < static_cast<int32_t>(kTilePixels); ++i) {
    const int32_t x = 256 * (i % kTile) + 128, y = 256 * (i / kTile) + 128;
    const uint32_t want = x >= box[0] && x < box[2] && y >= box[1] && y < box[3];
    if (g_hits[i] != want) {
      fail_msg("%s: pixel %d %d of the fan at %d %d in %d %d %d %d hit %u times, want %u", target.name, i % kTile,
               i / kTile, cx, cy, box[0], box[1], box[2], box[3], g_hits[i], want);
    }
  }
  return spokes;
}

void test_fans(void**) {
  clear(&g_tile);
  for_each_target([&](const core::SimdTarget& target, bool first) {
    Random random = {7};
    for (int triangles = 0; triangles < (first ? 1000000 : 50000);) triangles += run_fan(target, &random);
  });
}

constexpr int kCells = 12;

/// A grid larger than the tile; its inner vertices are moved by almost half a cell, its diagonals are random.
void test_mesh(void**) {
  clear(&g_tile);
  for_each_target([&](const core::SimdTarget& target, bool) {
    Random random = {11};
    for (int mesh = 0; mesh < 40; ++mesh) {
      const int32_t cell = mesh % 2 ? 1536 : 1500, jitter = mesh % 3 ? 600 : 0;
      int32_t x[kCells + 1][kCells + 1], y[kCells + 1][kCells + 1];
      for (int j = 0; j <= kCells; ++j) {
        for (int i = 0; i <= kCells; ++i) {
          x[j][i] = (i - 1) * cell + 128 + random.whole(-jitter / 2, jitter / 2);
          y[j][i] = (j - 1) * cell + 128 + random.whole(-jitter / 2, jitter / 2);
        }
      }
      std::fill_n(g_hits, kTilePixels, 0u);
      for (int j = 0; j < kCells; ++j) {
        for (int i = 0; i < kCells; ++i) {
          const int flip = static_cast<int>(random.bits() & 1);
          const int corner[4][2] = {{j, i}, {j, i + 1}, {j + 1, i + 1}, {j + 1, i}};
          for (int half = 0; half < 2; ++half) {
            ScreenTriangle t = {{0, 0, 0}, {0, 0, 0}, {0.1f, 0.5f, 0.9f}, 0, 0, 0};
            for (int k = 0; k < 3; ++k) {
              const int* at = corner[(flip + 2 * half + k) % 4];
              place(&t, k, x[at[0]][at[1]], y[at[0]][at[1]]);
            }
            if (turn(&t)) count_hits(target, t, 0, kTile);
          }
        }
      }
      for (size_t i = 0; i < kTilePixels; ++i) {
        if (g_hits[i] != 1) fail_msg("%s: mesh %d pixel %zu hit %u times", target.name, mesh, i, g_hits[i]);
      }
    }
  });
}

/// The depth of a pixel does not depend on the tile.
void test_depth_across_tiles(void**) {
  Random random = {13};
  for (int n = 0; n < 300; ++n) {
    ScreenTriangle t = {};
    (n % 3 == 0 ? huge : tile_crossing)(&random, 64, 64, &t);
    for (float& z : t.z) z = random.real(0.0, 0.99);
    if (!turn(&t)) continue;
    for_each_target([&](const core::SimdTarget& target, bool) {
      clear(&g_first);
      cover_one(target, t, 64, 64, &g_first);
      for (int32_t shift : {-32, 32}) {
        clear(&g_tile);
        cover_one(target, t, 64 + shift, 64 - shift, &g_tile);
        for (int32_t y = std::max(0, -shift); y < std::min(kTile, kTile - shift); ++y) {
          for (int32_t x = std::max(0, shift); x < std::min(kTile, kTile + shift); ++x) {
            const int32_t here = y * kTile + x, there = (y + shift) * kTile + x - shift;
            if (memcmp(&g_first.depth[here], &g_tile.depth[there], 4) != 0) {
              fail_msg("%s: triangle %d at %d %d: %a and %a", target.name, n, x, y,
                       static_cast<double>(g_first.depth[here]), static_cast<double>(g_tile.depth[there]));
            }
          }
        }
      }
    });
  }
}

struct order_case {
  const char* name;
  float z[3];     // depths of three triangles over the whole tile
  uint32_t slot;  // slot of the winner
};
const order_case k_orders[] = {
    {"order/nearer_later", {0.5f, 0.25f, 0.75f}, 11},        {"order/tie_keeps_first", {0.5f, 0.5f, 0.5f}, 10},
    {"order/tie_of_the_last_two", {0.5f, 0.25f, 0.25f}, 11}, {"order/at_the_far_plane", {1.0f, 1.0f, 1.0f}, kNoSlot},
    {"order/at_the_near_plane", {0.0f, 0.0f, 0.0f}, 10},     {"order/minus_zero_is_no_nearer", {0.0f, -0.0f, 0.0f}, 10},
};

void test_order(void** state) {
  const auto* c = static_cast<const order_case*>(*state);
  ScreenTriangle t[3];
  for (int i = 0; i < 3; ++i) {
    t[i] = {{-20000, 100000, -20000}, {-20000, -20000, 100000}, {c->z[i], c->z[i], c->z[i]}, 0, 0, 0};
  }
  const uint32_t entries[3] = {0, 1, 2};
  for_each_target([&](const core::SimdTarget& target, bool) {
    clear(&g_tile);
    raster::cover(target, area_at(0, 0), kLess, t, entries, 3, 10, &g_tile);
    for (size_t i = 0; i < kTilePixels; ++i) assert_int_equal(g_tile.slot[i], c->slot);
  });
}

struct compare_case {
  const char* name;
  shd_compare compare;
  bool less, equal, greater;  // whether such a depth passes
};
const compare_case k_compares[] = {
    {"compare/less", SHD_COMPARE_LESS, true, false, false},
    {"compare/less_equal", SHD_COMPARE_LESS_EQUAL, true, true, false},
    {"compare/equal", SHD_COMPARE_EQUAL, false, true, false},
    {"compare/greater_equal", SHD_COMPARE_GREATER_EQUAL, false, true, true},
    {"compare/greater", SHD_COMPARE_GREATER, false, false, true},
    {"compare/not_equal", SHD_COMPARE_NOT_EQUAL, true, false, true},
    {"compare/always", SHD_COMPARE_ALWAYS, true, true, true},
    {"compare/never", SHD_COMPARE_NEVER, false, false, false},
};
/// A triangle over the left half of the tile; its edge there is too long for int32.
const ScreenTriangle kWideHalf = {
    {32 * 256, 32 * 256, -(1 << 24)}, {-(1 << 24), 1 << 24, 0}, {0.5f, 0.5f, 0.5f}, 0, 0, 0};
const ScreenTriangle kEverywhere = {{-20000, 100000, -20000}, {-20000, -20000, 100000}, {0.5f, 0.5f, 0.5f}, 0, 0, 0};

/// Depths 0.75, 0.5 and 0.25 in turn, compared with 0.5: by the kernels that write and by the kernels of masks, for
/// narrow and for wide triangles.
void check_compare(const compare_case* c, const ScreenTriangle& triangle, size_t columns) {
  static raster::CoverMask mask;
  const uint32_t entry = 0;
  const float before[3] = {0.75f, 0.5f, 0.25f};
  const bool want[3] = {c->less, c->equal, c->greater};
  for (const bool writes : {true, false}) {
    const raster::DepthState depth = {c->compare, writes, 0.0f, 0.0f};
    for_each_target([&](const core::SimdTarget& target, bool) {
      clear(&g_tile);
      for (size_t i = 0; i < kTilePixels; ++i) g_tile.depth[i] = before[i % 3];
      raster::cover_mask(target, area_at(0, 0), depth, triangle, g_tile, &mask);
      raster::cover(target, area_at(0, 0), depth, &triangle, &entry, 1, 7, &g_tile);
      for (size_t i = 0; i < kTilePixels; ++i) {
        const bool pass = want[i % 3] && i % kTile < columns;
        if (i % kTile < columns) assert_int_equal(mask.bits[i], pass);
        assert_int_equal(g_tile.slot[i], pass ? 7 : kNoSlot);
        assert_true(g_tile.depth[i] == (pass && writes ? 0.5f : before[i % 3]));
      }
    });
  }
}

void test_compare(void** state) {
  const auto* c = static_cast<const compare_case*>(*state);
  check_compare(c, kEverywhere, kTile);
  ScreenTriangle wide = kWideHalf;
  assert_true(turn(&wide));
  check_compare(c, wide, kTile / 2);
}

/// Triangles over each other, with comparisons that make depths fall, rise or neither. Masks do not use the bounds of
/// depths; they show that triangles rejected by the bounds had no visible samples.
void test_bounds(void**) {
  static raster::CoverMask mask;
  const uint32_t entry = 0;
  for (const uint32_t samples : {1u, 4u}) {
    set_samples(samples);
    for_each_target([&](const core::SimdTarget& target, bool) {
      Random random = {23};
      clear(&g_tile);
      int32_t kind = 0, hidden = 0;
      for (uint32_t n = 0; n < 600; ++n) {
        ScreenTriangle t = {};
        for (int k = 0; k < 3; ++k)
          place(&t, k, random.whole(-64 * 256, 128 * 256), random.whole(-64 * 256, 128 * 256));
        const float depth = random.real(0.0, 1.0);
        for (float& z : t.z) z = n % 3 ? depth : random.real(0.0, 1.0);
        if (!turn(&t)) continue;
        if (n % 40 == 0) kind = random.whole(SHD_COMPARE_LESS, SHD_COMPARE_ALWAYS);
        const raster::DepthState state = {static_cast<shd_compare>(n % 40 < 39 ? kind : SHD_COMPARE_ALWAYS), n % 7 != 0,
                                          n % 5 ? 0.0f : random.real(-0.5, 0.5), n % 10 ? 0.0f : random.real(-4, 4)};
        raster::cover_mask(target, area_at(0, 0, samples), state, t, g_tile, &mask);
        raster::cover(target, area_at(0, 0, samples), state, &t, &entry, 1, n, &g_tile);
        bool drawn = false;
        for (size_t i = 0; i < samples * kTilePixels; ++i) {
          const auto x = static_cast<int32_t>(i / samples % kTile), y = static_cast<int32_t>(i / samples / kTile);
          const bool in_box = x >= mask.box.min_x && x <= mask.box.max_x && y >= mask.box.min_y && y <= mask.box.max_y;
          const bool want = in_box && (mask.bits[i / samples] >> i % samples & 1);
          if (want != (g_tile.slot[i] == n)) fail_msg("%s: triangle %u, sample %zu", target.name, n, i);
          drawn |= want;
        }
        hidden += !drawn;
      }
      assert_true(hidden > 50);
    });
  }
  set_samples(1);
}

/// Without slots only depth changes; masks equal the slots of a cleared tile.
void test_masks(void**) {
  static raster::CoverMask mask;
  const uint32_t entry = 0;
  Random random = {19};
  for (const uint32_t samples : {1u, 2u, 4u, 8u, 16u}) {
    set_samples(samples);
    for (int n = 0; n < 100; ++n) {
      ScreenTriangle t = {};
      k_shapes[n % 8].shape(&random, 0, 0, &t);
      for (float& z : t.z) z = random.real(0.0, 0.99);
      if (!turn(&t)) continue;
      for_each_target([&](const core::SimdTarget& target, bool) {
        clear(&g_tile);
        clear(&g_first);
        raster::cover_mask(target, area_at(0, 0, samples), kLess, t, g_tile, &mask);
        cover_one(target, t, 0, 0, &g_tile);
        raster::cover(target, area_at(0, 0, samples), kLess, &t, &entry, 1, kNoSlot, &g_first);
        for (size_t i = 0; i < samples * kTilePixels; ++i) {
          const auto pixel = static_cast<int32_t>(i / samples);
          const bool in_box = pixel % kTile >= mask.box.min_x && pixel % kTile <= mask.box.max_x &&
                              pixel / kTile >= mask.box.min_y && pixel / kTile <= mask.box.max_y;
          const bool got = in_box && (mask.bits[pixel] >> i % samples & 1);
          assert_int_equal(got, g_tile.slot[i] == 0);
          assert_int_equal(g_first.slot[i], kNoSlot);
          assert_true(g_first.depth[i] == g_tile.depth[i]);
        }
      });
    }
  }
  set_samples(1);
}

/// Draws a triangle sample by sample, from its mask and its plane.
void draw_slowly(const core::SimdTarget& target, const raster::CoverArea& area, const raster::DepthState& state,
                 const ScreenTriangle& t, uint32_t slot, Tile* tile) {
  static raster::CoverMask mask;
  raster::cover_mask(target, area, state, t, *tile, &mask);
  const raster::DepthSlope slope = raster::make_depth_slope(t, state);
  for (int32_t y = mask.box.min_y; y <= mask.box.max_y; ++y) {
    for (int32_t x = mask.box.min_x; x <= mask.box.max_x; ++x) {
      const auto pixel = static_cast<size_t>(y * kTile + x);
      for (uint32_t rest = mask.bits[pixel]; rest; rest &= rest - 1) {
        const auto s = static_cast<uint32_t>(__builtin_ctz(rest));
        const raster::DepthPlane plane = raster::plane_at(slope, area.pattern.point[s]);
        if (state.writes) {
          tile->depth[pixel * tile->samples + s] = raster::depth_at(plane, area.left + x, area.top + y);
        }
        tile->slot[pixel * tile->samples + s] = slot;
      }
    }
  }
}

/// Triangles of all sizes drawn by one call, in a whole tile and in a box of it, against the same triangles drawn one
/// after the other, sample by sample.
void test_batches(void**) {
  Random random = {29};
  const Shape shapes[] = {tiny, tiny, tiny, small, vertices_on_centres, sliver, tile_crossing, axis_aligned};
  for (const uint32_t samples : {1u, 2u, 4u, 8u, 16u}) {
    set_samples(samples);
    for (int n = 0; n < 120; ++n) {
      ScreenTriangle t[40];
      uint32_t entries[40], count = 0;
      const auto wanted = static_cast<uint32_t>(random.whole(1, 40));
      const bool is_small = n % 2 == 0;
      while (count < wanted) {
        ScreenTriangle& next = t[count] = {};
        shapes[random.whole(0, is_small ? 2 : 7)](&random, 64, 128, &next);
        for (float& z : next.z) z = random.whole(0, 3) ? random.real(0.0, 1.0) : 0.5f;
        if (turn(&next)) entries[wanted - 1 - count] = count, ++count;
      }
      raster::CoverArea area = area_at(64, 128, samples);
      if (n % 3 == 0) area.box = {64 + random.whole(0, 30), 128 + random.whole(0, 30), 64 + 33, 128 + 35};
      const raster::DepthState state = {static_cast<shd_compare>(random.whole(SHD_COMPARE_LESS, SHD_COMPARE_ALWAYS)),
                                        n % 5 != 0, n % 7 ? 0.0f : 0.01f, 0.0f};
      for_each_target([&](const core::SimdTarget& target, bool) {
        clear(&g_tile);
        for (float& depth : g_tile.depth) depth = 0.5f;
        copy(g_tile, &g_first);
        raster::forget_bounds(&g_first);
        raster::cover(target, area, state, t, entries, count, 3, &g_tile);
        for (uint32_t i = 0; i < count; ++i) draw_slowly(target, area, state, t[entries[i]], 3 + i, &g_first);
        if (!are_same(g_tile, g_first)) fail_msg("%s: batch %d of %u, %u samples", target.name, n, count, samples);
      });
    }
  }
  set_samples(1);
}

/// A triangle over the whole tile, and the triangle after it: a tile whose range of depths is known gets the same
/// depths and runs as a tile where each sample is drawn, also if the tile is drawn to again once it was shaded.
void test_whole(void**) {
  Random random = {41};
  raster::TileOrder order, first_order;
  raster::allocate(g_allocator, 1, &order);
  raster::allocate(g_allocator, 1, &first_order);
  for_each_target([&](const core::SimdTarget& target, bool) {
    size_t whole = 0, others = 0;
    for (int n = 0; n < 1000; ++n) {
      const auto compare = static_cast<shd_compare>(random.whole(SHD_COMPARE_LESS, SHD_COMPARE_ALWAYS));
      raster::fill_depth(target, random.whole(0, 2) ? 0.5f : n % 2 ? 1.0f : 0.0f, &g_tile);
      raster::begin_samples(&g_first);
      std::copy(g_tile.depth.begin(), g_tile.depth.end(), g_first.depth.begin());
      raster::forget_bounds(&g_first);
      for (uint32_t i = 0; i < 4; ++i) {
        ScreenTriangle t = kEverywhere;
        if (random.whole(0, 4) == 0) tiny(&random, 0, 0, &t);
        const float nearest = random.real(0.0, 1.0);
        for (float& z : t.z) z = random.whole(0, 3) ? 0.875f * nearest + random.real(0.0, 0.125) : 0.5f;
        if (!turn(&t)) continue;
        raster::CoverArea area = area_at(0, 0);
        if (random.whole(0, 9) == 0) area.box.max_y = kTile - 2;
        const raster::DepthState state = {compare, random.whole(0, 3) != 0, random.whole(0, 3) ? 0.0f : 0.25f, 0.0f};
        const uint32_t entry = 0, slot = random.whole(0, 5) ? i : kNoSlot;
        raster::cover(target, area, state, &t, &entry, 1, slot, &g_tile);
        raster::cover(target, area, state, &t, &entry, 1, slot, &g_first);
        raster::begin_samples(&g_first);
        ++(g_tile.sole_slot != kNoSlot ? whole : others);
        if (random.whole(0, 3) && i < 3) continue;
        raster::sort_pixels(target, g_tile, 4, &order);
        raster::sort_pixels(target, g_first, 4, &first_order);
        assert_int_equal(order.covered_samples, first_order.covered_samples);
        for (size_t k = 0; k <= 4; ++k) assert_int_equal(order.start[k], first_order.start[k]);
        assert_int_equal(order.bare.size(), first_order.bare.size());
        assert_memory_equal(order.run.data(), first_order.run.data(), order.run.size() * sizeof(raster::PixelRun));
        assert_memory_equal(g_tile.depth.data(), g_first.depth.data(), kTilePixels * sizeof(float));
        raster::clear_slots(target, &g_tile);
        raster::clear_slots(target, &g_first);
        for (size_t k = 0; k < kTilePixels; ++k) assert_int_equal(g_tile.slot[k], kNoSlot);
      }
    }
    assert_true(whole > 200 && others > 200);
  });
}

/// Pixels outside the box do not change, for any depth.
void test_box(void**) {
  const uint32_t entry = 0;
  const raster::DepthState always = {SHD_COMPARE_ALWAYS, true, 0.0f, 0.0f};
  const raster::CoverArea area = {raster::sample_pattern(1), 64, 128, {64 + 5, 128 + 9, 64 + 41, 128 + 50}};
  ScreenTriangle t = kEverywhere;
  for (int k = 0; k < 3; ++k) t.x[k] += 64 * 256, t.y[k] += 128 * 256;
  for_each_target([&](const core::SimdTarget& target, bool) {
    clear(&g_tile);
    raster::cover(target, area, always, &t, &entry, 1, 3, &g_tile);
    for (size_t i = 0; i < kTilePixels; ++i) {
      const size_t x = i % kTile, y = i / kTile;
      assert_int_equal(g_tile.slot[i], x >= 5 && x <= 41 && y >= 9 && y <= 50 ? 3 : kNoSlot);
    }
  });
}

/// Bias moves depth by a constant and by the steeper slope, clamped to 0..1.
void test_bias(void**) {
  const uint32_t entry = 0;
  // Depth per pixel along x and y, each of which is the steeper one, rising and falling.
  const struct {
    float start, dx, dy;
  } planes[] = {{0.25f, 0x1p-8f, 0x1p-10f},  {0.25f, 0x1p-10f, 0x1p-8f},   {0.75f, -0x1p-8f, 0x1p-10f},
                {0.75f, 0x1p-10f, -0x1p-8f}, {0.75f, -0x1p-10f, -0x1p-8f}, {0.75f, -0x1p-8f, -0x1p-10f}};
  const struct {
    float bias, slope;
    double want;
  } cases[] = {{0.125f, 0, 0.125}, {-0.0625f, 0, -0.0625},
               {0, 2, 2.0 / 256},  {0.125f, -4, 0.125 - 4.0 / 256},
               {1, 0, 1},          {-1, 0, -1}};
  for (const auto& p : planes) {
    const ScreenTriangle t = {
        {0, 128 * 256, 0}, {0, 0, 128 * 256}, {p.start, p.start + 128 * p.dx, p.start + 128 * p.dy}, 0, 0, 0};
    for (const auto& c : cases) {
      for_each_target([&](const core::SimdTarget& target, bool) {
        clear(&g_tile);
        const raster::DepthState state = {SHD_COMPARE_LESS_EQUAL, true, c.bias, c.slope};
        raster::cover(target, area_at(0, 0), state, &t, &entry, 1, 0, &g_tile);
        for (size_t i = 0; i < kTilePixels; ++i) {
          const double x = static_cast<double>(i % kTile) + 0.5, y = static_cast<double>(i / kTile) + 0.5;
          const double plane =
              static_cast<double>(p.start) + x * static_cast<double>(p.dx) + y * static_cast<double>(p.dy);
          const double want = std::clamp(plane + c.want, 0.0, 1.0);
          shd_assert_close("bias", i, static_cast<double>(g_tile.depth[i]), want, 1e-6, 0.0);
        }
      });
    }
  }
}

/// A depth that no triangle can pass, as outside the frame, does not change.
void test_unreachable(void**) {
  const ScreenTriangle t = {{-20000, 100000, -20000}, {-20000, -20000, 100000}, {0.0f, 0.0f, 0.0f}, 0, 0, 0};
  for_each_target([&](const core::SimdTarget& target, bool) {
    clear(&g_tile);
    for (size_t i = 0; i < kTilePixels; i += 2) g_tile.depth[i] = -1.0f;
    cover_one(target, t, 0, 0, &g_tile);
    for (size_t i = 0; i < kTilePixels; ++i) assert_int_equal(g_tile.slot[i], i % 2 ? 0 : kNoSlot);
  });
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  set_samples(1);
  CMUnitTest tests[40];
  size_t n = 0;
  for (const shape_case& c : k_shapes) tests[n++] = {c.name, test_shape, nullptr, nullptr, const_cast<shape_case*>(&c)};
  for (const order_case& c : k_orders) tests[n++] = {c.name, test_order, nullptr, nullptr, const_cast<order_case*>(&c)};
  for (const compare_case& c : k_compares) {
    tests[n++] = {c.name, test_compare, nullptr, nullptr, const_cast<compare_case*>(&c)};
  }
  tests[n++] = {"bounds", test_bounds, nullptr, nullptr, nullptr};
  tests[n++] = {"masks", test_masks, nullptr, nullptr, nullptr};
  tests[n++] = {"batches", test_batches, nullptr, nullptr, nullptr};
  tests[n++] = {"whole", test_whole, nullptr, nullptr, nullptr};
  tests[n++] = {"box", test_box, nullptr, nullptr, nullptr};
  tests[n++] = {"depth/bias", test_bias, nullptr, nullptr, nullptr};
  tests[n++] = {"fans/10^6_triangles", test_fans, nullptr, nullptr, nullptr};
  tests[n++] = {"mesh/shared_edges", test_mesh, nullptr, nullptr, nullptr};
  tests[n++] = {"depth/same_through_any_tile", test_depth_across_tiles, nullptr, nullptr, nullptr};
  tests[n++] = {"depth/outside_the_frame", test_unreachable, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.raster.coverage", tests, n, nullptr, nullptr);
}
