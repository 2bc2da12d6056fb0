// SPDX-License-Identifier: MIT
#include "worker.h"

#include <fcntl.h>
#include <sys/resource.h>

#include <cstdio>

#include "frame_file.h"

namespace farm {
namespace {

constexpr size_t kTilesInMemory = 2;  // most tiles that wait for the disk
constexpr size_t kOpenFiles = 3;
constexpr std::chrono::milliseconds kFlushPeriod(250);  // between flushes while windows are rendered

uint64_t peak_kib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<uint64_t>(usage.ru_maxrss);
}

}  // namespace

Worker::Worker(const Options& options, Stage* stage)
    : options_(options),
      stage_(stage),
      layout_(make_layout(options.width, options.height, options.window, make_identity(options, 0, 0))),
      renderer_([this] { render_jobs(); }),
      writer_([this] { write_tiles(); }) {}

Worker::~Worker() {
  stop();
}

void Worker::submit(const Message& job) {
  const std::lock_guard<std::mutex> guard(lock_);
  jobs_.push_back(job);
  changed_.notify_all();
}

bool Worker::next_event(std::chrono::microseconds wait, Event* event) {
  std::unique_lock<std::mutex> guard(lock_);
  if (!changed_.wait_for(guard, wait, [this] { return !events_.empty(); })) return false;
  *event = std::move(events_.front());
  events_.pop_front();
  return true;
}

Statistics Worker::stop() {
  {
    const std::lock_guard<std::mutex> guard(lock_);
    stopping_ = true;
    jobs_.clear();
    changed_.notify_all();
  }
  if (renderer_.joinable()) renderer_.join();
  if (writer_.joinable()) writer_.join();
  statistics_.peak_kib = peak_kib();
  return statistics_;
}

void Worker::emit(const Message& message, std::vector<char> tile) {
  const std::lock_guard<std::mutex> guard(lock_);
  events_.push_back({message, std::move(tile)});
  changed_.notify_all();
}

void Worker::fail(Message message, const char* text) {
  message.kind = Kind::kFailed;
  std::snprintf(message.text, sizeof message.text, "%s", text);
  emit(message);
}

std::shared_ptr<File> Worker::file_of(uint32_t frame) {
  const std::lock_guard<std::mutex> guard(lock_);
  std::shared_ptr<File>& file = files_[frame];
  if (!file) {
    const std::string path = part_path(frame_path(options_, frame));
    file = std::make_shared<File>(path, O_RDWR);
  }
  const std::shared_ptr<File> result = file;
  while (files_.size() > kOpenFiles) files_.erase(files_.begin());
  return result;
}

bool Worker::is_there(const Message& job) {
  std::vector<char> bytes(chunk_size(layout_, job.window));
  const size_t size = read_at(*file_of(job.frame), chunk_offset(layout_, job.window), bytes.data(), bytes.size());
  return size == bytes.size() && checksum(bytes.data(), size) == job.sum;
}

void Worker::render_job(const Message& job) {
  Message message = job;
  const Clock::time_point begin = Clock::now();
  message.unchanged = job.check && is_there(job);
  Tile tile;
  if (!message.unchanged) {
    const Pixels pixels = render_window(stage_, job.frame, window_at(layout_, job.window));
    encode_chunk(layout_, job.window, pixels, &tile.bytes);
    message.sum = checksum(tile.bytes.data(), tile.bytes.size());
  }
  message.render = seconds_since(begin);
  message.kind = Kind::kRendered;
  emit(message);
  tile.message = message;
  std::unique_lock<std::mutex> guard(lock_);
  statistics_.windows += !message.unchanged;
  statistics_.checked += message.unchanged;
  statistics_.render += message.render;
  changed_.wait(guard, [this] { return tiles_.size() < kTilesInMemory; });
  tiles_.push_back(std::move(tile));
  changed_.notify_all();
}

void Worker::render_jobs() {
  Message job{};
  for (;;) {
    {
      const Clock::time_point begin = Clock::now();
      std::unique_lock<std::mutex> guard(lock_);
      idle_ = jobs_.empty();
      if (idle_) changed_.notify_all();
      changed_.wait(guard, [this] { return stopping_ || !jobs_.empty(); });
      idle_ = false;
      statistics_.wait += seconds_since(begin);
      if (stopping_) break;
      job = jobs_.front();
      jobs_.pop_front();
    }
    try {
      render_job(job);
    } catch (const std::exception& error) {
      fail(job, error.what());
    }
  }
  const std::lock_guard<std::mutex> guard(lock_);
  rendering_ended_ = true;
  changed_.notify_all();
}

void Worker::write_tile(Tile* tile, std::vector<Message>* written) {
  Message message = tile->message;
  message.kind = Kind::kFinished;
  const Clock::time_point begin = Clock::now();
  if (options_.through_root) {
    message.tile_bytes = tile->bytes.size();
    return emit(message, std::move(tile->bytes));
  }
  if (message.unchanged) return emit(message);
  write_at(*file_of(message.frame), chunk_offset(layout_, message.window), tile->bytes.data(), tile->bytes.size());
  message.write = seconds_since(begin);
  written->push_back(message);
}

/// Flushes the files of some tiles in one call each, which is much faster than a flush for each tile.
void Worker::make_durable(std::vector<Message>* written) {
  const Clock::time_point begin = Clock::now();
  uint32_t flushed = ~0u;
  for (const Message& message : *written) {
    if (message.frame != flushed) sync_data(*file_of(message.frame));
    flushed = message.frame;
  }
  const double share = seconds_since(begin) / static_cast<double>(written->size());
  for (Message& message : *written) {
    message.write += share;
    emit(message);
    const std::lock_guard<std::mutex> guard(lock_);
    statistics_.write += message.write;
  }
  written->clear();
}

void Worker::write_tiles() {
  std::vector<Message> written;
  Clock::time_point due = Clock::now();
  for (;;) {
    Tile tile{};
    bool flush = false;
    {
      std::unique_lock<std::mutex> guard(lock_);
      const auto ready = [&] { return rendering_ended_ || !tiles_.empty() || (idle_ && !written.empty()); };
      if (written.empty()) due = Clock::now() + kFlushPeriod;
      flush = !changed_.wait_until(guard, due, ready) || tiles_.empty();
      if (rendering_ended_ && tiles_.empty() && written.empty()) return;
      if (!flush) {
        tile = std::move(tiles_.front());
        tiles_.pop_front();
        changed_.notify_all();
      }
    }
    try {
      if (!flush) write_tile(&tile, &written);
      if (!written.empty() && (flush || Clock::now() >= due)) make_durable(&written);
    } catch (const std::exception& error) {
      written.clear();
      fail(tile.message, error.what());
    }
  }
}

}  // namespace farm
