// SPDX-License-Identifier: MIT
#include "core/executor.h"

#include <atomic>
#include <cstdio>

#include "core/call.h"
#include "core/guard.h"

#ifdef SHD_WITH_TBB
#include <algorithm>

#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include "core/fork.h"
#endif

namespace shd::core {
namespace {

/// First failure of a parallel_for, passed from the worker to the calling thread.
struct TaskFailure {
  std::atomic<bool> failed{false};
  shd_result code = SHD_OK;
  char text[kErrorTextSize];

  shd_result record(shd_result result, const char* message) noexcept {
    if (failed.exchange(true, std::memory_order_acq_rel)) return result;
    code = result;
    std::snprintf(text, sizeof text, "%s", message);
    return result;
  }
};

/// The tasks that have begun. A host's executor may run a task twice by mistake, and tasks may rely on running once.
class Claims {
 public:
  /// Throws std::bad_alloc for more than kInline tasks.
  Claims(const Allocator& allocator, uint32_t count) : many_(allocator, count > kInline ? (count + 31) / 32 : 0) {}

  /// Returns false if `index` was already claimed.
  bool claim(uint32_t index) noexcept {
    std::atomic<uint32_t>* words = many_.size() ? many_.data() : few_;
    const uint32_t bit = 1u << (index % 32);
    return !(words[index / 32].fetch_or(bit, std::memory_order_relaxed) & bit);
  }

 private:
  static constexpr uint32_t kInline = 1024;
  std::atomic<uint32_t> few_[kInline / 32] = {};
  core::Objects<std::atomic<uint32_t>> many_;
};

struct Job {
  const Task& task;
  uint32_t count;
  uint32_t worker_count;
  Claims claims;
  std::atomic<uint32_t> done{0};
  TaskFailure failure;
  SharedCall call;

  Job(const Context& context, uint32_t task_count, const Task& job_task)
      : task(job_task),
        count(task_count),
        worker_count(context.executor.worker_count),
        claims(context.allocator, task_count) {}

  static void run(size_t index, size_t worker, void* data) {
    Job& job = *static_cast<Job*>(data);
    if (index >= job.count || worker >= job.worker_count) {
      job.failure.record(SHD_ERROR_CALLBACK, "executor.parallel_for passed an index or worker out of range");
      return;
    }
    if (!job.claims.claim(index)) {
      job.failure.record(SHD_ERROR_CALLBACK, "executor.parallel_for ran a task twice");
      return;
    }
    job.done.fetch_add(1, std::memory_order_relaxed);
    if (job.failure.failed.load(std::memory_order_relaxed)) return;
    const TaskScope scope(&job.call);
    guard([&](shd_result code, const char* text) { return job.failure.record(code, text); },
          [&] {
            job.task.run(index, worker, job.task.body);
            return SHD_OK;
          });
  }
};

shd_result serial_parallel_for(size_t count, shd_task_fn task, void* task_data, void*) {
  for (size_t i = 0; i < count; ++i) task(i, 0, task_data);
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
  size_t count;
  shd_task_fn task;
  void* task_data;
  std::atomic<size_t> next{0};

  void drain(size_t worker) noexcept {
    for (size_t i; (i = next.fetch_add(1, std::memory_order_relaxed)) < count;) task(i, worker, task_data);
  }
};

shd_result tbb_parallel_for(size_t count, shd_task_fn task, void* task_data, void* user_data) {
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
      queue.drain(static_cast<size_t>(tbb::this_task_arena::current_thread_index()));
    };
    const auto drains = static_cast<uint32_t>(std::min(count, static_cast<size_t>(arena.max_concurrency())));
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

void run_tasks(const Context& context, uint32_t count, const Task& task) {
  if (count == 0) return;
  if (count == 1) return task.run(0, 0, task.body);
  Job job(context, count, task);
  const shd_result result = context.executor.parallel_for(count, &job.run, &job, context.executor.user_data);
  if (job.failure.failed.load(std::memory_order_acquire)) throw Failure(job.failure.code, job.failure.text);
  if (result != SHD_OK) refuse(SHD_ERROR_CALLBACK, "executor.parallel_for returned %s", shd_result_name(result));
  if (job.done.load(std::memory_order_acquire) != count) {
    refuse(SHD_ERROR_CALLBACK, "executor.parallel_for ran %u of %u tasks", job.done.load(), count);
  }
}

}  // namespace shd::core
