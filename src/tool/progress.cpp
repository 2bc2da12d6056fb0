// SPDX-License-Identifier: MIT
#include "tool/progress.h"

#include <cstdio>

shd_progress Progress::of_picture(uint32_t picture) {
  picture_ = picture;
  return wanted_ ? shd_progress{report, this} : shd_progress{nullptr, nullptr};
}

void Progress::finish() {
  if (shown_ >= 0) std::fputc('\n', stderr);
  shown_ = -1;
}

shd_result Progress::report(float fraction, void* user_data) {
  Progress& self = *static_cast<Progress*>(user_data);
  const double done = (self.picture_ + static_cast<double>(fraction)) / self.pictures_;
  const double seconds = std::chrono::duration<double>(Clock::now() - self.start_).count();
  const int percent = static_cast<int>(100.0 * done);
  if (percent <= self.shown_ || (self.shown_ < 0 && seconds < 0.5)) return SHD_OK;
  const double left = done > 0.0 ? seconds / done - seconds : 0.0;
  if (self.pictures_ > 1) std::fprintf(stderr, "\rpicture %u of %u, ", self.picture_ + 1, self.pictures_);
  std::fprintf(stderr, "%srendering %3d %%, %.0f s left   ", self.pictures_ > 1 ? "" : "\r", percent, left);
  std::fflush(stderr);
  self.shown_ = percent;
  return SHD_OK;
}
