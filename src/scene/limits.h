// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

#include "core/failure.h"

namespace shd::scene {

/// Budgets of a load, none of them 0.
struct Limits {
  uint64_t file_bytes = uint64_t{1} << 30;
  uint64_t vertices = uint64_t{1} << 26;
  uint64_t triangles = uint64_t{1} << 26;
  uint64_t nodes = uint64_t{1} << 18;
  uint64_t instances = uint64_t{1} << 18;
  uint64_t texture_bytes = uint64_t{1} << 32;
  uint64_t reader_bytes = uint64_t{1} << 32;  // memory of the process that reads
  double seconds = 60;
};

/// Throws Failure (SHD_ERROR_LIMIT) if `count` exceeds the limit of the desc's field.
inline void check_limit(const char* things, uint64_t count, const char* field, uint64_t limit) {
  if (count <= limit) return;
  core::refuse(SHD_ERROR_LIMIT, "%llu %s are above scene.%s %llu", static_cast<unsigned long long>(count), things,
               field, static_cast<unsigned long long>(limit));
}

/// The time at which a load must have finished.
class Deadline {
 public:
  explicit Deadline(double seconds) : end_(Clock::now() + span(seconds)), seconds_(seconds) {}
  double seconds_left() const { return std::chrono::duration<double>(end_ - Clock::now()).count(); }
  bool has_passed() const { return seconds_left() <= 0; }
  /// Throws Failure (SHD_ERROR_LIMIT) when the time has passed.
  void check() const {
    if (has_passed()) core::refuse(SHD_ERROR_LIMIT, "loading took longer than scene.time_limit %g s", seconds_);
  }

 private:
  using Clock = std::chrono::steady_clock;
  static Clock::duration span(double seconds) {
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(std::min(seconds, 1e9)));
  }
  Clock::time_point end_;
  double seconds_;
};

}  // namespace shd::scene
