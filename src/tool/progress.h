// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <cstdint>

#include <shd/render.h>

/// Progress of all pictures and the remaining time, written to stderr if the work takes longer than a moment.
class Progress {
 public:
  /// Without `wanted` nothing is written.
  Progress(bool wanted, uint32_t pictures) : wanted_(wanted), pictures_(pictures) {}
  ~Progress() { finish(); }
  /// For shd_render_desc.progress of picture number `picture`, from 0.
  shd_progress of_picture(uint32_t picture);
  /// Ends the line. The destructor does this, too.
  void finish();

 private:
  static shd_result report(float fraction, void* user_data);
  using Clock = std::chrono::steady_clock;

  bool wanted_;
  uint32_t pictures_, picture_ = 0;
  int shown_ = -1;
  Clock::time_point start_ = Clock::now();
};
