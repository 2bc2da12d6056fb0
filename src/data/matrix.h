// SPDX-License-Identifier: MIT
#pragma once

namespace shd::data {

/// product = a b for 4 x 4 matrices, column-major, [16], of floats or doubles. `product` must not overlap a or b.
template <class A, class B>
void multiply(const A* a, const B* b, double* product) {
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) {
      double sum = 0.0;
      for (int k = 0; k < 4; ++k) sum += static_cast<double>(a[4 * k + r]) * static_cast<double>(b[4 * c + k]);
      product[4 * c + r] = sum;
    }
  }
}

}  // namespace shd::data
