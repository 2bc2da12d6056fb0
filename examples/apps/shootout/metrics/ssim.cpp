// SPDX-License-Identifier: MIT
#include <cmath>

#include "convolve.h"
#include "metrics.h"

namespace shootout {
namespace {

constexpr int kRadius = 5;
constexpr double kSigma = 1.5;

/// Luma less kCentre, so that squares have little rounding.
constexpr double kCentre = 0.5;
Plane centred_luma_of(const Picture& picture) {
  Plane plane(static_cast<int>(picture.width), static_cast<int>(picture.height));
  for (size_t i = 0; i < plane.values.size(); ++i) {
    const float* p = &picture.rgb[3 * i];
    plane.values[i] = 0.299f * p[0] + 0.587f * p[1] + 0.114f * p[2] - static_cast<float>(kCentre);
  }
  return plane;
}

Plane product(const Plane& a, const Plane& b) {
  Plane out(a.width, a.height);
  for (size_t i = 0; i < out.values.size(); ++i) out.values[i] = a.values[i] * b.values[i];
  return out;
}

}  // namespace

double ssim(const Picture& picture, const Picture& truth) {
  constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;
  std::vector<double> weights;
  double total = 0.0;
  for (int k = -kRadius; k <= kRadius; ++k) weights.push_back(std::exp(-k * k / (2.0 * kSigma * kSigma)));
  for (const double weight : weights) total += weight;
  for (double& weight : weights) weight /= total;
  const auto blurred = [&](const Plane& plane) { return convolve(plane, weights, weights); };
  const Plane x = centred_luma_of(picture), y = centred_luma_of(truth);
  const Plane mx = blurred(x), my = blurred(y);
  const Plane xx = blurred(product(x, x)), yy = blurred(product(y, y)), xy = blurred(product(x, y));
  double sum = 0.0;
  size_t count = 0;
  for (int row = kRadius; row < x.height - kRadius; ++row) {
    for (int column = kRadius; column < x.width - kRadius; ++column) {
      const auto i = static_cast<size_t>(row * x.width + column);
      auto a = static_cast<double>(mx.values[i]), b = static_cast<double>(my.values[i]);
      const double vx = static_cast<double>(xx.values[i]) - a * a, vy = static_cast<double>(yy.values[i]) - b * b;
      const double covariance = static_cast<double>(xy.values[i]) - a * b;
      a += kCentre;
      b += kCentre;
      sum += (2.0 * a * b + kC1) * (2.0 * covariance + kC2) / ((a * a + b * b + kC1) * (vx + vy + kC2));
      ++count;
    }
  }
  return sum / static_cast<double>(count);
}

}  // namespace shootout
