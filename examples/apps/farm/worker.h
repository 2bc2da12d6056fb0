// SPDX-License-Identifier: MIT
// Renders windows on one thread and writes their tiles on another one, without MPI. The thread that owns the worker
// sends its events on.
#ifndef SHD_FARM_WORKER_H
#define SHD_FARM_WORKER_H

#include <chrono>
#include <condition_variable>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "exr_layout.h"
#include "messages.h"
#include "part_file.h"
#include "stage.h"

namespace farm {

struct Event {
  Message message;
  std::vector<char> tile;  // kFinished with --through-root
};

class Worker {
 public:
  Worker(const Options& options, Stage* stage);
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void submit(const Message& job);
  /// Waits for an event. False if there is none after this time.
  bool next_event(std::chrono::microseconds wait, Event* event);
  /// Ends after the windows in progress; jobs that have not begun are dropped.
  Statistics stop();

 private:
  struct Tile {
    Message message;
    std::vector<char> bytes;
  };

  void render_jobs();
  void render_job(const Message& job);
  void write_tiles();
  void write_tile(Tile* tile, std::vector<Message>* written);
  void make_durable(std::vector<Message>* written);
  bool is_there(const Message& job);
  void emit(const Message& message, std::vector<char> tile = {});
  void fail(Message message, const char* text);
  std::shared_ptr<File> file_of(uint32_t frame);

  const Options& options_;
  Stage* const stage_;
  const Layout layout_;
  std::mutex lock_;  // guards the following fields
  std::condition_variable changed_;
  std::deque<Message> jobs_;
  std::deque<Tile> tiles_;
  std::deque<Event> events_;
  std::map<uint32_t, std::shared_ptr<File>> files_;
  Statistics statistics_{};
  bool stopping_ = false, rendering_ended_ = false, idle_ = false;
  std::thread renderer_, writer_;
};

}  // namespace farm

#endif  // SHD_FARM_WORKER_H
