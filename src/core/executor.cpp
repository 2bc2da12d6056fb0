// SPDX-License-Identifier: MIT
#include "core/executor.h"

#ifdef SHD_WITH_TBB
#include <unistd.h>

#include <algorithm>
#include <atomic>

#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>
#endif

namespace shd::core {
namespace {

shd_result serial_parallel_for(void*, uint32_t count, shd_task_fn task, void* task_data) {
  for (uint32_t i = 0; i < count; ++i) task(task_data, i, 0);
  return SHD_OK;
}

#ifdef SHD_WITH_TBB
struct Arena {
  explicit Arena(int workers) : arena(workers), process(getpid()) {}
  tbb::task_arena arena;
  const pid_t process;  // threads do not survive a fork
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
  tbb::task_arena& arena = body->arena;
  Queue queue{count, task, task_data};
  if (getpid() != body->process) {
    queue.drain(0);
    return SHD_OK;
  }
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
  const auto max_workers = static_cast<uint32_t>(tbb::info::default_concurrency());
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
