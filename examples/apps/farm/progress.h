// SPDX-License-Identifier: MIT
// Lines for people and files of figures.
#ifndef SHD_FARM_PROGRESS_H
#define SHD_FARM_PROGRESS_H

#include <cstdio>
#include <vector>

#include "frame_file.h"
#include "messages.h"
#include "queue.h"

namespace farm {

struct Progress {
  Clock::time_point begin = Clock::now(), last{};
  uint64_t done_before = 0;  // windows that were kept
  std::FILE* times = nullptr;
};

/// Shows the part that is done and the time left, every second on a terminal and every 10 s elsewhere.
void show_progress(const Queue& queue, Progress* progress);

void open_times(const Options& options, Progress* progress);  // throws Failure
void add_times(const Message& message, Progress* progress);

/// One row for each rank, and the time and memory of the job.
void print_statistics(const std::vector<Statistics>& ranks, double seconds);

}  // namespace farm

#endif  // SHD_FARM_PROGRESS_H
