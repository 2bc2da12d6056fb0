// SPDX-License-Identifier: MIT
// Locks, gates, hooks and conditions at a fork, and the caches of decoded blocks that other threads used.
#include "core/fork.h"

#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <thread>

#include "core/cache_pool.h"
#include "support/check.h"

namespace shd::tests {
namespace {

using core::ForkLevel;

/// Runs `body` in a child and returns its result; a hang ends the child by signal. 256 = it ended by signal.
template <class Body>
int in_child(Body&& body) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::alarm(5);
    ::_exit(body());
  }
  int status = 0;
  assert_true(child > 0 && ::waitpid(child, &status, 0) == child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 256;
}

/// A thread that does `inside` between two points, and stays there until the end of the scope unless it need not.
class Other {
 public:
  template <class Body>
  explicit Other(Body&& body) : thread_([this, body] { body(*this); }) {
    while (!inside_) std::this_thread::yield();
  }
  ~Other() {
    leave_ = true;
    thread_.join();
  }
  void enter() { inside_ = true; }
  void stay() {
    while (!leave_) std::this_thread::yield();
  }

 private:
  std::atomic<bool> inside_{false}, leave_{false};
  std::thread thread_;
};

void wait_a_moment() {
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
}

/// The child finds what a lock guards between two changes, although another thread was changing it.
void test_mutex(void**) {
  core::ForkMutex outer(ForkLevel::kColorConfig), inner(ForkLevel::kObjects);
  int first = 0, second = 0;
  outer.attach();
  inner.attach();
  Other other([&](Other& self) {
    const std::lock_guard<core::ForkMutex> outer_lock(outer);
    const std::lock_guard<core::ForkMutex> inner_lock(inner);
    first = 1;
    self.enter();
    wait_a_moment();
    second = 1;
  });
  assert_int_equal(in_child([&] {
                     const std::lock_guard<core::ForkMutex> outer_lock(outer);
                     const std::lock_guard<core::ForkMutex> inner_lock(inner);
                     return first == second ? 0 : 1;
                   }),
                   0);
  const std::lock_guard<core::ForkMutex> lock(inner);  // the parent's is free as well
}

/// A thread that holds a lock may fork: it holds the lock in both processes.
void test_own(void**) {
  core::ForkMutex mutex(ForkLevel::kObjects);
  mutex.attach();
  mutex.lock();
  assert_int_equal(in_child([&] {
                     mutex.unlock();
                     mutex.lock();
                     return 0;
                   }),
                   0);
  mutex.unlock();
  assert_int_equal(in_child([&] {
                     mutex.lock();
                     return 0;
                   }),
                   0);
}

core::ForkGate g_gate(ForkLevel::kImageFiles);

void test_gate(void**) {
  std::atomic<bool> left{false};
  g_gate.attach();
  g_gate.attach();
  Other other([&](Other& self) {
    const core::ForkGate::Scope inside(g_gate);
    self.enter();
    wait_a_moment();
    left = true;
  });
  assert_int_equal(in_child([&] {
                     const core::ForkGate::Scope inside(g_gate);
                     return left ? 0 : 1;
                   }),
                   0);
  assert_true(left);
  const core::ForkGate::Scope inside(g_gate);
}

void test_hook(void**) {
  static int calls;
  const uint32_t generation = core::fork_generation();
  {
    core::ForkHook hook;
    hook.attach([](void* data) noexcept { ++*static_cast<int*>(data); }, &calls);
    assert_int_equal(in_child([&] { return calls + 10 * static_cast<int>(core::fork_generation() - generation); }), 11);
    assert_int_equal(in_child([&] { return in_child([] { return calls; }); }), 2);
  }
  assert_int_equal(in_child([] { return calls; }), 0);
  assert_int_equal(calls, 0);
  assert_int_equal(core::fork_generation(), generation);
}

/// Another thread waits; the child wakes nobody, waits on its own, and destroys the condition.
void test_condition(void**) {
  core::ForkMutex mutex(ForkLevel::kTileCache);
  auto condition = std::make_unique<core::ForkCondition>();
  core::ForkHook hook;
  bool ready = false;
  mutex.attach();
  hook.attach([](void* data) noexcept { static_cast<core::ForkCondition*>(data)->renew(); }, condition.get());
  Other other([&](Other& self) {
    const std::lock_guard<core::ForkMutex> lock(mutex);
    self.enter();
    while (!ready) condition->wait(mutex);
  });
  wait_a_moment();
  assert_int_equal(in_child([&] {
                     bool woken = false;
                     std::thread waiter([&] {
                       const std::lock_guard<core::ForkMutex> lock(mutex);
                       while (!ready) condition->wait(mutex);
                       woken = true;
                     });
                     wait_a_moment();
                     {
                       const std::lock_guard<core::ForkMutex> lock(mutex);
                       const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(1);
                       while (condition->wait_until(mutex, end)) {
                       }
                       ready = true;
                       condition->notify_all();
                     }
                     waiter.join();
                     hook.detach();
                     condition.reset();
                     return woken ? 0 : 1;
                   }),
                   0);
  const std::lock_guard<core::ForkMutex> lock(mutex);
  ready = true;
  condition->notify_all();
}

/// Objects with locks come and go on other threads.
void test_attach(void**) {
  std::atomic<bool> end{false};
  const auto churn = [&] {
    while (!end) {
      core::ForkMutex mutex(ForkLevel::kScratch);
      core::ForkHook hook;
      mutex.attach();
      hook.attach([](void*) noexcept {}, nullptr);
      const std::lock_guard<core::ForkMutex> lock(mutex);
    }
  };
  std::thread threads[2] = {std::thread(churn), std::thread(churn)};
  for (int i = 0; i < 30; ++i) {
    assert_int_equal(in_child([] {
                       core::ForkMutex mutex(ForkLevel::kScratch);
                       mutex.attach();
                       mutex.lock();
                       mutex.unlock();
                       return 0;
                     }),
                     0);
  }
  end = true;
  for (std::thread& thread : threads) thread.join();
}

/// The child has every slot, except those that its thread holds, and takes no content of another thread.
void test_caches(void**) {
  const core::Allocator host{core::default_allocator()};
  core::CachePool pool(host, true, core::kCacheSize);
  const uint64_t owner = pool.new_owner(), mine = pool.new_owner();
  const core::CachePool::Lease kept = pool.take(mine);
  std::optional<Other> other(std::in_place, [&](Other& self) {
    core::CachePool::Lease leases[core::CachePool::kMost];
    for (auto& lease : leases) lease = pool.take(owner);
    self.enter();
    self.stay();
    for (const auto& lease : leases) {
      if (lease.memory) pool.put(lease);
    }
  });
  assert_int_equal(in_child([&] {
                     int taken = 0;
                     core::CachePool::Lease leases[core::CachePool::kMost];
                     for (auto& lease : leases) {
                       lease = pool.take(owner);
                       if (lease.left_by_owner || lease.memory == kept.memory) return 100;
                       taken += lease.memory != nullptr;
                     }
                     for (const auto& lease : leases) {
                       if (lease.memory) pool.put(lease);
                     }
                     pool.put(kept);
                     pool.trim();
                     return taken;
                   }),
                   static_cast<int>(core::CachePool::kMost) - 1);
  assert_null(pool.take(owner).memory);
  pool.put(kept);
  other.reset();
  pool.trim();
}

}  // namespace
}  // namespace shd::tests

int main() {
  using namespace shd::tests;
  const CMUnitTest tests[] = {
      {"mutex", test_mutex, nullptr, nullptr, nullptr},         {"mutex/own", test_own, nullptr, nullptr, nullptr},
      {"gate", test_gate, nullptr, nullptr, nullptr},           {"hook", test_hook, nullptr, nullptr, nullptr},
      {"condition", test_condition, nullptr, nullptr, nullptr}, {"attach", test_attach, nullptr, nullptr, nullptr},
      {"cache_pool", test_caches, nullptr, nullptr, nullptr},
  };
  return _cmocka_run_group_tests("unit.core.fork", tests, sizeof tests / sizeof tests[0], nullptr, nullptr);
}
