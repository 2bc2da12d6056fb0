// SPDX-License-Identifier: MIT
// A million closed fans of triangles around a point: a sample inside the polygon around the fan is in one triangle, any
// other sample in none. The polygon is scanned with exact integers, including samples on its border.
#include "support/check.h"

#include <algorithm>

#include "raster/coverage.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {
namespace {

using geometry::PixelBox;
using geometry::ScreenTriangle;
using raster::kTile;
using raster::kTilePixels;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(NDEBUG)
constexpr int kFans = 1000000 / 50;
#else
constexpr int kFans = 1000000;
#endif
constexpr uint32_t kPatterns = 5;  // 1, 2, 4, 8 and 16 samples
constexpr int kMaxVertices = 24;
constexpr int64_t kFarthest = 1 << 28;  // guard band in fixed point

const core::Allocator g_allocator = {core::default_allocator()};
raster::Tile g_tile[kPatterns];
raster::CoverMask g_mask;
uint32_t g_covered[kTilePixels];  // samples that a triangle covers

/// A vertex relative to the middle of the fan.
struct Spoke {
  int64_t x, y;
};
int64_t cross(Spoke a, Spoke b) {
  return a.x * b.y - a.y * b.x;
}
/// Exact order by angle.
bool comes_before(Spoke a, Spoke b) {
  const auto is_lower = [](Spoke s) { return s.y < 0 || (s.y == 0 && s.x < 0); };
  if (is_lower(a) != is_lower(b)) return is_lower(b);
  return cross(a, b) > 0;
}

struct Fan {
  int64_t x, y;  // middle, fixed point
  int count;
  Spoke spoke[kMaxVertices];
};

/// Kinds of fans: vertices at up to 2^size subpixels from the middle, moved onto a grid.
enum class Grid { kSubpixel, kCentre, kSample, kHalf };
struct Kind {
  const char* name;
  double low, high;  // size
  Grid grid;
  bool is_thin;
  int weight;  // frequency in a thousand fans
};
const Kind k_kinds[] = {
    {"within a pixel", 0.5, 8, Grid::kSubpixel, false, 260},
    {"of some pixels", 8, 11, Grid::kSubpixel, false, 300},
    {"on pixel centres", 9, 11.5, Grid::kCentre, false, 90},
    {"on samples", 9, 11.5, Grid::kSample, false, 100},
    {"on half pixels", 9, 11.5, Grid::kHalf, false, 70},
    {"slivers", 4, 13, Grid::kSubpixel, true, 110},
    {"across tiles", 12, 17, Grid::kSubpixel, false, 35},
    {"across tiles, on samples", 12, 17, Grid::kSample, false, 20},
    {"far", 17, 29, Grid::kSubpixel, false, 9},
    {"far slivers", 17, 29, Grid::kSubpixel, true, 6},
};
constexpr size_t kKinds = sizeof k_kinds / sizeof k_kinds[0];

size_t pick_kind(Random* random) {
  int left = random->whole(0, 999);
  size_t kind = 0;
  while (left >= k_kinds[kind].weight) left -= k_kinds[kind++].weight;
  return kind;
}

void snap(Grid grid, const raster::SamplePattern& pattern, Random* random, int64_t* x, int64_t* y) {
  const int64_t pixel_x = *x & ~int64_t{255}, pixel_y = *y & ~int64_t{255};
  const raster::SamplePoint sample = pattern.point[random->bits() % pattern.count];
  if (grid == Grid::kCentre) *x = pixel_x + 128, *y = pixel_y + 128;
  if (grid == Grid::kSample) *x = pixel_x + sample.x, *y = pixel_y + sample.y;
  if (grid == Grid::kHalf) *x &= ~int64_t{127}, *y &= ~int64_t{127};
}

Spoke spoke_to(const Fan& fan, int64_t x, int64_t y) {
  return {std::clamp(x, -kFarthest, kFarthest) - fan.x, std::clamp(y, -kFarthest, kFarthest) - fan.y};
}

/// Adds spokes where two are more than half a turn apart. Returns false if that does not help.
bool close(Fan* fan) {
  for (int attempt = 0; attempt < 3; ++attempt) {
    std::sort(fan->spoke, fan->spoke + fan->count, comes_before);
    int gap = -1;
    for (int i = 0; i < fan->count && gap < 0; ++i) {
      if (cross(fan->spoke[i], fan->spoke[(i + 1) % fan->count]) < 0) gap = i;
    }
    if (gap < 0) return fan->count >= 3;
    if (fan->count == kMaxVertices) return false;
    const Spoke a = fan->spoke[gap], b = fan->spoke[(gap + 1) % fan->count];
    const Spoke opposite = spoke_to(*fan, fan->x - a.x - b.x, fan->y - a.y - b.y);
    if (opposite.x != 0 || opposite.y != 0) fan->spoke[fan->count++] = opposite;
  }
  return false;
}

/// Makes a fan around a point in a tile or right beside it. Returns false if that fails.
bool make_fan(const Kind& kind, const raster::SamplePattern& pattern, int32_t left, int32_t top, Random* random,
              Fan* fan) {
  const double reach = std::exp2(random->in(kind.low, kind.high)), tilt = random->in(0, 2 * M_PI);
  const double along_x = std::cos(tilt), along_y = std::sin(tilt);
  fan->x = 256 * int64_t{left} + random->whole(-64, 256 * kTile + 64);
  fan->y = 256 * int64_t{top} + random->whole(-64, 256 * kTile + 64);
  snap(kind.grid, pattern, random, &fan->x, &fan->y);
  fan->count = 0;
  for (int wanted = random->whole(3, random->bits() % 4 ? 6 : kMaxVertices - 3); wanted > 0; --wanted) {
    double x, y;
    if (kind.is_thin) {
      const double along = random->in(-reach, reach), across = random->in(-3, 3);
      x = along * along_x - across * along_y;
      y = along * along_y + across * along_x;
    } else {
      const double angle = random->in(0, 2 * M_PI), radius = reach * random->in(0.05, 1);
      x = radius * std::cos(angle);
      y = radius * std::sin(angle);
    }
    int64_t at_x = fan->x + std::lrint(x), at_y = fan->y + std::lrint(y);
    snap(kind.grid, pattern, random, &at_x, &at_y);
    const Spoke spoke = spoke_to(*fan, at_x, at_y);
    if (spoke.x != 0 || spoke.y != 0) fan->spoke[fan->count++] = spoke;
  }
  return close(fan);
}

PixelBox bounds(const Fan& fan) {
  int64_t min_x = fan.x, max_x = fan.x, min_y = fan.y, max_y = fan.y;
  for (int i = 0; i < fan.count; ++i) {
    min_x = std::min(min_x, fan.x + fan.spoke[i].x), max_x = std::max(max_x, fan.x + fan.spoke[i].x);
    min_y = std::min(min_y, fan.y + fan.spoke[i].y), max_y = std::max(max_y, fan.y + fan.spoke[i].y);
  }
  return {static_cast<int32_t>(min_x >> 8) - 1, static_cast<int32_t>(min_y >> 8) - 1,
          static_cast<int32_t>(max_x >> 8) + 1, static_cast<int32_t>(max_y >> 8) + 1};
}

/// Finds the pixels of a tile row with a sample in the polygon, as bits: an odd number of crossings lies at or left of
/// them. An edge includes its upper end but not its lower end. This is the top-left rule for the polygon as a whole.
uint64_t scan(const Fan& fan, int32_t left, int64_t y, int32_t sample_x) {
  uint64_t row = 0;
  for (int i = 0; i < fan.count; ++i) {
    Spoke a = fan.spoke[i], b = fan.spoke[i + 1 == fan.count ? 0 : i + 1];
    if (a.y > b.y) std::swap(a, b);
    if (!(a.y + fan.y <= y && y < b.y + fan.y)) continue;
    // The first pixel i with 256 (left + i) + sample_x >= x of the crossing.
    const int64_t height = b.y - a.y;
    const int64_t to_edge = a.x + fan.x - 256 * int64_t{left} - sample_x;
    const int64_t numerator = to_edge * height + (y - a.y - fan.y) * (b.x - a.x), denominator = 256 * height;
    const int64_t quotient = numerator / denominator;
    const int64_t first = quotient + (numerator > quotient * denominator);
    row ^= first <= 0 ? ~uint64_t{0} : first >= 64 ? 0 : ~uint64_t{0} << first;
  }
  return row;
}

struct Totals {
  uint64_t fans[kKinds], triangles, samples;
};

/// A fan in a tile of a picture.
struct Case {
  const Fan* fan;
  const raster::SamplePattern* pattern;
  int32_t left, top;
  PixelBox drawn, checked;  // pixels of the picture; nothing is visible in `drawn` outside `checked`
  const char* kind;
};

[[noreturn]] void fail_case(const Case& c, const char* what, const char* target, int32_t x, int32_t y,
                            uint32_t samples) {
  print_error("fan around %lld %lld:", static_cast<long long>(c.fan->x), static_cast<long long>(c.fan->y));
  for (int i = 0; i < c.fan->count; ++i) {
    const Spoke s = c.fan->spoke[i];
    print_error(" (%lld %lld)", static_cast<long long>(c.fan->x + s.x), static_cast<long long>(c.fan->y + s.y));
  }
  print_error("\n%s, %s, %u samples: pixel %d %d, samples %x: %s\n", target, c.kind, c.pattern->count, x, y, samples,
              what);
  fail();
  abort();
}

/// Draws every triangle of the fan; no sample may be covered twice.
uint64_t draw(const Case& c, const core::SimdTarget& target, const raster::Tile& tile, uint64_t start) {
  const raster::DepthState state = {SHD_COMPARE_ALWAYS, false, 0.0f, 0.0f};
  const raster::CoverArea area = {*c.pattern, c.left, c.top, c.drawn};
  const Fan& fan = *c.fan;
  uint64_t triangles = 0;
  for (int32_t y = c.checked.min_y; y <= c.checked.max_y; ++y) {
    uint32_t* row = g_covered + (y - c.top) * kTile - c.left;
    std::fill(row + c.checked.min_x, row + c.checked.max_x + 1, 0u);
  }
  for (int i = 0; i < fan.count; ++i) {
    const Spoke a = fan.spoke[i], b = fan.spoke[i + 1 == fan.count ? 0 : i + 1];
    if (cross(a, b) == 0) continue;  // assembly culls it
    const auto first = static_cast<int>((start + static_cast<uint64_t>(i)) % 3);
    const int64_t x[3] = {0, a.x, b.x}, y[3] = {0, a.y, b.y};
    ScreenTriangle t = {{}, {}, {0.5f, 0.5f, 0.5f}, 0, 0, 0};
    for (int k = 0; k < 3; ++k) {
      t.x[k] = static_cast<int32_t>(fan.x + x[(first + k) % 3]);
      t.y[k] = static_cast<int32_t>(fan.y + y[(first + k) % 3]);
    }
    ++triangles;
    raster::cover_mask(target, area, state, t, tile, &g_mask);
    for (int32_t py = g_mask.box.min_y; py <= g_mask.box.max_y; ++py) {
      uint32_t twice = 0;
      for (int32_t at = py * kTile + g_mask.box.min_x; at <= py * kTile + g_mask.box.max_x; ++at) {
        twice |= g_covered[at] & g_mask.bits[at];
        g_covered[at] |= g_mask.bits[at];
      }
      if (twice) fail_case(c, "twice (in this row)", target.name, c.left + g_mask.box.min_x, c.top + py, twice);
    }
  }
  return triangles;
}

/// The covered samples are the polygon.
void check(const Case& c, const char* target) {
  for (int32_t y = c.checked.min_y; y <= c.checked.max_y; ++y) {
    uint32_t want[kTile] = {};
    for (uint32_t s = 0; s < c.pattern->count; ++s) {
      const raster::SamplePoint point = c.pattern->point[s];
      uint64_t row = scan(*c.fan, c.left, 256 * int64_t{y} + point.y, point.x);
      for (; row; row &= row - 1) want[__builtin_ctzll(row)] |= 1u << s;
    }
    const uint32_t* got = g_covered + (y - c.top) * kTile;
    for (int32_t x = c.checked.min_x - c.left; x <= c.checked.max_x - c.left; ++x) {
      if (got[x] != want[x]) {
        fail_case(c, got[x] & ~want[x] ? "hit outside the polygon" : "not hit", target, c.left + x, y,
                  got[x] ^ want[x]);
      }
    }
  }
}

PixelBox part_of(const PixelBox& tile, Random* random) {
  PixelBox box = tile;
  box.min_x += random->whole(0, kTile - 1);
  box.min_y += random->whole(0, kTile - 1);
  box.max_x = std::min(tile.max_x, box.min_x + random->whole(0, 15));
  box.max_y = std::min(tile.max_y, box.min_y + random->whole(0, 15));
  return box;
}

void run_fan(const core::SimdTarget& target, uint32_t pattern_index, Random* random, Totals* totals) {
  const raster::SamplePattern& pattern = raster::sample_pattern(1u << pattern_index);
  const size_t kind = pick_kind(random);
  const int32_t left = kTile * random->whole(0, 1023) * (random->bits() % 2), top = kTile * random->whole(0, 1023);
  Fan fan;
  while (!make_fan(k_kinds[kind], pattern, left, top, random, &fan)) {
  }
  const PixelBox tile = geometry::pixel_rectangle(left, top, kTile, kTile);
  // Large fans are drawn mostly through a small box, which costs less.
  const bool whole = random->bits() % (k_kinds[kind].high < 14 ? 4 : 16) != 0;
  const PixelBox drawn = (k_kinds[kind].high < 14) == whole ? tile : part_of(tile, random);
  const Case c = {&fan, &pattern, left, top, drawn, geometry::intersection(bounds(fan), drawn), k_kinds[kind].name};
  ++totals->fans[kind];
  if (geometry::is_empty(c.checked)) return;
  totals->triangles += draw(c, target, g_tile[pattern_index], random->bits() % 3);
  check(c, target.name);
  const PixelBox& box = c.checked;
  totals->samples += static_cast<uint64_t>((box.max_x - box.min_x + 1) * (box.max_y - box.min_y + 1)) * pattern.count;
}

/// One case for each number of samples.
void test_fans(void** state) {
  const uint32_t pattern = *static_cast<const uint32_t*>(*state);
  static const int k_share[kPatterns] = {40, 20, 20, 10, 10};  // percent
  const int count = kFans / 100 * k_share[pattern];
  raster::Tile& tile = g_tile[pattern];
  raster::allocate(g_allocator, 1u << pattern, &tile);
  for (size_t i = 0; i < tile.samples * kTilePixels; ++i) tile.depth[i] = 1.0f;
  Random random = {1000 + pattern};
  Totals totals = {};
  int fan = 0;
  while (fan < count) {
    for_each_target([&](const core::SimdTarget& target, bool) {
      if (fan++ < count) run_fan(target, pattern, &random, &totals);
    });
  }
  print_message("%d fans of %llu triangles on %zu targets, %llu samples checked\n", count,
                static_cast<unsigned long long>(totals.triangles), target_bits().size(),
                static_cast<unsigned long long>(totals.samples));
  for (size_t k = 0; k < kKinds; ++k) assert_true(totals.fans[k] > 0);
  tile = {};
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  static const uint32_t k_patterns[kPatterns] = {0, 1, 2, 3, 4};
  static const char* const k_names[kPatterns] = {"fans/1_sample", "fans/2_samples", "fans/4_samples", "fans/8_samples",
                                                 "fans/16_samples"};
  CMUnitTest tests[kPatterns];
  for (uint32_t p = 0; p < kPatterns; ++p) {
    tests[p] = {k_names[p], test_fans, nullptr, nullptr, const_cast<uint32_t*>(&k_patterns[p])};
  }
  return _cmocka_run_group_tests("unit.raster.fill_rule", tests, kPatterns, nullptr, nullptr);
}
