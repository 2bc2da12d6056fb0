// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <new>

#include "core/context.h"
#include "core/fp_env.h"
#include "core/status.h"

namespace shd::core {

/// The built-in executor: oneTBB in an arena of its own if built in, else the calling thread.
/// worker_count 0 = one per core; at most one per core. Returns its body, null if it needs none; fills `out`.
void* create_executor(const Allocator& allocator, uint32_t worker_count, shd_executor* out);
void destroy_executor(const Allocator& allocator, void* body) noexcept;

/// First failure of a parallel_for, carried from the worker to the calling thread.
struct TaskFailure {
  std::atomic<bool> failed{false};
  shd_result code = SHD_OK;
  char text[1024];

  void record(shd_result result, const char* message) noexcept {
    if (failed.exchange(true, std::memory_order_acq_rel)) return;
    code = result;
    std::snprintf(text, sizeof text, "%s", message);
  }
};

namespace detail {

template <class Body>
struct Job {
  Body& body;
  uint32_t count;
  uint32_t worker_count;
  std::atomic<uint32_t> done{0};
  TaskFailure failure;

  static void run(void* data, uint32_t index, uint32_t worker) {
    Job& job = *static_cast<Job*>(data);
    job.done.fetch_add(1, std::memory_order_relaxed);
    if (index >= job.count || worker >= job.worker_count) {
      job.failure.record(SHD_ERROR_CALLBACK, "executor.parallel_for passed an index or worker out of range");
    }
    if (job.failure.failed.load(std::memory_order_relaxed)) return;
    const FpScope fp;
    try {
      job.body(index, worker);
    } catch (const Failure& failure) {
      job.failure.record(failure.code, failure.what());
    } catch (const std::bad_alloc&) {
      job.failure.record(SHD_ERROR_OUT_OF_MEMORY, "out of memory");
    } catch (const std::exception& error) {
      job.failure.record(SHD_ERROR_INTERNAL, error.what());
    } catch (...) {
      job.failure.record(SHD_ERROR_INTERNAL, "unknown exception");
    }
  }
};

}  // namespace detail

/// Runs body(index, worker) for every index in [0, count) on the context's executor; returns when all are done.
/// Throws Failure with the first failure of a task or of the executor. Tasks after a failure are skipped.
template <class Body>
void parallel_for(const Context& context, uint32_t count, Body&& body) {
  if (count == 0) return;
  detail::Job<std::remove_reference_t<Body>> job{body, count, context.executor.worker_count, {}, {}};
  shd_result result = SHD_OK;
  if (count == 1) {
    job.run(&job, 0, 0);
  } else {
    result = context.executor.parallel_for(context.executor.user_data, count, &job.run, &job);
  }
  if (job.failure.failed.load(std::memory_order_acquire)) {
    throw Failure(fail(job.failure.code, "%s", job.failure.text));
  }
  if (result != SHD_OK) {
    throw Failure(fail(SHD_ERROR_CALLBACK, "executor.parallel_for returned %s", shd_result_name(result)));
  }
  if (job.done.load(std::memory_order_acquire) != count) {
    throw Failure(fail(SHD_ERROR_CALLBACK, "executor.parallel_for ran %u of %u tasks", job.done.load(), count));
  }
}

}  // namespace shd::core
