// SPDX-License-Identifier: MIT
#include "io/maketx/bar.h"

#include <unistd.h>

#include <cstdio>

namespace {

std::string time_text(double seconds) {
  char text[48];
  const auto whole = static_cast<long>(seconds + 0.5);
  if (whole < 60) {
    std::snprintf(text, sizeof text, "%ld s", whole);
  } else if (whole < 3600) {
    std::snprintf(text, sizeof text, "%ld min %02ld s", whole / 60, whole % 60);
  } else {
    std::snprintf(text, sizeof text, "%ld h %02ld min", whole / 3600, whole / 60 % 60);
  }
  return text;
}

}  // namespace

Bar::Bar(bool quiet, uint64_t total, uint64_t done)
    : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) != 0), total_(total ? total : 1), before_(done) {}

Bar::~Bar() {
  if (drawn_) std::fputc('\n', stderr);
}

void Bar::show(uint64_t done, const std::string& what) {
  if (quiet_) return;
  const auto now = Clock::now();
  const int percent = static_cast<int>(100.0 * static_cast<double>(done) / static_cast<double>(total_));
  const bool due = terminal_ ? percent > shown_ || now - last_ > std::chrono::seconds(1) : percent / 10 > shown_ / 10;
  if (!due && shown_ >= 0) return;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double now_done = done > before_ ? static_cast<double>(done - before_) : 0;
  const double left = now_done > 0 ? seconds * static_cast<double>(total_ - done) / now_done : -1;
  shown_ = percent;
  last_ = now;
  draw(percent, left, what);
}

void Bar::draw(int percent, double left, const std::string& what) {
  const std::string rest = left < 0 ? "" : ", " + time_text(left) + " left";
  if (!terminal_) {
    std::fprintf(stderr, "shd-maketx: %s %d %%%s\n", what.c_str(), percent, rest.c_str());
    return;
  }
  std::string bar(30, '.');
  bar.replace(0, static_cast<size_t>(percent) * bar.size() / 100, static_cast<size_t>(percent) * bar.size() / 100, '#');
  std::fprintf(stderr, "\r[%s] %3d %% %s%s\033[K", bar.c_str(), percent, what.c_str(), rest.c_str());
  std::fflush(stderr);
  drawn_ = true;
}
