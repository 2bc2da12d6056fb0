// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <cstdint>
#include <string>

/// Progress on stderr: a bar that is redrawn on a terminal, otherwise a line for each tenth.
class Bar {
 public:
  /// @param done  work that an earlier run has done, which does not count for the time left
  Bar(bool quiet, uint64_t total, uint64_t done);
  ~Bar();
  /// `what` names the current step.
  void show(uint64_t done, const std::string& what);

 private:
  using Clock = std::chrono::steady_clock;
  void draw(int percent, double left, const std::string& what);

  bool quiet_, terminal_, drawn_ = false;
  uint64_t total_, before_;
  int shown_ = -1;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};
