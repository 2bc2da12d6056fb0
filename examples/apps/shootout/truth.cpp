// SPDX-License-Identifier: MIT
#include "truth.h"

#include <cmath>

namespace shootout {
namespace {

/// The bilinear reconstruction of the repeated texture at one point, in [0, 1].
void reconstruct(const Texture& texture, Point at, float rgba[4]) {
  const double x = at.u * texture.edge - 0.5, y = at.v * texture.edge - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  const auto s = static_cast<float>(x - left), t = static_cast<float>(y - top);
  const uint32_t mask = texture.edge - 1;
  const uint32_t x0 = static_cast<uint32_t>(static_cast<int64_t>(left)) & mask, x1 = (x0 + 1) & mask;
  const uint32_t y0 = static_cast<uint32_t>(static_cast<int64_t>(top)) & mask, y1 = (y0 + 1) & mask;
  const uint8_t *above = &texture.rgba[size_t{y0} * texture.edge * 4],
                *below = &texture.rgba[size_t{y1} * texture.edge * 4];
  for (size_t c = 0; c < 4; ++c) {
    const float a = above[4 * x0 + c], b = above[4 * x1 + c], d = below[4 * x0 + c], e = below[4 * x1 + c];
    const float first = a + s * (b - a), second = d + s * (e - d);
    rgba[c] = (first + t * (second - first)) * (1.0f / 255.0f);
  }
}

}  // namespace

void sample_row(const Workload& workload, const Texture& texture, uint32_t samples_x, uint32_t samples_y, uint32_t y,
                size_t count, std::vector<float>* rgb) {
  rgb->resize(count * 3);
  const double dy = (y % samples_y + 0.5) / samples_y - 0.5;
  for (size_t i = 0; i < count; ++i) {
    const double dx = (static_cast<double>(i % samples_x) + 0.5) / samples_x - 0.5;
    float rgba[4];
    reconstruct(texture, workload.at(static_cast<uint32_t>(i / samples_x), y / samples_y, dx, dy), rgba);
    shade(texture.shading, rgba, &(*rgb)[3 * i]);
  }
}

Picture supersample(const Workload& workload, const Texture& texture, uint32_t samples, uint32_t phases) {
  const uint32_t edge = workload.edge * phases, step = samples / phases;
  const size_t count = size_t{edge - 1} * step + samples;
  std::vector<double> sums(size_t{edge} * edge * 3), windows(size_t{edge} * 3);
  std::vector<float> row;
  for (uint32_t y = 0; y < count; ++y) {
    sample_row(workload, texture, samples, samples, y, count, &row);
    for (uint32_t x = 0; x < edge; ++x) {
      for (size_t c = 0; c < 3; ++c) {
        double sum = 0.0;
        for (size_t i = 0; i < samples; ++i) sum += static_cast<double>(row[(size_t{x} * step + i) * 3 + c]);
        windows[size_t{x} * 3 + c] = sum;
      }
    }
    // Rows of the frame whose windows of `samples` rows contain row y.
    const uint32_t last = std::min(y / step, edge - 1), first = y < samples ? 0 : (y - samples) / step + 1;
    for (uint32_t k = first; k <= last; ++k) {
      for (size_t i = 0; i < windows.size(); ++i) sums[size_t{k} * windows.size() + i] += windows[i];
    }
  }
  Picture picture(edge, edge);
  const double scale = 1.0 / (static_cast<double>(samples) * samples);
  for (size_t i = 0; i < sums.size(); ++i) picture.rgb[i] = static_cast<float>(sums[i] * scale);
  return picture;
}

}  // namespace shootout
