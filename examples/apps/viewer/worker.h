// SPDX-License-Identifier: MIT
/// Renders on a thread of its own, so that the window answers while a heavy frame is drawn. No SDL, no ImGui.
#pragma once
#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "stage.h"

namespace viewer {

class Worker {
 public:
  /// `changed` runs on the worker's thread after each picture, and now and then while it renders.
  Worker(uint32_t workers, std::function<void()> changed);
  ~Worker();

  /// Asks for a picture. It replaces a state that is still waiting, and stops a rendering that runs for long already,
  /// except that of a preview: a sequence of previews would never show one.
  void ask(const State& state, bool is_preview = false);

  /// Stops the current rendering. Its picture has `cancelled` set.
  void cancel();

  /// The last picture; null before the first one.
  std::shared_ptr<const Picture> latest() const;

  /// Waits until nothing is asked for, and returns the last picture.
  std::shared_ptr<const Picture> wait();

  /// Displays of Stage::displays(). Waits until the stage exists.
  std::vector<Display> displays();

  bool is_busy() const;

  /// Finished tiles of a frame that takes long.
  const Tiles& tiles() const { return tiles_; }

  /// Finished part of the current rendering, 0..1, and the seconds since it began.
  float progress() const { return progress_.load(); }
  double seconds() const;

 private:
  void run(uint32_t workers);
  std::shared_ptr<const Picture> make_picture(Stage* stage, const State& state, const Picture* previous);
  static shd_result report(float fraction, void* user_data);

  std::function<void()> changed_;
  std::string stage_error_;  // "" = the stage exists; only the worker's thread uses it
  mutable std::mutex mutex_;
  std::condition_variable wake_, idle_;
  std::optional<State> waiting_;
  std::shared_ptr<const Picture> latest_;
  std::vector<Display> displays_;
  Tiles tiles_;
  bool is_ready_ = false, is_busy_ = false, is_ending_ = false;
  bool is_preview_ = false, is_next_preview_ = false;  // kind of the current rendering, kind of the waiting one
  std::atomic<bool> stop_{false};
  std::atomic<float> progress_{0.0f};
  std::atomic<int64_t> start_{0}, last_report_{0};  // [ns]
  std::thread thread_;                              // the last member: it uses the others
};

}  // namespace viewer
