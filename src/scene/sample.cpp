// SPDX-License-Identifier: MIT
#include "scene/sample.h"

#include <algorithm>
#include <cmath>

namespace shd::scene {
namespace {

void normalise(std::vector<double>& q) {
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (!(length > 0.0)) {
    q = {0, 0, 0, 1};
    return;
  }
  for (double& c : q) c /= length;
}

/// Two keys around a time, and the part of the way between them, 0..1.
struct Span {
  size_t from = 0, to = 0;
  double t = 0, seconds = 0;
};

Span span_of(const Channel& channel, double seconds) {
  const std::vector<float>& times = channel.times;
  const auto after = std::upper_bound(times.begin(), times.end(), seconds,
                                      [](double time, float key) { return time < static_cast<double>(key); });
  const auto next = static_cast<size_t>(after - times.begin());
  if (next == 0) return {};
  if (next == times.size()) return {next - 1, next - 1, 0, 0};
  const double start = static_cast<double>(times[next - 1]), length = static_cast<double>(times[next]) - start;
  return {next - 1, next, (seconds - start) / length, length};
}

/// The weights of the values of both keys between two unit quaternions with that dot product.
std::array<double, 2> slerp_weights(double dot, double t) {
  const double angle = std::acos(std::min(std::fabs(dot), 1.0)), sine = std::sin(angle);
  const double sign = dot < 0 ? -1.0 : 1.0;
  if (sine < 1e-9) return {1 - t, sign * t};
  return {std::sin(angle * (1 - t)) / sine, sign * std::sin(angle * t) / sine};
}

}  // namespace

size_t component_count(const Channel& channel) {
  const size_t keys = channel.times.size() * (channel.interpolation == Interpolation::kCubicSpline ? 3 : 1);
  return keys > 0 && channel.values.size() % keys == 0 ? channel.values.size() / keys : 0;
}

std::vector<double> sample(const Channel& channel, double seconds) {
  const size_t width = component_count(channel);
  const bool cubic = channel.interpolation == Interpolation::kCubicSpline;
  const bool rotates = channel.target == Target::kRotation && width == 4;
  const Span span = span_of(channel, seconds);
  // part 0 is the in-tangent of a cubic key, part 2 its out-tangent
  const auto value = [&](size_t key, size_t part) {
    const auto first = channel.values.begin() + static_cast<std::ptrdiff_t>((cubic ? 3 * key + part : key) * width);
    return std::vector<double>(first, first + static_cast<std::ptrdiff_t>(width));
  };
  std::vector<double> out = value(span.from, 1);
  if (span.to != span.from && channel.interpolation != Interpolation::kStep) {
    std::vector<double> next = value(span.to, 1);
    std::array<double, 2> weights = {1 - span.t, span.t};
    const double t = span.t, t2 = t * t, t3 = t2 * t;
    if (cubic) {
      weights = {2 * t3 - 3 * t2 + 1, 3 * t2 - 2 * t3};
    } else if (rotates) {
      normalise(out);
      normalise(next);
      weights = slerp_weights(out[0] * next[0] + out[1] * next[1] + out[2] * next[2] + out[3] * next[3], t);
    }
    for (size_t c = 0; c < width; ++c) out[c] = weights[0] * out[c] + weights[1] * next[c];
    if (cubic) {
      const std::vector<double> leave = value(span.from, 2), arrive = value(span.to, 0);
      for (size_t c = 0; c < width; ++c) {
        out[c] += span.seconds * ((t3 - 2 * t2 + t) * leave[c] + (t3 - t2) * arrive[c]);
      }
    }
  }
  if (rotates) normalise(out);
  return out;
}

}  // namespace shd::scene
