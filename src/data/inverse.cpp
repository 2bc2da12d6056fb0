// SPDX-License-Identifier: MIT
#include "data/inverse.h"

#include <cmath>
#include <utility>

namespace shd::data {
namespace {

// Elements of a scaled matrix are at most 1. Elimination reduces a singular matrix to elements below 2^-48.
constexpr double kMinPivot = 0x1p-46;

/// A square matrix, column-major, whose rows and columns are scaled by powers of two so that the largest element of
/// each is in [0.5, 1]: then pivots measure the independence of the rows for any units of the axes.
template <int kSize>
struct Scaled {
  double m[kSize][kSize];  // [column][row]
  int row[kSize], column[kSize];
};

/// Exponent of the largest of kSize elements; false if all are 0.
template <int kSize>
bool exponent_of(const double* first, int step, int* out) {
  double largest = 0.0;
  for (int i = 0; i < kSize; ++i) largest = std::fmax(largest, std::fabs(first[i * step]));
  std::frexp(largest, out);
  return largest > 0.0;
}

/// False if a row or column is 0.
template <int kSize>
bool scale(Scaled<kSize>* a) {
  double* first = &a->m[0][0];
  for (int r = 0; r < kSize; ++r) {
    if (!exponent_of<kSize>(first + r, kSize, &a->row[r])) return false;
    for (int c = 0; c < kSize; ++c) a->m[c][r] = std::ldexp(a->m[c][r], -a->row[r]);
  }
  for (int c = 0; c < kSize; ++c) {
    if (!exponent_of<kSize>(first + c * kSize, 1, &a->column[c])) return false;
    for (int r = 0; r < kSize; ++r) a->m[c][r] = std::ldexp(a->m[c][r], -a->column[c]);
  }
  return true;
}

/// Swaps the largest element of the rows and columns from k on to (k, k).
template <int kSize>
void choose_pivot(double (&m)[kSize][kSize], int k, int* row, int* column) {
  *row = *column = k;
  for (int c = k; c < kSize; ++c) {
    for (int r = k; r < kSize; ++r) {
      if (std::fabs(m[c][r]) > std::fabs(m[*column][*row])) *row = r, *column = c;
    }
  }
  for (int i = 0; i < kSize; ++i) std::swap(m[*column][i], m[k][i]);
  for (int i = 0; i < kSize; ++i) std::swap(m[i][*row], m[i][k]);
}

/// Gauss-Jordan elimination in place with full pivoting (Golub and Van Loan, "Matrix Computations", 4th edition, 3.4).
template <int kSize>
bool eliminate(double (&m)[kSize][kSize]) {
  int row[kSize], column[kSize];
  for (int k = 0; k < kSize; ++k) {
    choose_pivot(m, k, &row[k], &column[k]);
    const double pivot = m[k][k];
    if (!(std::fabs(pivot) >= kMinPivot)) return false;
    m[k][k] = 1.0;
    for (int c = 0; c < kSize; ++c) m[c][k] /= pivot;
    for (int r = 0; r < kSize; ++r) {
      if (r == k) continue;
      const double factor = m[k][r];
      m[k][r] = 0.0;
      for (int c = 0; c < kSize; ++c) m[c][r] -= factor * m[c][k];
    }
  }
  // The inverse of P A Q is Q^-1 A^-1 P^-1: swaps of rows come back as swaps of columns, in reverse.
  for (int k = kSize - 1; k >= 0; --k) {
    for (int i = 0; i < kSize; ++i) std::swap(m[i][column[k]], m[i][k]);
    for (int i = 0; i < kSize; ++i) std::swap(m[row[k]][i], m[k][i]);
  }
  return true;
}

/// The inverse of the upper left kSize x kSize of m.
template <int kSize, class T>
bool invert_part(const T* m, double* out) {
  Scaled<kSize> a;
  for (int c = 0; c < kSize; ++c) {
    for (int r = 0; r < kSize; ++r) a.m[c][r] = static_cast<double>(m[4 * c + r]);
  }
  if (!scale(&a) || !eliminate(a.m)) return false;
  for (int c = 0; c < kSize; ++c) {
    for (int r = 0; r < kSize; ++r) out[kSize * c + r] = std::ldexp(a.m[c][r], -a.column[r] - a.row[c]);
  }
  return true;
}

template <class T>
bool invert_any(const T* m, double* out) {
  const bool is_affine = m[3] == T{0} && m[7] == T{0} && m[11] == T{0} && m[15] == T{1};
  if (!is_affine) return invert_part<4>(m, out);
  double linear[9];
  if (!invert_part<3>(m, linear)) return false;
  for (int r = 0; r < 3; ++r) {
    double moved = 0.0;
    for (int c = 0; c < 3; ++c) {
      out[4 * c + r] = linear[3 * c + r];
      moved += linear[3 * c + r] * static_cast<double>(m[12 + c]);
    }
    out[12 + r] = 0.0 - moved;
    out[4 * r + 3] = 0.0;
  }
  out[15] = 1.0;
  return true;
}

}  // namespace

bool invert(const float m[16], double out[16]) {
  return invert_any(m, out);
}

bool invert(const double m[16], double out[16]) {
  return invert_any(m, out);
}

bool invert_linear(const float m[16], double out[9]) {
  return invert_part<3>(m, out);
}

}  // namespace shd::data
