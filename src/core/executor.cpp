// SPDX-License-Identifier: MIT
#include "core/executor.h"

#ifdef SHD_WITH_TBB
#include <oneapi/tbb/blocked_range.h>
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
  explicit Arena(int workers) : arena(workers) {}
  tbb::task_arena arena;
};

shd_result tbb_parallel_for(void* user_data, uint32_t count, shd_task_fn task, void* task_data) {
  try {
    const auto run = [&](const tbb::blocked_range<uint32_t>& range) {
      const auto worker = static_cast<uint32_t>(tbb::this_task_arena::current_thread_index());
      for (uint32_t i = range.begin(); i != range.end(); ++i) task(task_data, i, worker);
    };
    // Isolated: a nested call that waits must not pick up tasks of the outer one, whose scratch is in use.
    static_cast<Arena*>(user_data)->arena.execute([&] {
      tbb::this_task_arena::isolate(
          [&] { tbb::parallel_for(tbb::blocked_range<uint32_t>(0, count, 1), run, tbb::simple_partitioner()); });
    });
    return SHD_OK;
  } catch (const std::bad_alloc&) {
    return SHD_ERROR_OUT_OF_MEMORY;
  } catch (...) {
    return SHD_ERROR_INTERNAL;
  }
}
#endif

}  // namespace

void* create_executor(const Allocator& allocator, uint32_t worker_count, shd_executor* out) {
  *out = {serial_parallel_for, nullptr, 1, 0};
#ifdef SHD_WITH_TBB
  // More threads than cores bring nothing, and oneTBB would complain about them on stderr.
  const auto cores = static_cast<uint32_t>(tbb::info::default_concurrency());
  if (worker_count == 0 || worker_count > cores) worker_count = cores;
  if (worker_count <= 1) return nullptr;
  Arena* arena = create<Arena>(allocator, static_cast<int>(worker_count));
  *out = {tbb_parallel_for, arena, worker_count, 0};
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
