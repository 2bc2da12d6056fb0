// SPDX-License-Identifier: MIT
#include "io/file/limits.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"

namespace shd::io {

void check_extent(const Limits& limits, const char* what, uint64_t width, uint64_t height) {
  if (width == 0 || height == 0 || width > INT32_MAX || height > INT32_MAX) {
    core::refuse(SHD_ERROR_CORRUPT, "%s of %llu x %llu pixels", what, wide(width), wide(height));
  }
  if (width > kMaxSide || height > kMaxSide) {
    core::refuse(SHD_ERROR_LIMIT, "%s of %llu x %llu pixels: a side is above %llu", what, wide(width), wide(height),
                 wide(kMaxSide));
  }
  if (width * height > limits.pixels) {
    core::refuse(SHD_ERROR_LIMIT, "%s of %llu x %llu pixels is above load.max_pixels %llu", what, wide(width),
                 wide(height), wide(limits.pixels));
  }
}

void check_volume(const Limits& limits, uint64_t width, uint64_t height, uint64_t depth) {
  check_extent({limits.file_bytes, UINT64_MAX, limits.bytes, limits.ratio, limits.seconds}, "slice", width, height);
  if (depth == 0) core::refuse(SHD_ERROR_CORRUPT, "a volume of no slices");
  if (depth > kMaxSide) {
    core::refuse(SHD_ERROR_LIMIT, "a volume of %llu slices: above %llu", wide(depth), wide(kMaxSide));
  }
  if (width * height * depth > limits.pixels) {
    core::refuse(SHD_ERROR_LIMIT, "volume of %llu x %llu x %llu voxels is above load.max_pixels %llu", wide(width),
                 wide(height), wide(depth), wide(limits.pixels));
  }
}

size_t check_bytes(const Limits& limits, uint64_t pixels, size_t pixel_size, size_t file_size) {
  if (pixels > limits.pixels) {
    core::refuse(SHD_ERROR_LIMIT, "all mip levels have %llu pixels, above load.max_pixels %llu", wide(pixels),
                 wide(limits.pixels));
  }
  const uint64_t bytes = pixels * pixel_size;  // at most 4/3 * 2^32 * 16 after check_extent
  if (bytes > limits.bytes || bytes > PTRDIFF_MAX) {
    core::refuse(SHD_ERROR_LIMIT, "%llu decoded bytes are above load.max_bytes %llu", wide(bytes), wide(limits.bytes));
  }
  if (bytes > kRatioFloor && static_cast<double>(bytes) > limits.ratio * static_cast<double>(file_size)) {
    core::refuse(SHD_ERROR_LIMIT, "%llu decoded bytes from %zu are above load.max_ratio %g", wide(bytes), file_size,
                 limits.ratio);
  }
  return static_cast<size_t>(bytes);
}

Deadline::Deadline(double seconds)
    : end_(std::chrono::steady_clock::now() +
           std::chrono::milliseconds(static_cast<int64_t>(std::ceil(std::min(seconds, 1e9) * 1e3)))),
      seconds_(seconds) {}

void Deadline::check() const {
  if (std::chrono::steady_clock::now() >= end_) {
    core::refuse(SHD_ERROR_LIMIT, "decoding took longer than load.time_limit %g s", seconds_);
  }
}

int Deadline::milliseconds_left() const {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end_ - std::chrono::steady_clock::now());
  return static_cast<int>(std::clamp<int64_t>(left.count() + 1, 0, 1 << 30));
}

double Deadline::seconds_left() const {
  const std::chrono::duration<double> left = end_ - std::chrono::steady_clock::now();
  return std::max(left.count(), 0.0);
}

}  // namespace shd::io
