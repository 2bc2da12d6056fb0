// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

namespace shd::io {

/// Largest width and height of a shd_image [pixels].
constexpr uint64_t kMaxSide = 65536;

/// Budgets of a load; none of them is 0.
struct Limits {
  uint64_t file_bytes = uint64_t{1} << 30;
  uint64_t pixels = uint64_t{1} << 28;
  uint64_t bytes = uint64_t{1} << 32;
  double ratio = 4000;  // decoded bytes per file byte
  double seconds = 60;
  // Textures as they are stored have further limits.
  uint64_t side = kMaxSide;
  uint64_t texels = uint64_t{1} << 28;
};

/// Decoded sizes below this limit are exempt from limits.ratio [bytes].
constexpr uint64_t kRatioFloor = uint64_t{1} << 24;

/// A number for "%llu".
inline unsigned long long wide(uint64_t value) {
  return static_cast<unsigned long long>(value);
}

/// Throws Failure unless a window of this size is within the budgets. `what` names the window in the message.
void check_extent(const Limits& limits, const char* what, uint64_t width, uint64_t height);

/// Throws Failure unless each side of a volume is 1..kMaxSide and its voxels are at most limits.pixels.
void check_volume(const Limits& limits, uint64_t width, uint64_t height, uint64_t depth);

/// Size in bytes of all levels of a bitmap, `pixels` in total, after check_extent() of its base. Throws Failure beyond
/// limits.pixels, limits.bytes or limits.ratio.
size_t check_bytes(const Limits& limits, uint64_t pixels, size_t pixel_size, size_t file_size);

/// The time at which a load must be finished.
class Deadline {
 public:
  explicit Deadline(double seconds);
  /// Throws Failure (SHD_ERROR_LIMIT) if the deadline has passed.
  void check() const;
  /// Time until the deadline, rounded up; 0 if it has passed [ms].
  int milliseconds_left() const;
  /// Time until the deadline; 0 if it has passed [s].
  double seconds_left() const;

 private:
  std::chrono::steady_clock::time_point end_;
  double seconds_;
};

}  // namespace shd::io
