// SPDX-License-Identifier: MIT
#include "supersample.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace shd::bench {
namespace {

/// The two texels around a coordinate along one axis, and the weight of the second.
struct Taps {
  Taps(double coordinate, uint32_t edge) {
    const double place = coordinate * edge - 0.5, below = std::floor(place);
    weight = place - below;
    first = static_cast<uint32_t>(static_cast<int64_t>(below)) & (edge - 1);
    second = (first + 1) & (edge - 1);
  }
  uint32_t first, second;
  double weight;
};

/// Adds the bilinear reconstruction of r, g, b at one point.
void add_bilinear(const Picture& picture, const Taps& x, const Taps& y, double* sum) {
  const uint8_t* above = &picture.rgba[size_t{y.first} * picture.edge * 4];
  const uint8_t* below = &picture.rgba[size_t{y.second} * picture.edge * 4];
  for (size_t c = 0; c < 3; ++c) {
    const double left = above[4 * x.first + c] * (1.0 - y.weight) + below[4 * x.first + c] * y.weight;
    const double right = above[4 * x.second + c] * (1.0 - y.weight) + below[4 * x.second + c] * y.weight;
    sum[c] += left * (1.0 - x.weight) + right * x.weight;
  }
}

void fill(std::vector<uint8_t>* rgba, size_t texel, double value) {
  const auto byte = static_cast<uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
  for (size_t c = 0; c < 4; ++c) (*rgba)[4 * texel + c] = c == 3 ? 255 : byte;
}

}  // namespace

Picture make_checker(uint32_t edge, uint32_t square) {
  Picture picture{"checker", edge, std::vector<uint8_t>(size_t{edge} * edge * 4)};
  for (uint32_t y = 0; y < edge; ++y) {
    for (uint32_t x = 0; x < edge; ++x) fill(&picture.rgba, size_t{y} * edge + x, (x / square + y / square) & 1);
  }
  return picture;
}

Picture make_noise(uint32_t edge) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<double> values(size_t{edge} * edge, 0.5);
  for (uint32_t cells = 4; cells <= edge; cells *= 2) {
    std::vector<double> lattice(size_t{cells} * cells);
    for (double& value : lattice) value = uniform(random) / cells;
    for (uint32_t y = 0; y < edge; ++y) {
      const Taps v((y + 0.5) / edge, cells);
      for (uint32_t x = 0; x < edge; ++x) {
        const Taps u((x + 0.5) / edge, cells);
        const double* above = &lattice[size_t{v.first} * cells];
        const double* below = &lattice[size_t{v.second} * cells];
        const double left = above[u.first] * (1.0 - v.weight) + below[u.first] * v.weight;
        const double right = above[u.second] * (1.0 - v.weight) + below[u.second] * v.weight;
        values[size_t{y} * edge + x] += left * (1.0 - u.weight) + right * u.weight;
      }
    }
  }
  Picture picture{"noise", edge, std::vector<uint8_t>(values.size() * 4)};
  for (size_t i = 0; i < values.size(); ++i) fill(&picture.rgba, i, values[i]);
  return picture;
}

std::vector<float> supersample(const Floor& floor, const Picture& picture, int samples) {
  const double far = static_cast<double>(floor.far), scale = static_cast<double>(floor.scale), edge = floor.frame;
  const double cosine = floor.turned ? std::sqrt(0.5) : 1.0, sine = floor.turned ? std::sqrt(0.5) : 0.0;
  std::vector<float> image(size_t{floor.frame} * floor.frame * 4);
  std::vector<double> sums(size_t{floor.frame} * 3);
  for (uint32_t y = 0; y < floor.frame; ++y) {
    std::fill(sums.begin(), sums.end(), 0.0);
    for (int sub_y = 0; sub_y < samples; ++sub_y) {
      const double row = y + (sub_y + 0.5) / samples;
      const double z = 1.0 / (1.0 / far + (1.0 - 1.0 / far) * row / edge);
      const double v = scale * z;
      for (uint32_t x = 0; x < floor.frame; ++x) {
        for (int sub_x = 0; sub_x < samples; ++sub_x) {
          const double column = x + (sub_x + 0.5) / samples;
          const double u = scale * (column / edge - 0.5) * z;
          add_bilinear(picture, Taps(cosine * u - sine * v, picture.edge), Taps(sine * u + cosine * v, picture.edge),
                       &sums[size_t{x} * 3]);
        }
      }
    }
    for (uint32_t x = 0; x < floor.frame; ++x) {
      float* pixel = &image[(size_t{y} * floor.frame + x) * 4];
      for (size_t c = 0; c < 3; ++c)
        pixel[c] = static_cast<float>(sums[size_t{x} * 3 + c] / (255.0 * samples * samples));
      pixel[3] = 1.0f;
    }
  }
  return image;
}

void add_bilinear(const Picture& picture, double u, double v, double* sum) {
  add_bilinear(picture, Taps(u, picture.edge), Taps(v, picture.edge), sum);
}

double psnr(const std::vector<float>& rgba, const std::vector<float>& truth) {
  double sum = 0.0;
  for (size_t i = 0; i < truth.size(); ++i) {
    if (i % 4 == 3) continue;
    const double difference = static_cast<double>(std::clamp(rgba[i], 0.0f, 1.0f)) - static_cast<double>(truth[i]);
    sum += difference * difference;
  }
  return -10.0 * std::log10(sum / (static_cast<double>(truth.size()) * 0.75));
}

}  // namespace shd::bench
