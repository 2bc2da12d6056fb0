// SPDX-License-Identifier: MIT
// Texture lookup in doubles, in single obvious steps: the oracle of the texture kernels.
#pragma once

#include <math.h>
#include <stdint.h>
#include <string.h>

#include <shd/lookup.h>

namespace ref {

/// Stored texels of one level, rows packed.
struct Level {
  const uint8_t* texels;
  int64_t width, height;
};

/// IEC 61966-2-1.
inline double srgb_to_linear(double c) {
  return c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
}
inline double linear_to_srgb(double c) {
  return c <= 0.0031308 ? c * 12.92 : 1.055 * pow(c, 1 / 2.4) - 0.055;
}

/// IEEE 754 binary16.
inline double half_value(uint16_t half) {
  const int exponent = half >> 10 & 31;
  const double mantissa = half & 1023, sign = half & 0x8000 ? -1 : 1;
  if (exponent == 31) return mantissa != 0 ? NAN : sign * INFINITY;
  return sign * (exponent == 0 ? ldexp(mantissa, -24) : ldexp(1024 + mantissa, exponent - 25));
}

/// OpenGL extension EXT_texture_shared_exponent: the unit of the numbers of a texel, and a channel.
inline double rgb9e5_unit(uint32_t word) {
  return ldexp(1, static_cast<int>(word >> 27) - 15 - 9);
}
inline double rgb9e5_value(uint32_t word, int c) {
  return (word >> 9 * c & 511) * rgb9e5_unit(word);
}

/// "Shared Exponent Texture Color Conversion" of the same extension, with N = 9, B = 15 and Emax = 31.
inline uint32_t rgb9e5_word(const double (&rgb)[3]) {
  const double most = 511.0 / 512 * 65536;
  double c[3];
  for (int i = 0; i < 3; ++i) c[i] = rgb[i] > 0 ? fmin(rgb[i], most) : 0;
  const double largest = fmax(c[0], fmax(c[1], c[2]));
  double shared = (largest > 0 ? fmax(-16, floor(log2(largest))) : -16) + 1 + 15;
  if (floor(largest / exp2(shared - 15 - 9) + 0.5) == 512) ++shared;
  uint32_t word = static_cast<uint32_t>(shared) << 27;
  for (int i = 0; i < 3; ++i) word |= static_cast<uint32_t>(floor(c[i] / exp2(shared - 15 - 9) + 0.5)) << 9 * i;
  return word;
}

/// Number of channels of a stored format, and size of a channel in bytes; of the texel for kRgb9e5.
struct Layout {
  int channels, size;
  enum { kUnorm8, kSrgb8, kUnorm16, kFloat16, kFloat32, kRgb9e5 } component;
};
inline Layout layout(shd_format format) {
  switch (format) {
    case SHD_FORMAT_R8: return {1, 1, Layout::kUnorm8};
    case SHD_FORMAT_RG8: return {2, 1, Layout::kUnorm8};
    case SHD_FORMAT_RGBA8: return {4, 1, Layout::kUnorm8};
    case SHD_FORMAT_R8_SRGB: return {1, 1, Layout::kSrgb8};
    case SHD_FORMAT_RG8_SRGB: return {2, 1, Layout::kSrgb8};
    case SHD_FORMAT_RGBA8_SRGB: return {4, 1, Layout::kSrgb8};
    case SHD_FORMAT_R16: return {1, 2, Layout::kUnorm16};
    case SHD_FORMAT_RG16: return {2, 2, Layout::kUnorm16};
    case SHD_FORMAT_RGBA16: return {4, 2, Layout::kUnorm16};
    case SHD_FORMAT_R16F: return {1, 2, Layout::kFloat16};
    case SHD_FORMAT_RG16F: return {2, 2, Layout::kFloat16};
    case SHD_FORMAT_RGBA16F: return {4, 2, Layout::kFloat16};
    case SHD_FORMAT_R32F: return {1, 4, Layout::kFloat32};
    case SHD_FORMAT_RG32F: return {2, 4, Layout::kFloat32};
    case SHD_FORMAT_RGB9E5: return {3, 4, Layout::kRgb9e5};
    default: return {4, 4, Layout::kFloat32};
  }
}

/// Default value of a channel that the format lacks.
inline double missing(int c) {
  return c == 3 ? 1 : 0;
}

/// Linear value of channel c of the texel at `texel`.
inline double decode(shd_format format, const uint8_t* texel, int c) {
  const Layout l = layout(format);
  if (c >= l.channels) return missing(c);
  float value;
  uint16_t code;
  uint32_t word;
  switch (l.component) {
    case Layout::kUnorm8: return texel[c] / 255.0;
    case Layout::kSrgb8: return c == 3 ? texel[c] / 255.0 : srgb_to_linear(texel[c] / 255.0);
    case Layout::kUnorm16: memcpy(&code, texel + 2 * c, 2); return code / 65535.0;
    case Layout::kFloat16: memcpy(&code, texel + 2 * c, 2); return half_value(code);
    case Layout::kRgb9e5: memcpy(&word, texel, 4); return rgb9e5_value(word, c);
    default: memcpy(&value, texel + 4 * c, 4); return static_cast<double>(value);
  }
}

inline int64_t modulo(int64_t i, int64_t n) {
  return (i % n + n) % n;
}

/// Vulkan 1.3 specification, "Wrapping Operation"; -1 means the border.
inline int64_t wrap_index(shd_wrap wrap, int64_t i, int64_t n) {
  const auto mirror = [](int64_t x) { return x >= 0 ? x : -(1 + x); };
  switch (wrap) {
    case SHD_WRAP_REPEAT: return modulo(i, n);
    case SHD_WRAP_MIRROR: return n - 1 - mirror(modulo(i, 2 * n) - n);
    case SHD_WRAP_CLAMP: return i < 0 ? 0 : i >= n ? n - 1 : i;
    case SHD_WRAP_MIRROR_ONCE: return mirror(i) >= n ? n - 1 : mirror(i);
    default: return i < 0 || i >= n ? -1 : i;
  }
}

/// A coordinate with the same texels as u, small enough for exact doubles. 2 is a period of repeat and mirror; the
/// other modes are constant beyond [-2, 3].
inline double reduce(shd_wrap wrap, double u) {
  if (!isfinite(u)) return 0;
  if (wrap == SHD_WRAP_REPEAT || wrap == SHD_WRAP_MIRROR) return fmod(u, 2);
  return fmin(fmax(u, -2), 3);
}

struct Image {
  shd_format format;
  const Level* levels;
  int level_count;
  const shd_sampler_desc* sampler;
};

inline double texel(const Image& image, int level, int64_t i, int64_t j, int c) {
  const Level& l = image.levels[level];
  const int64_t x = wrap_index(image.sampler->wrap_u, i, l.width), y = wrap_index(image.sampler->wrap_v, j, l.height);
  if (c >= layout(image.format).channels) return missing(c);
  if (x < 0 || y < 0) return static_cast<double>(image.sampler->border[c]);
  const auto size = static_cast<int64_t>(shd_format_size(image.format));
  return decode(image.format, l.texels + (y * l.width + x) * size, c);
}

/// A texel of weight 0 is ignored, even if it is NaN.
inline double mix(double a, double b, double s) {
  if (s == 0) return a;
  if (s == 1) return b;
  return (1 - s) * a + s * b;
}

/// Hermite interpolation between 0 and 1 with slopes of 0 at both ends (Shirley and Marschner, "Fundamentals of
/// Computer Graphics", solid noise).
inline double hermite_weight(double s) {
  return 3 * s * s - 2 * s * s * s;
}

/// The four texels of a level around (u, v), with the weights weight(s) and weight(t) of the fractions.
template <class Weight>
double blend_four(const Image& image, int level, double u, double v, const Weight& weight, int c) {
  const Level& l = image.levels[level];
  const double x = reduce(image.sampler->wrap_u, u) * static_cast<double>(l.width) - 0.5;
  const double y = reduce(image.sampler->wrap_v, v) * static_cast<double>(l.height) - 0.5;
  const auto i = static_cast<int64_t>(floor(x)), j = static_cast<int64_t>(floor(y));
  const double s = weight(x - floor(x)), t = weight(y - floor(y));
  return mix(mix(texel(image, level, i, j, c), texel(image, level, i + 1, j, c), s),
             mix(texel(image, level, i, j + 1, c), texel(image, level, i + 1, j + 1, c), s), t);
}

inline double bilinear(const Image& image, int level, double u, double v, int c) {
  return blend_four(
      image, level, u, v, [](double s) { return s; }, c);
}
inline double hermite(const Image& image, double u, double v, int c) {
  return blend_four(image, 0, u, v, hermite_weight, c);
}

/// log2 of the larger singular value of [dudx dudy; dvdx dvdy] in texels of a w x h base; NaN entries count as 0.
inline double lambda(double dudx, double dvdx, double dudy, double dvdy, double w, double h) {
  const auto entry = [](double value, double size) { return isnan(value) ? 0 : value * size; };
  const double a = entry(dudx, w), b = entry(dudy, w), c = entry(dvdx, h), d = entry(dvdy, h);
  if (isinf(a) || isinf(b) || isinf(c) || isinf(d)) return INFINITY;
  // Golub and Van Loan, "Matrix Computations" (1996), 8.6: singular values of a 2 x 2 matrix.
  const double sum = hypot(a + d, c - b), difference = hypot(a - d, b + c);
  return log2((sum + difference) / 2);
}

inline double clamp_lod(const Image& image, double lod) {
  const shd_sampler_desc& s = *image.sampler;
  const double bias = static_cast<double>(s.lod_bias);
  const double low = static_cast<double>(s.lod_min), high = fmax(low, static_cast<double>(s.lod_max));
  const double clamped = fmax(low, fmin(lod + bias, high));
  return fmin(fmax(clamped, 0), image.level_count - 1);
}

/// A level of detail whose fraction is the share of the coarser level (shd_sampler_desc::level_blend).
inline double blend_levels(const shd_sampler_desc& s, double lod) {
  const double blend = static_cast<double>(s.level_blend), fraction = lod - floor(lod);
  if (blend == 0) return fraction > 0.5 ? floor(lod) + 1 : floor(lod);
  return floor(lod) + fmin(fmax((fraction - 0.5) / blend + 0.5, 0), 1);
}

inline double trilinear(const Image& image, double u, double v, double lod, int c) {
  const double d = blend_levels(*image.sampler, clamp_lod(image, lod));
  const int high = static_cast<int>(floor(d));
  const int low = high + 1 < image.level_count ? high + 1 : image.level_count - 1;
  return mix(bilinear(image, high, u, v, c), bilinear(image, low, u, v, c), d - floor(d));
}

/// Texel of a level that contains (u, v) moved by (du, dv) texels.
inline double nearest_on(const Image& image, int level, double u, double v, double du, double dv, int c) {
  const Level& l = image.levels[level];
  const double x = reduce(image.sampler->wrap_u, u) * static_cast<double>(l.width) + du;
  const double y = reduce(image.sampler->wrap_v, v) * static_cast<double>(l.height) + dv;
  return texel(image, level, static_cast<int64_t>(floor(x)), static_cast<int64_t>(floor(y)), c);
}

/// Whether a value is the blend of the texels at the point on the two levels around a final level of detail, each texel
/// within 4e-7 of the width and height.
inline bool is_nearest_blend(const Image& image, double lod, double u, double v, int c, double got, double tolerance) {
  const int high = static_cast<int>(floor(lod)), low = high + 1 < image.level_count ? high + 1 : high;
  const double slack[] = {0, -4e-7, 4e-7};
  const auto texel_at = [&](int level, int k) {
    const Level& l = image.levels[level];
    return nearest_on(image, level, u, v, slack[k % 3] * static_cast<double>(l.width),
                      slack[k / 3] * static_cast<double>(l.height), c);
  };
  for (int k = 0; k < 81; ++k) {
    const double a = texel_at(high, k % 9), s = lod - floor(lod),
                 want = s == 0 ? a : (1 - s) * a + s * texel_at(low, k / 9);
    if (fabs(got - want) <= tolerance) return true;
  }
  return false;
}

/// Mitchell and Netravali, "Reconstruction Filters in Computer Graphics" (1988), equation (8).
inline double cubic_kernel(double b, double c, double x) {
  x = fabs(x);
  if (x < 1) return ((12 - 9 * b - 6 * c) * x * x * x + (-18 + 12 * b + 6 * c) * x * x + 6 - 2 * b) / 6;
  if (x < 2) return ((-b - 6 * c) * x * x * x + (6 * b + 30 * c) * x * x + (-12 * b - 48 * c) * x + 8 * b + 24 * c) / 6;
  return 0;
}
inline double cubic_weight(shd_cubic cubic, double x) {
  switch (cubic) {
    case SHD_CUBIC_B_SPLINE: return cubic_kernel(1, 0, x);
    case SHD_CUBIC_MITCHELL: return cubic_kernel(1.0 / 3, 1.0 / 3, x);
    default: return cubic_kernel(0, 0.5, x);
  }
}

/// The 4 x 4 texels of level 0 around (u, v); a texel of weight 0 is ignored.
inline double bicubic(const Image& image, double u, double v, int c) {
  const Level& l = image.levels[0];
  const double x = reduce(image.sampler->wrap_u, u) * static_cast<double>(l.width) - 0.5;
  const double y = reduce(image.sampler->wrap_v, v) * static_cast<double>(l.height) - 0.5;
  const auto i = static_cast<int64_t>(floor(x)), j = static_cast<int64_t>(floor(y));
  double sum = 0;
  for (int row = -1; row <= 2; ++row) {
    for (int column = -1; column <= 2; ++column) {
      const double weight = cubic_weight(image.sampler->cubic, x - static_cast<double>(i + column)) *
                            cubic_weight(image.sampler->cubic, y - static_cast<double>(j + row));
      if (weight != 0) sum += weight * texel(image, 0, i + column, j + row, c);
    }
  }
  return sum;
}

inline double nearest(const Image& image, double u, double v, double du, double dv, int c) {
  return nearest_on(image, 0, u, v, du, dv, c);
}

/// Length of the part of texel i of n that is covered by texel j of m, where both rows span [0, n m].
inline double overlap(int64_t i, int64_t n, int64_t j, int64_t m) {
  const int64_t begin = i * m > j * n ? i * m : j * n;
  const int64_t end = (i + 1) * m < (j + 1) * n ? (i + 1) * m : (j + 1) * n;
  return end > begin ? static_cast<double>(end - begin) : 0;
}

/// Average of the base level over the area of texel (x, y) of a level of width x height.
inline double box(shd_format format, const Level& base, int64_t width, int64_t height, int64_t x, int64_t y, int c) {
  const auto size = static_cast<int64_t>(shd_format_size(format));
  long double sum = 0;
  for (int64_t j = y * base.height / height; j < base.height && j * height < (y + 1) * base.height; ++j) {
    for (int64_t i = x * base.width / width; i < base.width && i * width < (x + 1) * base.width; ++i) {
      const double weight = overlap(i, base.width, x, width) * overlap(j, base.height, y, height);
      if (weight > 0)
        sum += static_cast<long double>(weight) * decode(format, base.texels + (j * base.width + i) * size, c);
    }
  }
  return static_cast<double>(sum / (static_cast<long double>(base.width) * base.height));
}

}  // namespace ref
