// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace shd::polygon {

/// A summand of an element of a matrix.
struct SparseEntry {
  uint32_t row, column;
  double value;
};

/// Whether the build has a solver: Eigen.
bool has_sparse_solver();

/// Solves A X = B for a symmetric positive definite A, given the summands of its lower triangle. `columns` is B,
/// [column_count][size], and becomes X. Returns false if A is not positive definite. Memory comes from malloc. Throws
/// std::bad_alloc.
bool solve_sparse(size_t size, const SparseEntry* entries, size_t entry_count, double* columns, size_t column_count);

}  // namespace shd::polygon
