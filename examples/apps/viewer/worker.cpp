// SPDX-License-Identifier: MIT
#include "worker.h"

#include <chrono>

namespace viewer {
namespace {

constexpr double kPatience = 0.25;               // a rendering that runs for longer gives way to a new state [s]
constexpr int64_t kReportInterval = 50'000'000;  // [ns]

int64_t now() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

/// The first frame, and frames whose predecessor took long for its number of pixels.
bool takes_long(const Picture* previous, const State& state) {
  if (!previous || !previous->side[0] || previous->cancelled) return true;
  const Image& image = *previous->side[0];
  const double pixels = double(state.width) * state.height / (double(image.width) * image.height);
  return image.seconds * pixels > kPatience;
}

}  // namespace

Worker::Worker(uint32_t workers, std::function<void()> changed)
    : changed_(std::move(changed)), thread_([this, workers] { run(workers); }) {}

Worker::~Worker() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_ending_ = true;
    stop_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void Worker::ask(const State& state, bool is_preview) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_ = state;
    is_next_preview_ = is_preview;
    if (is_busy_ && !is_preview_ && static_cast<double>(now() - start_) * 1e-9 > kPatience) stop_ = true;
  }
  wake_.notify_all();
}

void Worker::cancel() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_busy_) stop_ = true;
}

std::shared_ptr<const Picture> Worker::latest() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return latest_;
}

std::shared_ptr<const Picture> Worker::wait() {
  std::unique_lock<std::mutex> lock(mutex_);
  idle_.wait(lock, [this] { return !is_busy_ && !waiting_; });
  return latest_;
}

std::vector<Display> Worker::displays() {
  std::unique_lock<std::mutex> lock(mutex_);
  idle_.wait(lock, [this] { return is_ready_; });
  return displays_;
}

bool Worker::is_busy() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return is_busy_ || waiting_;
}

double Worker::seconds() const {
  return static_cast<double>(now() - start_) * 1e-9;
}

shd_result Worker::report(float fraction, void* user_data) {
  auto* const self = static_cast<Worker*>(user_data);
  self->progress_ = fraction;
  const int64_t time = now();
  if (time - self->last_report_ > kReportInterval) {
    self->last_report_ = time;
    self->changed_();
  }
  return self->stop_ ? SHD_ERROR_CANCELLED : SHD_OK;
}

std::shared_ptr<const Picture> Worker::make_picture(Stage* stage, const State& state, const Picture* previous) {
  auto picture = std::make_shared<Picture>();
  if (stage) {
    Tiles* const tiles = takes_long(previous, state) ? &tiles_ : nullptr;
    *picture = stage->show(state, {report, this}, previous, tiles);
  } else {
    picture->error = stage_error_;
  }
  picture->state = state;
  // A stopped rendering leaves the window as it was.
  if (picture->cancelled && previous) {
    *picture = *previous;
    picture->state = state;
    picture->cancelled = true;
  }
  return picture;
}

void Worker::run(uint32_t workers) {
  std::unique_ptr<Stage> stage;
  try {
    stage = std::make_unique<Stage>(workers);
  } catch (const std::exception& error) {
    stage_error_ = error.what();
  }
  std::unique_lock<std::mutex> lock(mutex_);
  if (stage) displays_ = stage->displays();
  is_ready_ = true;
  idle_.notify_all();
  for (;;) {
    wake_.wait(lock, [this] { return waiting_ || is_ending_; });
    if (is_ending_) return;
    const State state = *waiting_;
    waiting_.reset();
    is_busy_ = true;
    is_preview_ = is_next_preview_;
    stop_ = false;
    progress_ = 0.0f;
    start_ = now();
    const std::shared_ptr<const Picture> previous = latest_;
    lock.unlock();
    const std::shared_ptr<const Picture> picture = make_picture(stage.get(), state, previous.get());
    lock.lock();
    tiles_.end();
    latest_ = picture;
    is_busy_ = false;
    idle_.notify_all();
    lock.unlock();
    changed_();
    lock.lock();
  }
}

}  // namespace viewer
