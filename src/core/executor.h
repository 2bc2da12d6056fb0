// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <cstdio>

#include "core/call.h"
#include "core/context.h"
#include "core/guard.h"

namespace shd::core {

/// Creates the built-in executor: a separate oneTBB arena if oneTBB is built in, otherwise the calling thread.
/// worker_count 0, or more than the number of cores = one per core. Returns the body of the executor, null if it needs
/// none; fills `out`.
void* create_executor(const Allocator& allocator, uint32_t worker_count, shd_executor* out);
void destroy_executor(const Allocator& allocator, void* body) noexcept;

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

namespace detail {

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

template <class Body>
struct Job {
  Body& body;
  uint32_t count;
  uint32_t worker_count;
  Claims claims;
  std::atomic<uint32_t> done{0};
  TaskFailure failure;
  SharedCall call;

  Job(const Context& context, uint32_t task_count, Body& task)
      : body(task),
        count(task_count),
        worker_count(context.executor.worker_count),
        claims(context.allocator, task_count) {}

  static void run(void* data, uint32_t index, uint32_t worker) {
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
            job.body(index, worker);
            return SHD_OK;
          });
  }
};

}  // namespace detail

/// Runs body(index, worker) for every index in [0, count) on the context's executor; returns after all have finished.
/// Throws Failure with the first failure of a task or of the executor. Tasks after a failure are skipped.
template <class Body>
void parallel_for(const Context& context, uint32_t count, Body&& body) {
  if (count == 0) return;
  if (count == 1) {
    body(uint32_t{0}, uint32_t{0});
    return;
  }
  detail::Job<std::remove_reference_t<Body>> job(context, count, body);
  const shd_result result = context.executor.parallel_for(context.executor.user_data, count, &job.run, &job);
  if (job.failure.failed.load(std::memory_order_acquire)) throw Failure(job.failure.code, job.failure.text);
  if (result != SHD_OK) refuse(SHD_ERROR_CALLBACK, "executor.parallel_for returned %s", shd_result_name(result));
  if (job.done.load(std::memory_order_acquire) != count) {
    refuse(SHD_ERROR_CALLBACK, "executor.parallel_for ran %u of %u tasks", job.done.load(), count);
  }
}

}  // namespace shd::core
