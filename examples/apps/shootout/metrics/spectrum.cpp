// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "metrics.h"

namespace shootout {
namespace {

constexpr double kPi = 3.14159265358979323846;

size_t padded(size_t size) {
  size_t edge = 1;
  while (edge < size) edge *= 2;
  return edge;
}

/// Transforms rows, then columns, of edge x edge complex numbers.
void fourier_2d(std::vector<double>* values, size_t edge) {
  for (size_t y = 0; y < edge; ++y) fourier(&(*values)[2 * y * edge], edge);
  std::vector<double> column(2 * edge);
  for (size_t x = 0; x < edge; ++x) {
    for (size_t y = 0; y < edge; ++y) {
      column[2 * y] = (*values)[2 * (y * edge + x)];
      column[2 * y + 1] = (*values)[2 * (y * edge + x) + 1];
    }
    fourier(column.data(), edge);
    for (size_t y = 0; y < edge; ++y) {
      (*values)[2 * (y * edge + x)] = column[2 * y];
      (*values)[2 * (y * edge + x) + 1] = column[2 * y + 1];
    }
  }
}

/// Luma without its mean, under a Hann window, in a square of a power of two.
std::vector<double> windowed(const Picture& picture, size_t edge) {
  std::vector<double> luma(picture.pixels());
  double mean = 0.0;
  for (size_t i = 0; i < luma.size(); ++i) {
    const float* p = &picture.rgb[3 * i];
    luma[i] = 0.299 * static_cast<double>(p[0]) + 0.587 * static_cast<double>(p[1]) + 0.114 * static_cast<double>(p[2]);
    mean += luma[i] / static_cast<double>(luma.size());
  }
  std::vector<double> values(2 * edge * edge);
  const auto hann = [](size_t i, size_t n) {
    return 0.5 - 0.5 * std::cos(2.0 * kPi * (static_cast<double>(i) + 0.5) / static_cast<double>(n));
  };
  for (size_t y = 0; y < picture.height; ++y) {
    for (size_t x = 0; x < picture.width; ++x) {
      values[2 * (y * edge + x)] =
          (luma[y * picture.width + x] - mean) * hann(x, picture.width) * hann(y, picture.height);
    }
  }
  return values;
}

/// Power in rings of frequencies; the last ring has everything beyond.
std::vector<double> rings(const Picture& picture, size_t edge, size_t count) {
  std::vector<double> values = windowed(picture, edge), power(count + 1);
  fourier_2d(&values, edge);
  const auto half = static_cast<double>(edge) / 2.0;
  for (size_t y = 0; y < edge; ++y) {
    for (size_t x = 0; x < edge; ++x) {
      const double fx = std::min(static_cast<double>(x), static_cast<double>(edge - x)) / half;
      const double fy = std::min(static_cast<double>(y), static_cast<double>(edge - y)) / half;
      // The frequency along the axis where it is higher, so that the ring of Nyquist is the square of the pixels.
      const auto ring = static_cast<size_t>(std::max(fx, fy) * static_cast<double>(count));
      const double* z = &values[2 * (y * edge + x)];
      power[std::min(ring, count)] += z[0] * z[0] + z[1] * z[1];
    }
  }
  return power;
}

}  // namespace

void fourier(double* values, size_t count) {
  for (size_t i = 1, j = 0; i < count; ++i) {
    size_t bit = count >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) {
      std::swap(values[2 * i], values[2 * j]);
      std::swap(values[2 * i + 1], values[2 * j + 1]);
    }
  }
  for (size_t length = 2; length <= count; length *= 2) {
    const double angle = -2.0 * kPi / static_cast<double>(length), step_r = std::cos(angle), step_i = std::sin(angle);
    for (size_t first = 0; first < count; first += length) {
      double wr = 1.0, wi = 0.0;
      for (size_t k = 0; k < length / 2; ++k) {
        double *a = &values[2 * (first + k)], *b = a + length;
        const double br = b[0] * wr - b[1] * wi, bi = b[0] * wi + b[1] * wr;
        b[0] = a[0] - br, b[1] = a[1] - bi;
        a[0] += br, a[1] += bi;
        const double next = wr * step_r - wi * step_i;
        wi = wr * step_i + wi * step_r;
        wr = next;
      }
    }
  }
}

Spectrum spectrum(const Picture& picture, const Picture& truth, uint32_t phases) {
  constexpr size_t kRingsBelow = 24;  // rings below the Nyquist frequency of the pixels
  const size_t edge = padded(truth.width), count = kRingsBelow * phases;
  const std::vector<double> a = rings(picture, edge, count), b = rings(truth, edge, count);
  double total = 0.0, above = 0.0, missing = 0.0;
  for (size_t i = 0; i < b.size(); ++i) {
    total += b[i];
    if (i >= kRingsBelow) above += std::max(a[i] - b[i], 0.0);
    if (i < kRingsBelow) missing += std::max(b[i] - a[i], 0.0);
  }
  if (total == 0.0) return {0.0, 0.0};
  return {above / total, missing / total};
}

}  // namespace shootout
