// SPDX-License-Identifier: MIT
#include "polygon/sparse_solver.h"

#ifdef SHD_WITH_EIGEN

#define EIGEN_NO_DEBUG  // arguments are checked before
#include <Eigen/SparseCholesky>

namespace shd::polygon {
namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int32_t>;

/// Goes over summands in the form that Eigen reads.
struct Summands {
  const SparseEntry* at;

  const Summands* operator->() const { return this; }
  int32_t row() const { return static_cast<int32_t>(at->row); }
  int32_t col() const { return static_cast<int32_t>(at->column); }
  double value() const { return at->value; }
  Summands& operator++() {
    ++at;
    return *this;
  }
  bool operator!=(const Summands& other) const { return at != other.at; }
};

}  // namespace

bool has_sparse_solver() {
  return true;
}

bool solve_sparse(size_t size, const SparseEntry* entries, size_t entry_count, double* columns, size_t column_count) {
  const auto rows = static_cast<Eigen::Index>(size);
  Matrix matrix(rows, rows);
  matrix.setFromTriplets(Summands{entries}, Summands{entries + entry_count});
  const Eigen::SimplicialLDLT<Matrix, Eigen::Lower> solver(matrix);
  if (solver.info() != Eigen::Success || !(solver.vectorD().minCoeff() > 0.0)) return false;
  for (size_t c = 0; c < column_count; ++c) {
    Eigen::Map<Eigen::VectorXd> column(columns + c * size, rows);
    column = solver.solve(column).eval();
  }
  return true;
}

}  // namespace shd::polygon

#else

namespace shd::polygon {

bool has_sparse_solver() {
  return false;
}

bool solve_sparse(size_t, const SparseEntry*, size_t, double*, size_t) {
  return false;
}

}  // namespace shd::polygon

#endif  // SHD_WITH_EIGEN
