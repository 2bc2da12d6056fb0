// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "metrics.h"

namespace shootout {

std::string hash_of(const void* data, size_t size) {
  const auto* bytes = static_cast<const uint8_t*>(data);
  uint64_t hash = 0xcbf29ce484222325u;
  for (size_t i = 0; i < size; ++i) hash = (hash ^ bytes[i]) * 0x100000001b3u;
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

double psnr(const Picture& picture, const Picture& truth) {
  double sum = 0.0;
  for (size_t i = 0; i < truth.rgb.size(); ++i) {
    const double d = static_cast<double>(picture.rgb[i]) - static_cast<double>(truth.rgb[i]);
    sum += d * d;
  }
  return std::min(-10.0 * std::log10(sum / static_cast<double>(truth.rgb.size())), kBestPsnr);
}

Difference difference(const Picture& picture, const Picture& truth) {
  Difference d = {0.0, 0.0};
  for (size_t i = 0; i < truth.rgb.size(); ++i) {
    const double value = std::fabs(static_cast<double>(picture.rgb[i]) - static_cast<double>(truth.rgb[i]));
    d.mean += value;
    d.max = std::max(d.max, value);
  }
  d.mean /= static_cast<double>(truth.rgb.size());
  return d;
}

double mean_of(const std::vector<float>& map) {
  double sum = 0.0;
  for (const float value : map) sum += static_cast<double>(value);
  return sum / static_cast<double>(map.size());
}

Motion motion(const Picture& movie, const Picture& truth, uint32_t edge, uint32_t columns, uint32_t frames) {
  Motion result = {0.0, 0.0};
  const auto error = [&](uint32_t frame, uint32_t i) {
    const uint32_t x = frame % columns * edge + i % edge, y = frame / columns * edge + i / edge;
    std::array<double, 3> e;
    for (size_t c = 0; c < 3; ++c) {
      e[c] = static_cast<double>(movie.at(x, y)[c]) - static_cast<double>(truth.at(x, y)[c]);
    }
    return e;
  };
  for (uint32_t frame = 0; frame < frames; ++frame) {
    double squares = 0.0;
    for (uint32_t i = 0; i < edge * edge; ++i) {
      const auto now = error(frame, i);
      for (const double value : now) squares += value * value;
      if (frame < 2) continue;
      const auto before = error(frame - 1, i), first = error(frame - 2, i);
      for (size_t c = 0; c < 3; ++c) {
        const double second = now[c] - 2.0 * before[c] + first[c];
        result.flicker += second * second;
      }
    }
    result.psnr += std::min(-10.0 * std::log10(squares / (3.0 * edge * edge)), kBestPsnr);
  }
  result.psnr /= frames;
  result.flicker = std::sqrt(result.flicker / (3.0 * edge * edge * (frames - 2)));
  return result;
}

}  // namespace shootout
