// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <type_traits>

#include "core/context.h"

namespace shd::core {

/// Creates the built-in executor: a separate oneTBB arena if oneTBB is built in, otherwise the calling thread.
/// worker_count 0, or more than the number of cores = one per core. Returns the body of the executor, null if it needs
/// none; fills `out`.
void* create_executor(const Allocator& allocator, uint32_t worker_count, shd_executor* out);
void destroy_executor(const Allocator& allocator, void* body) noexcept;

/// A task of parallel_for(): calls run(index, worker, body).
struct Task {
  void (*run)(size_t index, size_t worker, void* body);
  void* body;
};

/// parallel_for() of a Task, which is compiled once for all bodies.
void run_tasks(const Context& context, uint32_t count, const Task& task);

/// Runs body(index, worker) for every index in [0, count) on the context's executor; returns after all have finished.
/// Throws Failure with the first failure of a task or of the executor. Tasks after a failure are skipped.
template <class Body>
void parallel_for(const Context& context, uint32_t count, Body&& body) {
  using Plain = std::remove_reference_t<Body>;
  run_tasks(context, count,
            {[](size_t index, size_t worker, void* data) {
               (*static_cast<Plain*>(data))(static_cast<uint32_t>(index), static_cast<uint32_t>(worker));
             },
             const_cast<void*>(static_cast<const void*>(&body))});
}

}  // namespace shd::core
