// SPDX-License-Identifier: MIT
#include "progress.h"

#include <unistd.h>

#include <cinttypes>

namespace farm {

void show_progress(const Queue& queue, Progress* progress) {
  const bool terminal = isatty(STDERR_FILENO);
  if (seconds_since(progress->last) < (terminal ? 1.0 : 10.0)) return;
  const double rendered = static_cast<double>(queue.done - progress->done_before);
  const double seconds = seconds_since(progress->begin);
  if (rendered == 0 && seconds < 10.0) return;  // the time left is not known yet
  progress->last = Clock::now();
  char left[32] = "unknown";
  if (rendered > 0) {
    const auto rest = static_cast<unsigned>(seconds / rendered * static_cast<double>(queue.total - queue.done));
    std::snprintf(left, sizeof left, "%u:%02u:%02u", rest / 3600, rest / 60 % 60, rest % 60);
  }
  std::fprintf(stderr, "%sshd-farm: %5.1f %%, %" PRIu64 " of %" PRIu64 " windows, time left %s%s", terminal ? "\r" : "",
               100.0 * static_cast<double>(queue.done) / static_cast<double>(queue.total), queue.done, queue.total,
               left, terminal ? "   " : "\n");
}

void open_times(const Options& options, Progress* progress) {
  if (options.times.empty()) return;
  progress->times = std::fopen(options.times.c_str(), "w");
  if (!progress->times) fail_with_errno(options.times, "cannot be opened");
  std::fputs("frame,window,rank,render_seconds,write_seconds\n", progress->times);
}

void add_times(const Message& message, Progress* progress) {
  if (!progress->times || message.unchanged) return;
  std::fprintf(progress->times, "%u,%u,%u,%.6f,%.6f\n", message.frame, message.window, message.rank, message.render,
               message.write);
}

void print_statistics(const std::vector<Statistics>& ranks, double seconds) {
  std::printf("rank  windows  checked  rendering [s]  waiting [s]  writing [s]  peak memory [MiB]\n");
  for (size_t i = 0; i < ranks.size(); ++i) {
    const Statistics& s = ranks[i];
    std::printf("%4zu %8" PRIu64 " %8" PRIu64 " %14.2f %12.2f %12.2f %18.1f\n", i, s.windows, s.checked, s.render,
                s.wait, s.write, static_cast<double>(s.peak_kib) / 1024);
  }
  std::printf("%zu ranks, %.3f s\n", ranks.size(), seconds);
}

}  // namespace farm
