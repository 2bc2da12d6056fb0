// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/allocator.h"

namespace shd::geometry {

/// out[i] = the lowest vertex whose columns have the same values as vertex i. -0 equals 0, and NaN equals a NaN of the
/// same bits. A radix sort, so that the time is linear for any values. out: [vertex_count]. Throws std::bad_alloc.
void weld(const core::Allocator& allocator, const float* const* columns, size_t column_count, size_t vertex_count,
          uint32_t* out);

}  // namespace shd::geometry
