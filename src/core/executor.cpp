// SPDX-License-Identifier: MIT
#include "core/executor.h"

#ifdef SHD_WITH_TBB
#include <algorithm>
#include <atomic>

#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include "core/fork.h"
#endif

namespace shd::core {
namespace {

shd_result serial_parallel_for(void*, uint32_t count, shd_task_fn task, void* task_data) {
  for (uint32_t i = 0; i < count; ++i) task(task_data, i, 0);
  return SHD_OK;
}

#ifdef SHD_WITH_TBB
/// Generation + 1 of the process that ran the first tasks on oneTBB, or 0. Later generations never call oneTBB: its
/// threads do not exist there, and one of its locks may be taken for ever.
std::atomic<uint32_t> g_first_use{0};

bool may_use_tbb() noexcept {
  const uint32_t first = g_first_use.load(std::memory_order_relaxed);
  return first == 0 || first == fork_generation() + 1;
}

/// Returns the number of threads of oneTBB, or 1 in a process that must not call oneTBB. Throws std::bad_alloc.
uint32_t most_workers() {
  static StaticForkMutex mutex(ForkLevel::kConcurrency);
  if (!may_use_tbb()) return 1;
  mutex.attach();
  const std::lock_guard<StaticForkMutex> lock(mutex);
  return static_cast<uint32_t>(tbb::info::default_concurrency());
}

/// The memory of an arena. The arena is destroyed only by the process that made it: in a child, oneTBB would wait.
union ArenaMemory {
  explicit ArenaMemory(int workers) : arena(workers) {}
  ~ArenaMemory() {}
  tbb::task_arena arena;
};

struct Arena {
  explicit Arena(int workers) : memory(workers), generation(fork_generation()) {}
  ~Arena() {
    if (generation == fork_generation()) memory.arena.~task_arena();
  }
  ArenaMemory memory;
  const uint32_t generation;
};

/// Distributes the tasks of one parallel_for.
struct Queue {
  uint32_t count;
  shd_task_fn task;
  void* task_data;
  std::atomic<uint32_t> next{0};

  void drain(uint32_t worker) noexcept {
    for (uint32_t i; (i = next.fetch_add(1, std::memory_order_relaxed)) < count;) task(task_data, i, worker);
  }
};

shd_result tbb_parallel_for(void* user_data, uint32_t count, shd_task_fn task, void* task_data) {
  auto* body = static_cast<Arena*>(user_data);
  tbb::task_arena& arena = body->memory.arena;
  Queue queue{count, task, task_data};
  if (body->generation != fork_generation()) {
    queue.drain(0);
    return SHD_OK;
  }
  uint32_t first = g_first_use.load(std::memory_order_relaxed);
  if (first == 0) g_first_use.compare_exchange_strong(first, body->generation + 1, std::memory_order_relaxed);
  try {
    const auto drain = [&](uint32_t) {
      queue.drain(static_cast<uint32_t>(tbb::this_task_arena::current_thread_index()));
    };
    const uint32_t drains = std::min(count, static_cast<uint32_t>(arena.max_concurrency()));
    // Isolated: a nested call that waits must not run tasks of the outer call, whose scratch memory is in use.
    arena.execute([&] {
      tbb::this_task_arena::isolate([&] { tbb::parallel_for(uint32_t{0}, drains, drain, tbb::simple_partitioner()); });
    });
  } catch (...) {
    // Tasks do not throw: an exception means that oneTBB could not start a thread or had no memory. oneTBB waits for
    // all started tasks before it throws.
    queue.drain(0);
  }
  return SHD_OK;
}
#endif

}  // namespace

void* create_executor(const Allocator& allocator, uint32_t worker_count, shd_executor* out) {
  *out = {serial_parallel_for, nullptr, 1};
#ifdef SHD_WITH_TBB
  // oneTBB has no more threads than default_concurrency(), and prints a warning to stderr for larger requests.
  const uint32_t max_workers = most_workers();
  if (worker_count == 0 || worker_count > max_workers) worker_count = max_workers;
  if (worker_count <= 1) return nullptr;
  Arena* arena = create<Arena>(allocator, static_cast<int>(worker_count));
  *out = {tbb_parallel_for, arena, worker_count};
  return arena;
#else
  (void)allocator;
  (void)worker_count;
  return nullptr;
#endif
}

void destroy_executor(const Allocator& allocator, void* body) noexcept {
#ifdef SHD_WITH_TBB
  destroy(allocator, static_cast<Arena*>(body));
#else
  (void)allocator;
  (void)body;
#endif
}

}  // namespace shd::core
