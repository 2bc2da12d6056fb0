// SPDX-License-Identifier: MIT
// Errors of means of random samples.
#pragma once

#include <cmath>

namespace shd::tests
{

/// The error that the mean of n samples from a range exceeds with a probability of at most 1e-12: Hoeffding,
/// "Probability Inequalities for Sums of Bounded Random Variables" (1963), theorem 2.
inline double hoeffding(double range, double n) { return range * std::sqrt(std::log(2e12) / (2 * n)); }

}  // namespace shd::tests
