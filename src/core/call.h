// SPDX-License-Identifier: MIT
/// @file
/// The calls of a thread inside shd: functions of the API that have not returned, and callbacks that they run. Tasks of
/// parallel_for() are parts of the call that made them, on any thread. A callback may release objects that the calls
/// around it use: such a reference is dropped when the outermost function returns.
#pragma once

#include <atomic>
#include <cstdint>

namespace shd::core {

struct Object;

/// A callback that fills texels for a call, and may call shd. It lies on the stack of its thread.
struct Callback {
  const Callback* outer = nullptr;  // callback whose call runs this one
  uint64_t number = 0;              // later callbacks have larger numbers; never 0
  bool loads_tiles = false;         // it is a TileLoad (texture/store/tiles/load.h)
};

/// State of a thread.
struct Call {
  uint32_t depth = 0;                  // functions of the API that have not returned
  const Callback* callback = nullptr;  // innermost callback that has not returned
  Object* postponed = nullptr;         // references to drop when the outermost function returns
};
inline thread_local Call t_call;

/// Returns t_call. In a shared library its address takes a call: compilers repeat this call at each use of t_call, but
/// keep the result of this function.
Call& this_call() noexcept;

/// Drops the references that callbacks of this thread have released. The text of the latest failure stays.
void drop_postponed() noexcept;

/// A function of the API.
class CallScope {
 public:
  CallScope() : call_(this_call()) { ++call_.depth; }
  ~CallScope() {
    if (--call_.depth == 0 && call_.postponed) drop_postponed();
  }
  CallScope(const CallScope&) = delete;
  CallScope& operator=(const CallScope&) = delete;

 private:
  Call& call_;
};

/// A callback, for its duration.
class CallbackScope {
 public:
  explicit CallbackScope(Callback* callback);
  ~CallbackScope() { t_call.callback = callback_.outer; }
  CallbackScope(const CallbackScope&) = delete;
  CallbackScope& operator=(const CallbackScope&) = delete;

 private:
  const Callback& callback_;
};

/// The call of a parallel_for(), which its tasks continue.
class SharedCall {
 public:
  SharedCall() : depth_(t_call.depth), callback_(t_call.callback) {}
  /// Takes over what the tasks have postponed.
  ~SharedCall();
  SharedCall(const SharedCall&) = delete;
  SharedCall& operator=(const SharedCall&) = delete;

 private:
  friend class TaskScope;
  const uint32_t depth_;
  const Callback* const callback_;
  std::atomic<Object*> postponed_{nullptr};
};

/// A task of parallel_for().
class TaskScope {
 public:
  explicit TaskScope(SharedCall* shared) : shared_(*shared), before_(t_call) {
    t_call = {shared_.depth_, shared_.callback_, nullptr};
  }
  ~TaskScope();
  TaskScope(const TaskScope&) = delete;
  TaskScope& operator=(const TaskScope&) = delete;

 private:
  SharedCall& shared_;
  const Call before_;
};

/// Returns true if a reference is dropped later, because a callback releases an object that is older than itself.
bool postpone_release(Object* object) noexcept;

}  // namespace shd::core
