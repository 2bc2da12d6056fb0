// SPDX-License-Identifier: MIT
// Levels, probes and filters of the texture unit of unit_ref.h.
#pragma once

#include "ref/unit_ref.h"

namespace ref {

/// Two columns of derivatives, normalised.
struct UnitSteps {
  double xu, xv, yu, yv;
};

/// Size of a footprint on the base level, and the line of its probes.
struct UnitShape {
  double lambda, probe_lambda;
  int probes;
  double du, dv;  // the line, normalised
};

/// Lengths of the longer and the shorter axis by a rule, and the longer one as a vector of texels.
struct UnitAxes {
  double longer, shorter, u, v;
};

inline UnitAxes columns(double xu, double xv, double yu, double yv, double x, double y) {
  return x >= y ? UnitAxes{x, y, xu, xv} : UnitAxes{y, x, yu, yv};
}

inline UnitAxes unit_axes(const Unit& unit, double xu, double xv, double yu, double yv) {
  const auto between = [&](double low, double high) { return low + unit.stretch * (high - low); };
  if (unit.rule == SHD_LEVEL_RULE_VULKAN) {
    const double x = between(fmax(fabs(xu), fabs(xv)), sqrt(2) * (fabs(xu) + fabs(xv)));
    const double y = between(fmax(fabs(yu), fabs(yv)), sqrt(2) * (fabs(yu) + fabs(yv)));
    return columns(xu, xv, yu, yv, x, y);
  }
  if (unit.rule == SHD_LEVEL_RULE_ELLIPSE) {
    // Singular values and vectors by angles: Golub and Van Loan, "Matrix Computations" (1996), 8.6.
    const double sum = hypot(xu + yv, xv - yu), difference = hypot(xu - yv, yu + xv);
    const double angle = (atan2(xv + yu, xu - yv) + atan2(xv - yu, xu + yv)) / 2;
    const double longer = (sum + difference) / 2;
    return {longer, fabs(sum - difference) / 2, longer * cos(angle), longer * sin(angle)};
  }
  return columns(xu, xv, yu, yv, hypot(xu, xv), hypot(yu, yv));
}

inline double opengl_size(const Unit& unit, double xu, double xv, double yu, double yv) {
  const double u = fmax(fabs(xu), fabs(yu)), v = fmax(fabs(xv), fabs(yv));
  return fmax(u, v) + unit.stretch * (u + v - fmax(u, v));
}

inline UnitShape unit_shape(const UnitImage& image, const Unit& unit, UnitSteps d) {
  if (unit.bug == Bug::kOneStep) (unit.option & 1 ? d.yu : d.xu) = (unit.option & 1 ? d.yv : d.xv) = 0;
  double w = static_cast<double>(image.at(0, 0).width), h = static_cast<double>(image.at(0, 0).height);
  const double true_w = w, true_h = h;
  if (unit.bug == Bug::kOneSize) (unit.option & 1 ? w : h) = unit.option & 1 ? h : w;
  const double xu = d.xu * w, xv = d.xv * h, yu = d.yu * w, yv = d.yv * h;
  UnitAxes axes = unit_axes(unit, xu, xv, yu, yv);
  if (unit.bug == Bug::kWrongLine) axes = {axes.longer, axes.shorter, -axes.v, axes.u};
  const double cap = static_cast<double>(image.sampler.max_anisotropy);
  const double ratio = axes.longer == 0 ? 1 : axes.shorter == 0 ? cap : fmin(axes.longer / axes.shorter, cap);
  const double used = ratio + unit.isotropy * (1 - ratio);
  const double size = unit.rule == SHD_LEVEL_RULE_OPENGL ? opengl_size(unit, xu, xv, yu, yv) : axes.longer;
  const double shown = unit.bug == Bug::kShorterAxis ? axes.shorter : size;
  const bool extension = unit.rule == SHD_LEVEL_RULE_OPENGL && unit.isotropy == 0;
  const double count = ceil(used);
  return {log2(shown), log2(axes.longer / (extension ? count : used)), static_cast<int>(count), axes.u / true_w,
          axes.v / true_h};
}

inline double unit_lod(const UnitImage& image, const Unit& unit, double lambda) {
  const shd_sampler_desc& s = image.sampler;
  lambda += unit.level_error;
  if (unit.bug == Bug::kLevelScale) lambda *= unit.a;
  if (unit.bug == Bug::kLevelShift) lambda += unit.a;
  if (unit.bug != Bug::kNoBias) lambda += static_cast<double>(s.lod_bias);
  const double low = static_cast<double>(s.lod_min), high = fmax(low, static_cast<double>(s.lod_max));
  if (unit.bug != Bug::kNoClamps) lambda = fmax(low, fmin(lambda, high));
  const double lod = fmin(fmax(lambda, 0), image.level_count - 1);
  return rounded(lod, unit.bug == Bug::kFewLevelBits ? unit.option : unit.level_bits, unit.level_rounding);
}

/// A point of the plane of a face, moved to the face that it belongs to.
inline void move_to_face(double* u, double* v, int* face) {
  if (*u >= 0 && *u <= 1 && *v >= 0 && *v <= 1) return;
  long double n[3];
  ref_unproject(SHD_PROJECTION_CUBE, *u, *v, static_cast<uint32_t>(*face), n);
  const ref_place place = ref_project(SHD_PROJECTION_CUBE, n);
  *u = static_cast<double>(place.u), *v = static_cast<double>(place.v), *face = static_cast<int>(place.face);
}

inline Value unit_bilinear(const UnitImage& image, const Unit& unit, int layer, int level, double u, double v) {
  if (image.cube) move_to_face(&u, &v, &layer);
  if (unit.bug == Bug::kLevelBit) level = std::min(level ^ 1, image.level_count - 1);
  return Texels{image, unit, layer, level}.bilinear(u, v);
}

inline Value unit_trilinear(const UnitImage& image, const Unit& unit, int layer, double u, double v, double lod) {
  const int fine = static_cast<int>(floor(lod)), coarse = std::min(fine + 1, image.level_count - 1);
  double s = lod - floor(lod);
  if (unit.bug == Bug::kNoBlend) s = unit.option & 1;
  if (unit.bug == Bug::kBlendFlipped) s = 1 - s;
  const Value a = unit_bilinear(image, unit, layer, fine, u, v), b = unit_bilinear(image, unit, layer, coarse, u, v);
  Value out;
  for (size_t c = 0; c < 4; ++c) out[c] = (1 - s) * a[c] + s * b[c];
  return out;
}

inline Value unit_anisotropic(const UnitImage& image, const Unit& unit, int layer, double u, double v, double lod,
                              const UnitShape& shape) {
  Value sum = {};
  double total = 0;
  for (int k = 0; k < shape.probes; ++k) {
    double t = unit.vulkan_places ? (k + 1.0) / (shape.probes + 1) - 0.5 : (k + 0.5) / shape.probes - 0.5;
    const double weight = exp(-unit.probe_falloff * 4 * t * t);
    if (unit.bug == Bug::kLongLine) t *= unit.a;
    if (unit.bug == Bug::kLineShift) t += unit.a;
    const Value value = unit_trilinear(image, unit, layer, u + t * shape.du, v + t * shape.dv, lod);
    for (size_t c = 0; c < 4; ++c) sum[c] += weight * value[c];
    total += weight;
  }
  if (unit.bug == Bug::kProbeSum) total += unit.a;
  for (double& x : sum) x /= total;
  return sum;
}

inline int unit_level(const Unit& unit, double lod) {
  return static_cast<int>(fmax(unit.lower_tie ? ceil(lod + 0.5) - 1 : floor(lod + 0.5), 0));
}

inline Value unit_nearest(const UnitImage& image, const Unit& unit, int layer, int level, double u, double v) {
  if (unit.bug == Bug::kLevelBit) level = std::min(level ^ 1, image.level_count - 1);
  return Texels{image, unit, layer, level}.nearest(u, v);
}

/// The filter at a point of an image.
inline Value unit_filter(const UnitImage& image, const Unit& unit, const UnitLookup& lookup, double u, double v,
                         int layer, const UnitSteps& d) {
  UnitShape shape = {lookup.lod, lookup.lod, 1, 0, 0};
  if (!lookup.has_lod) shape = unit_shape(image, unit, d);
  const double lod = unit_lod(image, unit, shape.lambda);
  const int level = std::min(unit_level(unit, lod), image.level_count - 1);
  switch (image.sampler.filter) {
    case SHD_FILTER_NEAREST: return Texels{image, unit, layer, 0}.nearest(u, v);
    case SHD_FILTER_BILINEAR: return Texels{image, unit, layer, 0}.bilinear(u, v);
    case SHD_FILTER_NEAREST_MIP: return unit_nearest(image, unit, layer, level, u, v);
    case SHD_FILTER_BILINEAR_MIP: return unit_bilinear(image, unit, layer, level, u, v);
    case SHD_FILTER_TRILINEAR: return unit_trilinear(image, unit, layer, u, v, lod);
    default: return unit_anisotropic(image, unit, layer, u, v, unit_lod(image, unit, shape.probe_lambda), shape);
  }
}

/// The point of a direction on its face, and its derivatives, by the quotient rule of the Vulkan specification.
inline Value unit_direction(const UnitImage& image, const Unit& unit, const UnitLookup& lookup) {
  const long double n[3] = {lookup.p[0], lookup.p[1], lookup.p[2]};
  const ref_place place = ref_project(SHD_PROJECTION_CUBE, n);
  const int* row = ref_cube_table[place.face];
  const auto part = [&](const double* v, int axis) { return axis > 0 ? v[axis - 1] : -v[-axis - 1]; };
  const double r = part(lookup.p, row[0]);
  const auto step = [&](const double* d, int axis) {
    return 0.5 * (r * part(d, axis) - part(lookup.p, axis) * part(d, row[0])) / (r * r);
  };
  UnitSteps steps = {step(lookup.dx, row[1]), step(lookup.dx, row[2]), step(lookup.dy, row[1]),
                     step(lookup.dy, row[2])};
  double u = static_cast<double>(place.u), v = static_cast<double>(place.v);
  int face = static_cast<int>(place.face);
  if (unit.bug == Bug::kFlippedFace && face == unit.option >> 1)
    (unit.option & 1 ? v : u) = 1 - (unit.option & 1 ? v : u);
  if (unit.bug == Bug::kMirroredAxis) (unit.option & 1 ? v : u) = 1 - (unit.option & 1 ? v : u);
  if (unit.bug == Bug::kSwappedAxes) std::swap(u, v);
  if (unit.bug == Bug::kLayer) face = (face + 1) % 6;
  return unit_filter(image, unit, lookup, u, v, face, steps);
}

inline double unit_result(const UnitImage& image, const Unit& unit, double value, int c) {
  const Layout l = layout(image.format);
  if (unit.bug == Bug::kFilterFirst && l.component == Layout::kSrgb8 && c < 3) value = srgb_to_linear(value);
  const bool unorm = l.component == Layout::kUnorm8 || l.component == Layout::kSrgb8 || l.component == Layout::kUnorm16;
  if (unit.bug == Bug::kResultBit && c == unit.option >> 3) {
    const int code = static_cast<int>(floor(value * 255 + 0.5));
    return (code ^ (1 << (unit.option & 7))) / 255.0;
  }
  if (!unit.result_bits || !unorm) return value;
  const double largest = ldexp(1, unit.result_bits) - 1;
  return floor(value * largest + 0.5) / largest;
}

inline Value unit_sample(const UnitImage& image, const Unit& unit, const UnitLookup& lookup) {
  Value value;
  if (image.cube) {
    value = unit_direction(image, unit, lookup);
  } else {
    double u = reduce(image.sampler.wrap_u, lookup.p[0]), v = reduce(image.sampler.wrap_v, lookup.p[1]);
    UnitSteps d = {lookup.dx[0], lookup.dx[1], lookup.dy[0], lookup.dy[1]};
    if (unit.bug == Bug::kSwappedAxes) std::swap(u, v);
    if (unit.bug == Bug::kMirroredAxis) (unit.option & 1 ? v : u) = 1 - (unit.option & 1 ? v : u);
    const int layer = unit.bug == Bug::kLayer ? (lookup.layer + 1) % image.layers : lookup.layer;
    value = unit_filter(image, unit, lookup, u, v, layer, d);
  }
  for (int c = 0; c < 4; ++c)
    value[static_cast<size_t>(c)] = unit_result(image, unit, value[static_cast<size_t>(c)], c);
  if (unit.bug == Bug::kSwappedChannels)
    std::swap(value[unit.option & 3], value[static_cast<size_t>(unit.option >> 2)]);
  return value;
}

}  // namespace ref
