// SPDX-License-Identifier: MIT
// The windows of all frames in the order in which they are handed out. Rank 0 owns it; its memory depends on the frames
// in progress, not on the pixels.
#ifndef SHD_FARM_QUEUE_H
#define SHD_FARM_QUEUE_H

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "frame_file.h"
#include "messages.h"

namespace farm {

struct Queue {
  const Options* options;
  uint64_t scene_sum;
  uint32_t next_frame, end_frame;
  uint32_t next_window = 0;
  uint32_t current = 0;                // frame of next_window, if it is in `open`
  std::map<uint32_t, FrameFile> open;  // begun and not finished
  uint64_t left = 0;                   // windows that are not handed out
  uint64_t total = 0, done = 0, kept = 0;
  std::vector<std::string> finished;  // a line for each finished picture
};

Queue make_queue(const Options& options, uint64_t scene_sum);

/// The next window to render. False if all are handed out. Opens files; throws Failure.
bool next_job(Queue* queue, Message* job);

/// Keeps a finished window, and the file if it was the last one.
void finish_job(Queue* queue, const Message& message);

/// Writes a tile that came with kFinished.
void write_tile(Queue* queue, const Message& message, const std::vector<char>& tile);

bool all_done(const Queue& queue);

}  // namespace farm

#endif  // SHD_FARM_QUEUE_H
