// SPDX-License-Identifier: MIT
// Mip levels by separable kernels in doubles, with the functions of the C library: the oracle of shd_mip_build.
#pragma once

#include <math.h>
#include <stdlib.h>

#include <shd/mip.h>

#include "ref/texture_ref.h"

namespace ref {

inline double mip_sinc(double x) {
  return x == 0 ? 1 : sin(M_PI * x) / (M_PI * x);
}

/// Modified Bessel function of order 0, by its series.
inline double mip_bessel(double x) {
  double sum = 1, term = 1;
  for (int k = 1; k < 25; ++k) sum += term *= x * x / (4 * k * k);
  return sum;
}

inline double mip_kernel(shd_mip_kernel kernel, double x) {
  switch (kernel) {
    case SHD_MIP_KERNEL_BOX: return 1;
    case SHD_MIP_KERNEL_TRIANGLE: return 1 - fabs(x);
    case SHD_MIP_KERNEL_LANCZOS: return mip_sinc(x) * mip_sinc(x / 3);
    default: return mip_sinc(x) * mip_bessel(4 * sqrt(fmax(0, 1 - x * x / 9))) / 11.301921952136330496;  // I0(4)
  }
}

inline double mip_radius(shd_mip_kernel kernel) {
  return kernel == SHD_MIP_KERNEL_BOX ? 0.5 : kernel == SHD_MIP_KERNEL_TRIANGLE ? 1 : 3;
}

/// Integral over [low, high] by Simpson's rule, on each side of 0.
inline double mip_area(shd_mip_kernel kernel, double low, double high) {
  const double radius = mip_radius(kernel);
  low = fmax(low, -radius);
  high = fmin(high, radius);
  if (low >= high) return 0;
  if (low < 0 && high > 0) return mip_area(kernel, low, 0) + mip_area(kernel, 0, high);
  const int steps = kernel <= SHD_MIP_KERNEL_TRIANGLE ? 2 : 64;
  double sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const double x = low + (high - low) * i / steps;
    sum += (i == 0 || i == steps ? 1 : i % 2 ? 4 : 2) * mip_kernel(kernel, x);
  }
  return sum * (high - low) / (3 * steps);
}

/// Weights [size][source] of one axis; the caller must free() them.
inline double* mip_weights(shd_mip_kernel kernel, shd_wrap wrap, int64_t source, int64_t size) {
  auto* weights = static_cast<double*>(calloc(static_cast<size_t>(source * size), sizeof(double)));
  const double ratio = static_cast<double>(source) / static_cast<double>(size), radius = mip_radius(kernel);
  for (int64_t i = 0; i < size; ++i) {
    double* row = weights + i * source;
    const double centre = (static_cast<double>(i) + 0.5) * ratio;
    double sum = 0;
    for (auto k = static_cast<int64_t>(floor(centre - radius * ratio)) - 1; k <= centre + radius * ratio + 1; ++k) {
      const double low = (static_cast<double>(k) - centre) / ratio;
      const int64_t texel = wrap_index(wrap, k, source);
      if (texel < 0 && kernel != SHD_MIP_KERNEL_BOX) continue;
      if (texel < 0 || (kernel == SHD_MIP_KERNEL_BOX && texel != k)) continue;
      const double area = mip_area(kernel, low, low + 1 / ratio);
      row[texel] += area;
      sum += area;
    }
    for (int64_t k = 0; k < source; ++k) row[k] /= sum;
    if (source == size) {
      for (int64_t k = 0; k < source; ++k) row[k] = k == i;
    }
  }
  return weights;
}

/// Filters [height][width] values into [to_height][to_width]; the caller must free() the result.
inline double* mip_filter(const shd_mip_desc& desc, const double* values, int64_t width, int64_t height,
                          int64_t to_width, int64_t to_height) {
  double* across = mip_weights(desc.kernel, desc.wrap_u, width, to_width);
  double* down = mip_weights(desc.kernel, desc.wrap_v, height, to_height);
  auto* column = static_cast<double*>(calloc(static_cast<size_t>(width), sizeof(double)));
  auto* out = static_cast<double*>(calloc(static_cast<size_t>(to_width * to_height), sizeof(double)));
  for (int64_t y = 0; y < to_height; ++y) {
    for (int64_t x = 0; x < width; ++x) column[x] = 0;
    for (int64_t j = 0; j < height; ++j) {
      const double weight = down[y * height + j];
      for (int64_t x = 0; weight != 0 && x < width; ++x) column[x] += weight * values[j * width + x];
    }
    for (int64_t x = 0; x < to_width; ++x) {
      const double* weight = across + x * width;
      int64_t first = 0, end = width;
      while (weight[first] == 0) ++first;
      while (weight[end - 1] == 0) --end;
      for (int64_t i = first; i < end; ++i) out[y * to_width + x] += weight[i] * column[i];
    }
  }
  free(across);
  free(down);
  free(column);
  return out;
}

}  // namespace ref
