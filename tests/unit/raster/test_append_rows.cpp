// SPDX-License-Identifier: MIT
// Rows of fragments made from runs of pixels, and slots of a tile cleared.
#include "support/check.h"

#include <algorithm>
#include <vector>

#include "raster/append_rows.h"
#include "raster/tile_words.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {
namespace {

using raster::Fragments;
using raster::kBatch;
using raster::kTile;
using raster::kTilePixels;
using raster::PixelRun;

const core::Allocator g_allocator = {core::default_allocator()};

/// Compares rows begin..count - 1 with the pixels of some runs, bit by bit.
void check_rows(const Fragments& f, size_t begin, const std::vector<PixelRun>& runs, uint32_t triangle) {
  size_t row = begin;
  for (const PixelRun& run : runs) {
    for (uint32_t pixel = run.begin; pixel < run.end; ++pixel, ++row) {
      const auto column = static_cast<int32_t>(pixel % kTile), line = static_cast<int32_t>(pixel / kTile);
      assert_int_equal(f.pixel[row], pixel);
      assert_int_equal(f.mask[row], run.mask);
      assert_int_equal(f.triangle[row], triangle);
      assert_true(f.x[row] == (static_cast<float>(f.left) + 0.5f) + static_cast<float>(column));
      assert_true(f.y[row] == (static_cast<float>(f.top) + 0.5f) + static_cast<float>(line));
    }
  }
  assert_int_equal(f.count, row);
}

void test_rows(void**) {
  Fragments f;
  raster::allocate(g_allocator, &f);
  const int32_t corners[][2] = {{0, 0}, {-640, 128}, {16777216, -8388608}, {1 << 24 | 64, 33}};
  for_each_target([&](const core::SimdTarget& target, bool) {
    Random random = {2};
    for (int k = 0; k < 400; ++k) {
      f.left = corners[k % 4][0], f.top = corners[k % 4][1];
      f.count = 0;
      std::vector<PixelRun> before, runs;
      size_t room = kBatch;
      for (std::vector<PixelRun>* list : {&before, &runs}) {
        for (int j = random.whole(0, 9); j > 0 && room > 0; --j) {
          const auto begin = static_cast<uint32_t>(random.whole(0, kTilePixels - 1));
          const size_t length = std::min({room, kTilePixels - begin, static_cast<size_t>(random.whole(1, 200))});
          list->push_back({static_cast<uint16_t>(begin), static_cast<uint16_t>(begin + length),
                           static_cast<uint32_t>(random.whole(1, 0xffff))});
          room -= length;
        }
      }
      raster::append_rows(target, before.data(), before.size(), 7, &f);
      const size_t first = f.count;
      raster::append_rows(target, runs.data(), runs.size(), 0x80000001u, &f);
      check_rows(f, first, runs, 0x80000001u);
      f.count = first;
      check_rows(f, 0, before, 7);
    }
    f.count = 0;
    const std::vector<PixelRun> all = {{100, 100 + kBatch, 3}};
    raster::append_rows(target, all.data(), 1, 5, &f);
    check_rows(f, 0, all, 5);
  });
}

void test_clear(void**) {
  for (uint32_t samples : {1u, 2u, 4u, 16u}) {
    raster::Tile tile;
    raster::allocate(g_allocator, samples, &tile);
    for_each_target([&](const core::SimdTarget& target, bool) {
      std::fill(tile.slot.begin(), tile.slot.end(), 3u);
      raster::clear_slots(target, &tile);
      for (uint32_t slot : tile.slot) assert_int_equal(slot, raster::kNoSlot);
    });
  }
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  const CMUnitTest tests[] = {{"rows", test_rows, nullptr, nullptr, nullptr},
                              {"clear", test_clear, nullptr, nullptr, nullptr}};
  return _cmocka_run_group_tests("unit.raster.append_rows", tests, 2, nullptr, nullptr);
}
