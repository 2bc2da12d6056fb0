// SPDX-License-Identifier: MIT
#include "raster/sample_pattern.h"

namespace shd::raster {
namespace {

/// Builds a pattern from positions in sixteenths of a pixel.
template <uint32_t kCount>
constexpr SamplePattern make_pattern(const int32_t (&sixteenths)[kCount][2]) {
  constexpr int32_t kScale = geometry::kSubpixels / 16;
  SamplePattern pattern = {kCount, {}, {geometry::kSubpixels, 0, geometry::kSubpixels, 0}, {}, {}, {}, {}, {}, {}};
  for (uint32_t s = 0; s < kCount; ++s) {
    const int32_t x = sixteenths[s][0] * kScale, y = sixteenths[s][1] * kScale;
    pattern.point[s] = {x, y};
    geometry::SampleExtent& e = pattern.extent;
    e = {x < e.min_x ? x : e.min_x, x > e.max_x ? x : e.max_x, y < e.min_y ? y : e.min_y, y > e.max_y ? y : e.max_y};
  }
  for (uint32_t i = 0; i < kMaxSamples; ++i) {
    const SamplePoint& point = pattern.point[i % kCount];
    pattern.x[i] = point.x;
    pattern.y[i] = point.y;
    pattern.column[i] = static_cast<int32_t>(i / kCount);
    pattern.pixel_x[i] = static_cast<double>(point.x) / geometry::kSubpixels;
    pattern.pixel_y[i] = static_cast<double>(point.y) / geometry::kSubpixels;
  }
  for (uint32_t bits = 1; bits < 256; ++bits) {
    for (uint32_t half = 0; half < 2; ++half) {
      PointSum sum = {0, 0, 0};
      for (uint32_t s = 8 * half; s < kCount && s < 8 * half + 8; ++s) {
        if (!(bits >> (s - 8 * half) & 1)) continue;
        sum = {sum.x + pattern.point[s].x, sum.y + pattern.point[s].y, sum.count + 1};
      }
      pattern.sum[half][bits] = {static_cast<int16_t>(sum.x), static_cast<int16_t>(sum.y),
                                 static_cast<int16_t>(sum.count)};
    }
  }
  return pattern;
}

constexpr int32_t kOne[1][2] = {{8, 8}};
constexpr int32_t kTwo[2][2] = {{12, 12}, {4, 4}};
constexpr int32_t kFour[4][2] = {{6, 2}, {14, 6}, {2, 10}, {10, 14}};
constexpr int32_t kEight[8][2] = {{9, 5}, {7, 11}, {13, 9}, {5, 3}, {3, 13}, {1, 7}, {11, 15}, {15, 1}};
constexpr int32_t kSixteen[16][2] = {{9, 9},  {7, 5}, {5, 10}, {12, 7}, {3, 6}, {10, 13}, {13, 11}, {11, 3},
                                     {6, 14}, {8, 1}, {4, 2},  {2, 12}, {0, 8}, {15, 4},  {14, 15}, {1, 0}};
constexpr SamplePattern kPatterns[] = {make_pattern(kOne), make_pattern(kTwo), make_pattern(kFour),
                                       make_pattern(kEight), make_pattern(kSixteen)};

}  // namespace

const SamplePattern& sample_pattern(uint32_t count) {
  uint32_t row = 0;
  while (kPatterns[row].count != count) ++row;
  return kPatterns[row];
}

}  // namespace shd::raster
