// SPDX-License-Identifier: MIT
// Windowed sincs are integrated over a source texel by Gauss-Legendre quadrature with eight points (Abramowitz and
// Stegun, "Handbook of Mathematical Functions", table 25.4). A source texel is at most one level texel wide, so the
// integrals are exact to about 1e-12.
#include "texture/table/mip_weights.h"

#include <cmath>

namespace shd::texture {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kWindowRadius = 3;

/// Returns sin(pi x) by its Taylor series around the nearest integer.
double sin_pi(double x) {
  const double nearest = std::floor(x + 0.5), angle = kPi * (x - nearest), square = angle * angle;
  double term = angle, sum = angle;
  for (int i = 2; i <= 24; i += 2) {
    term *= -square / (i * (i + 1));
    sum += term;
  }
  return 2 * std::floor(nearest / 2) == nearest ? sum : -sum;
}

double sinc(double x) {
  return std::fabs(x) < 1e-9 ? 1 : sin_pi(x) / (kPi * x);
}

/// Returns the modified Bessel function I0 of the square root of `square`.
double bessel_i0(double square) {
  double term = 1, sum = 1;
  for (int i = 1; i <= 24; ++i) {
    term *= square / (4.0 * i * i);
    sum += term;
  }
  return sum;
}

double kernel_value(shd_mip_kernel kernel, double x) {
  if (kernel == SHD_MIP_KERNEL_LANCZOS) return sinc(x) * sinc(x / kWindowRadius);
  constexpr double kSquare = 16;  // square of the parameter of the Kaiser window
  const double t = x / kWindowRadius;
  return sinc(x) * bessel_i0(kSquare * (1 - t * t)) / bessel_i0(kSquare);
}

/// Returns the integral of the kernel over [low, high].
double kernel_area(shd_mip_kernel kernel, double low, double high) {
  if (kernel == SHD_MIP_KERNEL_TRIANGLE) {
    const auto below = [](double x) { return x < 0 ? (1 + x) * (1 + x) / 2 : 1 - (1 - x) * (1 - x) / 2; };
    return below(high > 1 ? 1 : high) - below(low < -1 ? -1 : low);
  }
  static const double kPoint[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
  static const double kWeight[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
  if (low < -kWindowRadius) low = -kWindowRadius;
  if (high > kWindowRadius) high = kWindowRadius;
  const double centre = (low + high) / 2, half = (high - low) / 2;
  double sum = 0;
  for (int i = 0; i < 4; ++i) {
    sum += kWeight[i] *
           (kernel_value(kernel, centre - half * kPoint[i]) + kernel_value(kernel, centre + half * kPoint[i]));
  }
  return sum * half;
}

/// Source texels under the kernel of one level texel, before wrapping.
struct Reach {
  int64_t first, last;
  double centre;  // centre of the level texel [source texels]

  Reach(double radius, uint32_t source, uint32_t size, uint32_t i) {
    const double ratio = static_cast<double>(source) / size;
    centre = (i + 0.5) * ratio;
    first = static_cast<int64_t>(std::floor(centre - radius * ratio));
    last = static_cast<int64_t>(std::floor(centre + radius * ratio));
  }
};

/// Appends the taps of level texel i, beginning with tap `at`. Returns the end of the taps.
size_t add_window(shd_mip_kernel kernel, shd_wrap wrap, uint32_t source, uint32_t size, uint32_t i, size_t at,
                  AxisWeights* out) {
  const double radius = kernel == SHD_MIP_KERNEL_TRIANGLE ? 1 : kWindowRadius;
  const Reach reach(radius, source, size, i);
  const double scale = static_cast<double>(size) / source;
  const size_t begin = at;
  double sum = 0;
  for (int64_t texel = reach.first; texel <= reach.last; ++texel) {
    const double low = (static_cast<double>(texel) - reach.centre) * scale, high = low + scale;
    const int64_t from = wrapped(wrap, texel, source);
    if (from < 0 || high <= -radius || low >= radius) continue;
    const double area = kernel_area(kernel, low, high);
    if (area == 0) continue;
    out->texel[at] = static_cast<uint32_t>(from);
    out->weight[at++] = area;
    sum += area;
  }
  for (size_t tap = begin; tap < at; ++tap) out->weight[tap] /= sum;
  return at;
}

size_t add_box(uint32_t source, uint32_t size, uint32_t i, size_t at, AxisWeights* out) {
  const uint64_t begin = uint64_t{i} * source, end = begin + source;
  for (uint64_t texel = begin / size; texel * size < end; ++texel) {
    const uint64_t low = texel * size < begin ? begin : texel * size;
    const uint64_t high = (texel + 1) * size > end ? end : (texel + 1) * size;
    out->texel[at] = static_cast<uint32_t>(texel);
    out->weight[at++] = static_cast<double>(high - low);
  }
  return at;
}

}  // namespace

int64_t wrapped(shd_wrap wrap, int64_t i, int64_t n) {
  if (i >= 0 && i < n) return i;
  const int64_t period = wrap == SHD_WRAP_MIRROR ? 2 * n : n;
  int64_t inside = i % period;
  if (inside < 0) inside += period;
  switch (wrap) {
    case SHD_WRAP_REPEAT: return inside;
    case SHD_WRAP_MIRROR: return inside < n ? inside : 2 * n - 1 - inside;
    case SHD_WRAP_CLAMP: return i < 0 ? 0 : n - 1;
    case SHD_WRAP_MIRROR_ONCE: return i < 0 && -1 - i < n ? -1 - i : n - 1;
    default: return -1;
  }
}

AxisWeights make_axis_weights(const core::Allocator& allocator, shd_mip_kernel kernel, shd_wrap wrap, uint32_t source,
                              uint32_t size) {
  const bool box = kernel == SHD_MIP_KERNEL_BOX || source == size;
  const size_t radius = box ? 1 : kernel == SHD_MIP_KERNEL_TRIANGLE ? 1 : 3;
  const size_t per_texel = 2 * radius * ((source + size - 1) / size) + 4;
  const size_t capacity = core::checked_mul(per_texel, size);
  AxisWeights out;
  out.first = core::Array<size_t>(allocator, size_t{size} + 1);
  out.texel = core::Array<uint32_t>(allocator, capacity);
  out.weight = core::Array<double>(allocator, capacity);
  out.total = box ? source : 1;
  size_t at = 0;
  for (uint32_t i = 0; i < size; ++i) {
    out.first[i] = at;
    at = box ? add_box(source, size, i, at, &out) : add_window(kernel, wrap, source, size, i, at, &out);
  }
  out.first[size] = at;
  return out;
}

}  // namespace shd::texture
