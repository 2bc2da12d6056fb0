// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace shd::frame {

/// Measures the wall-clock time of the stages of a frame.
class Stopwatch {
 public:
  /// Seconds since the previous lap, or since construction.
  double lap() {
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double> passed = now - start_;
    start_ = now;
    return passed.count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace shd::frame
