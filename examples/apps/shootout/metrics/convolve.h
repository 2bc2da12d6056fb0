// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

namespace shootout {

/// One channel of a picture.
struct Plane {
  int width = 0, height = 0;
  std::vector<float> values;
  Plane(int w, int h) : width(w), height(h), values(static_cast<size_t>(w) * static_cast<size_t>(h)) {}
};

/// Convolves with `across` along rows and `down` along columns, both of odd length; edge pixels are repeated.
inline Plane convolve(const Plane& in, const std::vector<double>& across, const std::vector<double>& down) {
  Plane middle(in.width, in.height), out(in.width, in.height);
  const int rx = static_cast<int>(across.size() / 2), ry = static_cast<int>(down.size() / 2);
  const auto row_of = [&](int y) { return static_cast<size_t>(std::clamp(y, 0, in.height - 1) * in.width); };
  const auto width = static_cast<size_t>(in.width);
  std::vector<float> row(width + across.size());
  for (int y = 0; y < in.height; ++y) {
    for (int x = -rx; x < in.width + rx; ++x) {
      row[static_cast<size_t>(x + rx)] = in.values[row_of(y) + static_cast<size_t>(std::clamp(x, 0, in.width - 1))];
    }
    float* to = &middle.values[row_of(y)];
    for (size_t k = 0; k < across.size(); ++k) {
      const auto weight = static_cast<float>(across[k]);
      for (size_t x = 0; x < width; ++x) to[x] += weight * row[x + k];
    }
  }
  for (int y = 0; y < in.height; ++y) {
    float* to = &out.values[row_of(y)];
    for (int k = -ry; k <= ry; ++k) {
      const auto weight = static_cast<float>(down[static_cast<size_t>(k + ry)]);
      const float* from = &middle.values[row_of(y + k)];
      for (size_t x = 0; x < width; ++x) to[x] += weight * from[x];
    }
  }
  return out;
}

}  // namespace shootout
