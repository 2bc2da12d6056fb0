// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/executor.h"
#include "texture/store/span.h"

namespace shd::texture {

/// Calls body(row, worker) for every row of a range, in at most 1024 tasks. parallel_for() allocates no memory for so
/// few tasks.
template <class Body>
void for_rows(const core::Context& context, AxisRange rows, const Body& body) {
  const uint32_t count = rows.size(), tasks = count < 1024 ? count : 1024;
  core::parallel_for(context, tasks, [&](uint32_t task, uint32_t worker) {
    const auto begin = static_cast<uint32_t>(uint64_t{count} * task / tasks);
    const auto end = static_cast<uint32_t>(uint64_t{count} * (task + 1) / tasks);
    for (uint32_t row = begin; row < end; ++row) body(rows.first + row, worker);
  });
}

}  // namespace shd::texture
