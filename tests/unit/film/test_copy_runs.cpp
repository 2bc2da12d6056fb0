// SPDX-License-Identifier: MIT
// Columns copied to the pixels of runs: every length, in a buffer of one tile and in planes of a framebuffer.
#include "support/check.h"

#include <vector>

#include "film/copy_runs.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {
namespace {

using raster::kTile;
using raster::kTilePixels;
using raster::PixelRun;

/// Runs whose lengths are 1 to `longest`, and gaps between them.
std::vector<PixelRun> make_runs(uint32_t longest, Random* random) {
  std::vector<PixelRun> runs;
  for (auto begin = static_cast<uint32_t>(random->whole(0, 3)); begin < kTilePixels;) {
    const uint32_t end = std::min<uint32_t>(kTilePixels, begin + static_cast<uint32_t>(random->whole(1, longest)));
    runs.push_back({static_cast<uint16_t>(begin), static_cast<uint16_t>(end), 1});
    begin = end + static_cast<uint32_t>(random->whole(0, 5));
  }
  return runs;
}

size_t place_of(uint32_t pixel, size_t stride) {
  return pixel / kTile * stride + pixel % kTile;
}

void check(const std::vector<PixelRun>& runs, size_t stride) {
  const size_t size = kTile * stride;
  std::vector<float> columns(4 * kTilePixels), want(4 * size, -77.0f);
  for (size_t i = 0; i < columns.size(); ++i) columns[i] = static_cast<float>(i);
  columns[5] = NAN, columns[kTilePixels + 9] = -INFINITY;
  size_t row = 0;
  for (const PixelRun& run : runs) {
    for (uint32_t pixel = run.begin; pixel < run.end; ++pixel, ++row) {
      for (size_t c = 0; c < 4; ++c) want[c * size + place_of(pixel, stride)] = columns[c * kTilePixels + row];
    }
  }
  const float* const column[4] = {&columns[0], &columns[kTilePixels], &columns[2 * kTilePixels],
                                  &columns[3 * kTilePixels]};
  for_each_target([&](const core::SimdTarget& target, bool) {
    std::vector<float> got(4 * size, -77.0f);
    const film::TilePlanes planes = {{&got[0], &got[size], &got[2 * size], &got[3 * size]}, stride};
    film::copy_runs(target, runs.data(), runs.size(), column, planes);
    assert_memory_equal(got.data(), want.data(), want.size() * sizeof(float));
  });
}

void test_lengths(void**) {
  for (size_t stride : {size_t{kTile}, size_t{kTile + 16}, size_t{1040}}) {
    for (uint32_t length = 1; length <= 200; ++length) {
      check({{3, static_cast<uint16_t>(3 + length), 1}, {1000, static_cast<uint16_t>(1000 + length), 1}}, stride);
    }
    check({{0, kTilePixels, 1}}, stride);
    check({}, stride);
  }
}

void test_random(void**) {
  Random random = {1};
  for (uint32_t longest : {2u, 9u, 40u, 300u}) {
    for (int i = 0; i < 10; ++i) check(make_runs(longest, &random), i % 2 ? size_t{kTile} : size_t{200});
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  const CMUnitTest tests[] = {{"lengths", test_lengths, nullptr, nullptr, nullptr},
                              {"random", test_random, nullptr, nullptr, nullptr}};
  return _cmocka_run_group_tests("unit.film.copy_runs", tests, 2, nullptr, nullptr);
}
