// SPDX-License-Identifier: MIT
#include "queue.h"

#include <cinttypes>
#include <cstdio>

namespace farm {
namespace {

void check_kept_tiles(FrameFile* file) {
  std::vector<char> bytes;
  for (uint32_t i = 0; i < file->sums.size(); ++i) {
    if (!file->journaled[i]) continue;
    bytes.resize(chunk_size(file->layout, i));
    const size_t size = read_at(file->part, chunk_offset(file->layout, i), bytes.data(), bytes.size());
    if (size == bytes.size() && checksum(bytes.data(), size) == file->sums[i]) {
      record_window(file, i, file->sums[i], true);
    } else {
      file->journaled[i] = 0;
    }
  }
}

void close_frame(Queue* queue, FrameFile* file) {
  char line[64];
  finish_frame(file);
  std::snprintf(line, sizeof line, " %016" PRIx64, picture_sum(*file));
  queue->finished.push_back(file->path + line);
  queue->open.erase(file->frame);
}

/// Opens the next frame that has work; false if there is none.
bool open_next(Queue* queue) {
  while (queue->next_frame < queue->end_frame) {
    FrameFile file = open_frame(*queue->options, queue->scene_sum, queue->next_frame++);
    const uint64_t windows = window_count(file.layout);
    queue->kept += file.complete ? windows : file.kept_count;
    if (file.complete) {
      queue->left -= windows, queue->done += windows;
      queue->finished.push_back(file.path + " was finished");
      continue;
    }
    // Ranks may have no access to the files of rank 0, which therefore checks the tiles that are there.
    if (queue->options->through_root) check_kept_tiles(&file);
    queue->left -= file.done_count, queue->done += file.done_count;
    queue->current = file.frame;
    queue->next_window = 0;
    FrameFile& kept = queue->open.emplace(file.frame, std::move(file)).first->second;
    if (kept.done_count < windows) return true;
    close_frame(queue, &kept);
  }
  return false;
}

}  // namespace

Queue make_queue(const Options& options, uint64_t scene_sum) {
  Queue queue{};
  queue.options = &options;
  queue.scene_sum = scene_sum;
  queue.next_frame = options.frame < 0 ? 0 : static_cast<uint32_t>(options.frame);
  queue.end_frame = options.frame < 0 ? options.frames : queue.next_frame + 1;
  const Layout layout = make_layout(options.width, options.height, options.window, "");
  queue.total = queue.left = uint64_t{queue.end_frame - queue.next_frame} * window_count(layout);
  queue.current = queue.end_frame;
  return queue;
}

bool next_job(Queue* queue, Message* job) {
  for (;;) {
    const auto open = queue->open.find(queue->current);
    if (open == queue->open.end()) {
      if (!open_next(queue)) return false;
      continue;
    }
    const FrameFile& file = open->second;
    while (queue->next_window < file.done.size() && file.done[queue->next_window]) queue->next_window += 1;
    if (queue->next_window == file.done.size()) {
      queue->current = queue->end_frame;
      continue;
    }
    *job = Message{};
    job->kind = Kind::kJob;
    job->frame = file.frame;
    job->window = queue->next_window++;
    job->check = file.journaled[job->window];
    job->sum = file.sums[job->window];
    queue->left -= 1;
    return true;
  }
}

void finish_job(Queue* queue, const Message& message) {
  const auto open = queue->open.find(message.frame);
  if (open == queue->open.end()) throw Failure("a window of frame " + std::to_string(message.frame) + " came too late");
  FrameFile& file = open->second;
  record_window(&file, message.window, message.sum, message.unchanged != 0);
  queue->done += 1;
  if (file.done_count == file.done.size()) close_frame(queue, &file);
}

void write_tile(Queue* queue, const Message& message, const std::vector<char>& tile) {
  const FrameFile& file = queue->open.at(message.frame);
  write_at(file.part, chunk_offset(file.layout, message.window), tile.data(), tile.size());
}

bool all_done(const Queue& queue) {
  return queue.done == queue.total;
}

}  // namespace farm
