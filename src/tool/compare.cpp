// SPDX-License-Identifier: MIT
#include "tool/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

Picture difference_of(const Picture& a, const Picture& b) {
  Picture out = blank_picture(a.width, a.height, {0, 0, 0, 1});
  float most = 0.0f;
  for (size_t i = 0; i < out.rgba.size(); ++i) {
    if (i % 4 == 3) continue;
    out.rgba[i] = std::fabs(a.rgba[i] - b.rgba[i]);
    if (out.rgba[i] > most) most = out.rgba[i];
  }
  float factor = 1.0f;
  while (factor < 1024.0f && 2.0f * factor * most <= 1.0f) factor *= 2.0f;
  for (size_t i = 0; i < out.rgba.size(); ++i) out.rgba[i] *= i % 4 == 3 ? 1.0f : factor;
  std::fprintf(stderr, "shd-render: largest difference %.4g, shown times %.0f\n", most, factor);
  return out;
}
