// SPDX-License-Identifier: MIT
// Animations, morph targets and skins of glTF 2.0 in double, as the specification states them: interpolation in
// appendix C, morph targets in 3.7.2.2, skins in 3.7.3.3. Matrices are [row][column].
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace shd::ref {

using Mat4 = std::array<std::array<double, 4>, 4>;
using Row = std::vector<double>;

/// C.3 step: the value of the last key that is not later. C.4 linear: (1 - t) v_k + t v_k+1.
/// `key` and its successor surround the time; t = (t_c - t_k) / t_d.
inline Row step(const Row& from, const Row&, double) {
  return from;
}

inline Row linear(const Row& from, const Row& to, double t) {
  Row out;
  for (size_t c = 0; c < from.size(); ++c) out.push_back((1 - t) * from[c] + t * to[c]);
  return out;
}

/// C.4 spherical linear interpolation of quaternions: d the dot product, a = arccos |d|, s = d / |d|.
inline Row slerp(const Row& from, const Row& to, double t) {
  double d = 0;
  for (size_t c = 0; c < 4; ++c) d += from[c] * to[c];
  const double a = std::acos(std::fabs(d)), s = d < 0 ? -1 : 1;
  Row out;
  for (size_t c = 0; c < 4; ++c) {
    out.push_back(std::sin(a * (1 - t)) / std::sin(a) * from[c] + s * std::sin(a * t) / std::sin(a) * to[c]);
  }
  return out;
}

/// C.5 cubic spline: out-tangent b of the first key, in-tangent a of the second one, both times t_d.
inline Row cubic(const Row& from, const Row& b, const Row& a, const Row& to, double t, double t_d) {
  Row out;
  for (size_t c = 0; c < from.size(); ++c) {
    out.push_back((2 * t * t * t - 3 * t * t + 1) * from[c] + t_d * (t * t * t - 2 * t * t + t) * b[c] +
                  (-2 * t * t * t + 3 * t * t) * to[c] + t_d * (t * t * t - t * t) * a[c]);
  }
  return out;
}

inline Mat4 product(const Mat4& a, const Mat4& b) {
  Mat4 out{};
  for (size_t r = 0; r < 4; ++r) {
    for (size_t c = 0; c < 4; ++c) {
      for (size_t k = 0; k < 4; ++k) out[r][c] += a[r][k] * b[k][c];
    }
  }
  return out;
}

/// Inverse of an affine matrix, by Cramer's rule.
inline Mat4 inverse(const Mat4& m) {
  const auto minor = [&](size_t r, size_t c) {
    const size_t r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
    return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
  };
  const double det = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  Mat4 out{};
  out[3][3] = 1;
  for (size_t r = 0; r < 3; ++r) {
    for (size_t c = 0; c < 3; ++c) out[r][c] = minor(c, r) / det;
  }
  for (size_t r = 0; r < 3; ++r) {
    for (size_t c = 0; c < 3; ++c) out[r][3] -= out[r][c] * m[c][3];
  }
  return out;
}

/// 3.7.3.3: the weighted sum of the joint matrices, each the joint's global transform times its inverse bind matrix.
inline Mat4 skin_matrix(const std::vector<Mat4>& joints, const std::vector<Mat4>& inverse_binds,
                        const std::vector<size_t>& joint, const std::vector<double>& weight) {
  Mat4 sum{};
  for (size_t i = 0; i < joint.size(); ++i) {
    const Mat4 matrix = product(joints[joint[i]], inverse_binds[joint[i]]);
    for (size_t r = 0; r < 4; ++r) {
      for (size_t c = 0; c < 4; ++c) sum[r][c] += weight[i] * matrix[r][c];
    }
  }
  return sum;
}

inline std::array<double, 3> point(const Mat4& m, const std::array<double, 3>& p) {
  std::array<double, 3> out;
  for (size_t r = 0; r < 3; ++r) out[r] = m[r][0] * p[0] + m[r][1] * p[1] + m[r][2] * p[2] + m[r][3];
  return out;
}

/// A unit normal by the transpose of the inverse.
inline std::array<double, 3> normal(const Mat4& m, const std::array<double, 3>& n) {
  const Mat4 i = inverse(m);
  std::array<double, 3> out;
  for (size_t r = 0; r < 3; ++r) out[r] = i[0][r] * n[0] + i[1][r] * n[1] + i[2][r] * n[2];
  const double length = std::sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
  for (double& c : out) c /= length;
  return out;
}

}  // namespace shd::ref
