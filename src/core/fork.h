// SPDX-License-Identifier: MIT
/// @file
/// The child of fork() has one thread, and memory in which the other threads of its parent stopped anywhere. These
/// classes keep that memory usable. Each library that includes this header registers one set of handlers, which end
/// with the library.
///
/// | class                       | at a fork                                                                     |
/// |-----------------------------|-------------------------------------------------------------------------------|
/// | ForkMutex                   | fork() locks it first, so that the child finds the guarded data between calls |
/// | ForkGate                    | fork() waits until no thread is inside, and nobody enters meanwhile           |
/// | ForkHook                    | a function in the child, which repairs what belonged to the other threads     |
/// | ForkCondition               | renew() in the child, because the threads that waited do not exist there      |
///
/// Rules:
/// 1. No code of the host runs under a ForkMutex or in a ForkGate: no allocator, log, executor, callback. Such code may
///    fork, or may wait for another thread that forks.
/// 2. A thread that holds a ForkMutex, or is in a ForkGate, takes only those of later levels, and at most one of each
///    level. fork() takes them in the order of levels.
/// 3. A thread attaches and detaches only while it holds no ForkMutex and is in no ForkGate.
/// 4. A lock that lives no longer than one call, on the stack or in its working memory, is a plain mutex: calls of
///    other threads do not go on in the child. Their memory and their references to objects are lost there.
/// 5. Data that changes without a lock is valid after each store, or a ForkHook repairs it.
/// 6. std::call_once of a function that may be repeated is fine: the C library begins it again in the child. Variables
///    of functions are constant-initialised, because the guard of others stays taken in the child.
#pragma once

#include <pthread.h>
#include <time.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <new>

namespace shd::core {

/// Order of locks, the outermost first.
enum class ForkLevel : uint32_t {
  kColorConfig,  // color/config.h: the transforms of a config
  kColorBuild,   // color/ocio.cpp: calls that build transforms
  kBakedViews,   // color/baked_views.h
  kImageFiles,   // io/oiio*.cpp: calls of OpenImageIO in this process
  kTileFile,     // io/oiio_tiles.cpp: readers of a file
  kTileCache,    // texture/tile/
  kTree,         // embree/tree.cpp: calls of Embree that take locks
  kObjects,      // core/object.h
  kScratch,      // core/scratch.h
  kConcurrency,  // core/executor.cpp
};
constexpr uint32_t kForkLevels = static_cast<uint32_t>(ForkLevel::kConcurrency) + 1;

class StaticForkMutex;
class StaticForkHook;

namespace detail {

/// All locks and hooks of one library. `mutex` is the outermost lock of all.
struct ForkRegistry {
  std::mutex mutex;
  std::atomic<bool> registered{false};
  std::atomic<uint32_t> forks{0};
  std::atomic<uintptr_t> forking{0};  // thread inside fork(), or 0
  uint32_t repeated = 0;              // handlers beyond the first set
  StaticForkMutex* locks[kForkLevels] = {};
  StaticForkHook* hooks = nullptr;
};
inline ForkRegistry g_fork;

void register_fork_handlers();

}  // namespace detail

/// This thread. The only thread of a child has the number of the thread that forked.
inline uintptr_t thread_number() {
  return reinterpret_cast<uintptr_t>(reinterpret_cast<void*>(pthread_self()));
}

/// Number of forks between the process that attached something first and this process.
inline uint32_t fork_generation() {
  return detail::g_fork.forks.load(std::memory_order_relaxed);
}

/// A ForkMutex with static storage: constant-initialised and never destroyed.
class StaticForkMutex {
 public:
  constexpr explicit StaticForkMutex(ForkLevel level) : level_(level) {}
  StaticForkMutex(const StaticForkMutex&) = delete;
  StaticForkMutex& operator=(const StaticForkMutex&) = delete;

  /// From now on fork() locks it. Repeated calls do nothing. Throws std::bad_alloc.
  void attach();
  void detach() noexcept;

  void lock() {
    mutex_.lock();
    owner_.store(thread_number(), std::memory_order_relaxed);
  }
  void unlock() {
    owner_.store(0, std::memory_order_relaxed);
    mutex_.unlock();
  }

 protected:
  friend class ForkCondition;
  friend struct ForkHandlers;

  std::mutex mutex_;
  std::atomic<uint32_t> inside_{0};  // threads in a ForkGate

 private:
  /// A thread that holds the mutex may fork in a signal handler: it keeps the mutex in both processes.
  void hold() {
    held_ = owner_.load(std::memory_order_relaxed) != thread_number();
    if (!held_) return;
    mutex_.lock();
    const timespec pause = {0, 100000};
    while (inside_.load(std::memory_order_acquire) != 0) ::nanosleep(&pause, nullptr);
  }
  void let_go() {
    if (held_) mutex_.unlock();
  }

  const ForkLevel level_;
  bool attached_ = false;
  bool held_ = false;  // by fork()
  std::atomic<uintptr_t> owner_{0};
  StaticForkMutex* next_ = nullptr;
};

/// A mutex for data that a child goes on using.
class ForkMutex : public StaticForkMutex {
 public:
  explicit ForkMutex(ForkLevel level) : StaticForkMutex(level) {}
  ~ForkMutex() { detach(); }
};

/// Calls of a library with locks of its own, which the child must not find taken. Static storage.
class ForkGate : public StaticForkMutex {
 public:
  using StaticForkMutex::StaticForkMutex;

  /// The gate that a thread is inside for the duration of a scope. Not nested.
  class Scope {
   public:
    explicit Scope(ForkGate& gate) : gate_(gate) {
      const std::lock_guard<std::mutex> lock(gate.mutex_);
      gate.inside_.fetch_add(1, std::memory_order_relaxed);
    }
    ~Scope() { gate_.inside_.fetch_sub(1, std::memory_order_release); }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    ForkGate& gate_;
  };
};

/// A ForkHook with static storage: constant-initialised and never destroyed.
class StaticForkHook {
 public:
  using Function = void (*)(void* data) noexcept;

  constexpr StaticForkHook() = default;
  StaticForkHook(const StaticForkHook&) = delete;
  StaticForkHook& operator=(const StaticForkHook&) = delete;

  /// From now on function(data) runs in each child, on its only thread, while fork() holds every ForkMutex. It takes
  /// none. `data` must be complete. Repeated calls do nothing. Throws std::bad_alloc.
  void attach(Function function, void* data);
  void detach() noexcept;

 private:
  friend struct ForkHandlers;
  Function function_ = nullptr;
  void* data_ = nullptr;
  StaticForkHook* next_ = nullptr;
};

/// A function that runs in each child of this process.
class ForkHook : public StaticForkHook {
 public:
  ~ForkHook() { detach(); }
};

/// A condition variable. The caller holds `mutex`; wakes may be spurious.
class ForkCondition {
 public:
  void notify_all() noexcept { condition_.notify_all(); }
  void wait(StaticForkMutex& mutex) {
    Released released(mutex);
    condition_.wait(released.lock);
  }
  /// Returns false if the time is over.
  template <class Clock, class Duration>
  bool wait_until(StaticForkMutex& mutex, const std::chrono::time_point<Clock, Duration>& end) {
    Released released(mutex);
    return condition_.wait_until(released.lock, end) == std::cv_status::no_timeout;
  }
  /// For a ForkHook. A condition variable waits in its destructor for the threads that wait.
  void renew() noexcept { new (&condition_) std::condition_variable; }

 private:
  struct Released {
    explicit Released(StaticForkMutex& held) : mutex(held), lock(held.mutex_, std::adopt_lock) {
      mutex.owner_.store(0, std::memory_order_relaxed);
    }
    ~Released() {
      mutex.owner_.store(thread_number(), std::memory_order_relaxed);
      lock.release();
    }
    StaticForkMutex& mutex;
    std::unique_lock<std::mutex> lock;
  };
  std::condition_variable condition_;
};

/// The functions that fork() calls.
struct ForkHandlers {
  static void prepare() {
    detail::ForkRegistry& all = detail::g_fork;
    if (all.forking.load(std::memory_order_relaxed) == thread_number()) {  // two threads have registered at once
      ++all.repeated;
      return;
    }
    all.mutex.lock();
    all.forking.store(thread_number(), std::memory_order_relaxed);
    for (StaticForkMutex* lock : all.locks) {
      for (; lock; lock = lock->next_) lock->hold();
    }
  }

  static void parent() { finish(false); }
  static void child() { finish(true); }

  static void finish(bool in_child) {
    detail::ForkRegistry& all = detail::g_fork;
    if (all.repeated != 0) {
      --all.repeated;
      return;
    }
    if (in_child) {
      all.forks.fetch_add(1, std::memory_order_relaxed);
      for (StaticForkHook* hook = all.hooks; hook; hook = hook->next_) hook->function_(hook->data_);
    }
    for (StaticForkMutex* lock : all.locks) {
      for (; lock; lock = lock->next_) lock->let_go();
    }
    all.forking.store(0, std::memory_order_relaxed);
    all.mutex.unlock();
  }
};

namespace detail {

/// pthread_atfork() returns after a fork() of another thread, so that no fork misses the handlers while a lock is held.
/// The handlers of a library end when it is unloaded.
inline void register_fork_handlers() {
  if (g_fork.registered.load(std::memory_order_acquire)) return;
  if (::pthread_atfork(ForkHandlers::prepare, ForkHandlers::parent, ForkHandlers::child) != 0) throw std::bad_alloc();
  g_fork.registered.store(true, std::memory_order_release);
}

template <class Node>
void remove_fork_node(Node** first, const Node* node, Node* Node::*next) {
  for (Node** at = first; *at; at = &((*at)->*next)) {
    if (*at != node) continue;
    *at = node->*next;
    return;
  }
}

}  // namespace detail

inline void StaticForkMutex::attach() {
  detail::register_fork_handlers();
  const std::lock_guard<std::mutex> lock(detail::g_fork.mutex);
  if (attached_) return;
  StaticForkMutex*& first = detail::g_fork.locks[static_cast<uint32_t>(level_)];
  next_ = first;
  first = this;
  attached_ = true;
}

inline void StaticForkMutex::detach() noexcept {
  if (!attached_) return;
  const std::lock_guard<std::mutex> lock(detail::g_fork.mutex);
  detail::remove_fork_node(&detail::g_fork.locks[static_cast<uint32_t>(level_)], this, &StaticForkMutex::next_);
  attached_ = false;
}

inline void StaticForkHook::attach(Function function, void* data) {
  detail::register_fork_handlers();
  const std::lock_guard<std::mutex> lock(detail::g_fork.mutex);
  if (function_) return;
  function_ = function;
  data_ = data;
  next_ = detail::g_fork.hooks;
  detail::g_fork.hooks = this;
}

inline void StaticForkHook::detach() noexcept {
  if (!function_) return;
  const std::lock_guard<std::mutex> lock(detail::g_fork.mutex);
  detail::remove_fork_node(&detail::g_fork.hooks, this, &StaticForkHook::next_);
  function_ = nullptr;
}

}  // namespace shd::core
