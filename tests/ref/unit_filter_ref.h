// SPDX-License-Identifier: MIT
// Levels, probes and filters of the texture unit of unit_ref.h.
#pragma once

#include "ref/unit_ref.h"

namespace ref {

/// Two columns of derivatives, normalised.
struct UnitSteps {
  UnitPoint x, y;
};

/// Size of a footprint on the base level, and the line of its probes.
struct UnitShape {
  double lambda, probe_lambda;
  int probes;
  UnitPoint d;  // the line, normalised
};

/// Lengths of the longer and the shorter axis by a rule, and the longer one as a vector of texels.
struct UnitAxes {
  double longer, shorter;
  UnitPoint axis;
};

inline double length(const UnitPoint& p) {
  return hypot(hypot(p[0], p[1]), p[2]);
}
inline double largest_part(const UnitPoint& p) {
  return fmax(fmax(fabs(p[0]), fabs(p[1])), fabs(p[2]));
}
inline double sum_of_parts(const UnitPoint& p) {
  return fabs(p[0]) + fabs(p[1]) + fabs(p[2]);
}

/// The axes of the ellipse of two vectors. In their plane, singular values and vectors by angles: Golub and Van Loan,
/// "Matrix Computations" (1996), 8.6.
inline UnitAxes ellipse_axes(const UnitPoint& x, const UnitPoint& y) {
  const UnitPoint& along = length(x) >= length(y) ? x : y;
  if (length(along) == 0) return {0, 0, {}};
  UnitPoint right = along, up = length(x) >= length(y) ? y : x;
  for (double& c : right) c /= length(along);
  const auto dot = [](const UnitPoint& a, const UnitPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const double part = dot(up, right);
  for (size_t c = 0; c < 3; ++c) up[c] -= part * right[c];
  const double height = length(up);
  const bool is_parallel = height <= 1e-12 * length(along);  // the rest is rounding errors in any direction
  for (double& c : up) c = is_parallel ? 0 : c / height;
  const double xu = dot(x, right), xv = dot(x, up), yu = dot(y, right), yv = dot(y, up);
  const double sum = hypot(xu + yv, xv - yu), difference = hypot(xu - yv, yu + xv);
  const double angle = (atan2(xv + yu, xu - yv) + atan2(xv - yu, xu + yv)) / 2;
  const double longer = (sum + difference) / 2;
  UnitAxes out = {longer, fabs(sum - difference) / 2, {}};
  for (size_t c = 0; c < 3; ++c) out.axis[c] = longer * (cos(angle) * right[c] + sin(angle) * up[c]);
  return out;
}

inline UnitAxes unit_axes(const Unit& unit, const UnitPoint& x, const UnitPoint& y) {
  if (unit.rule == SHD_LEVEL_RULE_ELLIPSE) return ellipse_axes(x, y);
  const auto size = [&](const UnitPoint& p) {
    if (unit.rule != SHD_LEVEL_RULE_VULKAN) return length(p);
    return largest_part(p) + unit.stretch * (sqrt(2) * sum_of_parts(p) - largest_part(p));
  };
  const double a = size(x), b = size(y);
  return a >= b ? UnitAxes{a, b, x} : UnitAxes{b, a, y};
}

inline double opengl_size(const Unit& unit, const UnitPoint& x, const UnitPoint& y) {
  UnitPoint m;
  for (size_t c = 0; c < 3; ++c) m[c] = fmax(fabs(x[c]), fabs(y[c]));
  return largest_part(m) + unit.stretch * (sum_of_parts(m) - largest_part(m));
}

inline UnitShape unit_shape(const UnitImage& image, const Unit& unit, UnitSteps d) {
  if (unit.bug == Bug::kOneStep) (unit.option & 1 ? d.y : d.x) = {};
  const Level& base = image.at(0, 0);
  double size[3] = {static_cast<double>(base.width), static_cast<double>(base.height),
                    static_cast<double>(image.depth)};
  if (unit.bug == Bug::kOneSize) size[unit.option & 1 ? 0 : 1] = size[unit.option & 1 ? 1 : 0];
  for (size_t c = 0; c < 3; ++c) d.x[c] *= size[c], d.y[c] *= size[c];
  UnitAxes axes = unit_axes(unit, d.x, d.y);
  if (unit.bug == Bug::kWrongLine) axes.axis = {-axes.axis[1], axes.axis[0], -axes.axis[2]};
  const double cap = static_cast<double>(image.sampler.max_anisotropy);
  const double ratio = axes.longer == 0 ? 1 : axes.shorter == 0 ? cap : fmin(axes.longer / axes.shorter, cap);
  const double used = ratio + unit.isotropy * (1 - ratio);
  const double found = unit.rule == SHD_LEVEL_RULE_OPENGL ? opengl_size(unit, d.x, d.y) : axes.longer;
  const double shown = unit.bug == Bug::kShorterAxis ? axes.shorter : found;
  const bool extension = unit.rule == SHD_LEVEL_RULE_OPENGL && unit.isotropy == 0;
  const double count = ceil(used);
  UnitShape out = {log2(shown), log2(axes.longer / (extension ? count : used)), static_cast<int>(count), {}};
  out.d = {axes.axis[0] / static_cast<double>(base.width), axes.axis[1] / static_cast<double>(base.height),
           image.depth ? axes.axis[2] / static_cast<double>(image.depth) : 0};
  return out;
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

/// The point that has the direction of a point beside the image: on another face of a cube, half a turn about the
/// middle of an edge of an octahedral map away, or as far inside of the rim of a disc on the other side.
inline void move_inside(const UnitImage& image, UnitPoint* point, int* face) {
  double &u = (*point)[0], &v = (*point)[1];
  const auto outside = [](double x) { return x < 0 || x > 1; };
  if (image.projection == SHD_PROJECTION_OCTAHEDRAL) {
    u = fmin(fmax(u, -1), 2), v = fmin(fmax(v, -1), 2);
    while (outside(u) || outside(v)) {
      double &out = outside(u) ? u : v, &other = outside(u) ? v : u;
      out = out < 0 ? -out : 2 - out;
      other = 1 - other;
    }
    return;
  }
  if (image.projection == SHD_PROJECTION_CUBE && (outside(u) || outside(v))) {
    long double n[3];
    ref_unproject(SHD_PROJECTION_CUBE, u, v, static_cast<uint32_t>(*face), n);
    const ref_place place = ref_project(SHD_PROJECTION_CUBE, n);
    u = static_cast<double>(place.u), v = static_cast<double>(place.v), *face = static_cast<int>(place.face);
    return;
  }
  const double r = hypot(2 * u - 1, 2 * v - 1);
  if (image.is_flat() || image.projection == SHD_PROJECTION_CUBE || r <= 1) return;
  const double scale = fmin(r - 2, 0) / r;
  u = (1 + (2 * u - 1) * scale) / 2, v = (1 + (2 * v - 1) * scale) / 2;
}

inline Value unit_linear(const UnitImage& image, const Unit& unit, int layer, int level, UnitPoint p) {
  if (!image.is_flat()) move_inside(image, &p, &layer);
  if (unit.bug == Bug::kLevelBit) level = std::min(level ^ 1, image.level_count - 1);
  return Texels{image, unit, layer, level}.linear(p);
}

inline Value unit_nearest(const UnitImage& image, const Unit& unit, int layer, int level, UnitPoint p) {
  if (unit.bug == Bug::kLevelBit) level = std::min(level ^ 1, image.level_count - 1);
  return Texels{image, unit, layer, level}.nearest(p);
}

/// The blend of two levels of TRILINEAR and NEAREST_MIP_LINEAR.
inline Value unit_blend(const UnitImage& image, const Unit& unit, int layer, const UnitPoint& p, double lod) {
  const auto at = image.sampler.filter == SHD_FILTER_NEAREST_MIP_LINEAR ? unit_nearest : unit_linear;
  const int fine = static_cast<int>(floor(lod)), coarse = std::min(fine + 1, image.level_count - 1);
  double s = lod - floor(lod);
  if (unit.bug == Bug::kNoBlend) s = unit.option & 1;
  if (unit.bug == Bug::kBlendFlipped) s = 1 - s;
  const Value a = at(image, unit, layer, fine, p), b = at(image, unit, layer, coarse, p);
  Value out;
  for (size_t c = 0; c < 4; ++c) out[c] = (1 - s) * a[c] + s * b[c];
  return out;
}

inline Value unit_anisotropic(const UnitImage& image, const Unit& unit, int layer, const UnitPoint& p, double lod,
                              const UnitShape& shape) {
  Value sum = {};
  double total = 0;
  for (int k = 0; k < shape.probes; ++k) {
    double t = unit.vulkan_places ? (k + 1.0) / (shape.probes + 1) - 0.5 : (k + 0.5) / shape.probes - 0.5;
    const double weight = exp(-unit.probe_falloff * 4 * t * t);
    if (unit.bug == Bug::kLongLine) t *= unit.a;
    if (unit.bug == Bug::kLineShift) t += unit.a;
    UnitPoint probe;
    for (size_t c = 0; c < 3; ++c) probe[c] = p[c] + t * shape.d[c];
    const Value value = unit_blend(image, unit, layer, probe, lod);
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

/// The filter at a point of an image.
inline Value unit_filter(const UnitImage& image, const Unit& unit, const UnitLookup& lookup, const UnitPoint& p,
                         int layer, const UnitSteps& d) {
  UnitShape shape = {lookup.lod, lookup.lod, 1, {}};
  if (!lookup.has_lod) shape = unit_shape(image, unit, d);
  const double lod = unit_lod(image, unit, shape.lambda);
  const int level = std::min(unit_level(unit, lod), image.level_count - 1);
  switch (image.sampler.filter) {
    case SHD_FILTER_NEAREST: return Texels{image, unit, layer, 0}.nearest(p);
    case SHD_FILTER_BILINEAR:
    case SHD_FILTER_HERMITE: return Texels{image, unit, layer, 0}.linear(p);
    case SHD_FILTER_NEAREST_MIP: return unit_nearest(image, unit, layer, level, p);
    case SHD_FILTER_BILINEAR_MIP: return unit_linear(image, unit, layer, level, p);
    case SHD_FILTER_NEAREST_MIP_LINEAR:
    case SHD_FILTER_TRILINEAR: return unit_blend(image, unit, layer, p, lod);
    default: return unit_anisotropic(image, unit, layer, p, unit_lod(image, unit, shape.probe_lambda), shape);
  }
}

inline void apply_axis_bugs(const Unit& unit, UnitPoint* p) {
  if (unit.bug == Bug::kMirroredAxis) (*p)[unit.option & 1] = 1 - (*p)[unit.option & 1];
  if (unit.bug == Bug::kSwappedAxes) std::swap((*p)[0], (*p)[1]);
}

/// The face of a direction. Directions within 2^-20 of an edge of the cube may be on either face.
inline uint32_t unit_face(const Unit& unit, const long double* n) {
  const uint32_t nearest = ref_face_of(n);
  const long double least = ref_component(n, ref_cube_table[nearest][0]) * (1.0L - 0x1p-20L);
  uint32_t faces[3] = {nearest}, count = 1;
  for (uint32_t face = 0; face < 6; ++face) {
    if (face != nearest && ref_component(n, ref_cube_table[face][0]) >= least) faces[count++] = face;
  }
  return faces[static_cast<uint32_t>(unit.face_tie) % count];
}

/// The point of a direction in its image, and its derivatives.
inline Value unit_direction(const UnitImage& image, const Unit& unit, const UnitLookup& lookup) {
  const long double n[3] = {lookup.p[0], lookup.p[1], lookup.p[2]};
  const bool cube = image.projection == SHD_PROJECTION_CUBE;
  const uint32_t on = cube ? unit_face(unit, n) : 0;
  ref_place place = cube ? ref_on_face(n, on) : ref_project(image.projection, n);
  // The point of another face than the nearest one lies up to 2^-21 beside the face: on its edge.
  const auto inside = [](long double x) { return fminl(fmaxl(x, 0.0L), 1.0L - 0x1p-40L); };
  if (cube && on != ref_face_of(n)) place.u = inside(place.u), place.v = inside(place.v);
  const auto step = [&](const double* d) {
    const long double dn[3] = {d[0], d[1], d[2]};
    const ref_change change = cube ? ref_cube_step(n, dn, on) : ref_step(image.projection, n, dn);
    return UnitPoint{static_cast<double>(change.du), static_cast<double>(change.dv), 0};
  };
  UnitPoint p = {static_cast<double>(place.u), static_cast<double>(place.v), 0};
  int face = cube ? static_cast<int>(on) : lookup.layer;
  if (unit.bug == Bug::kFlippedFace && face == unit.option >> 1) p[unit.option & 1] = 1 - p[unit.option & 1];
  apply_axis_bugs(unit, &p);
  if (unit.bug == Bug::kLayer) face = (face + 1) % image.layers;
  return unit_filter(image, unit, lookup, p, face, {step(lookup.dx), step(lookup.dy)});
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
  if (!image.is_flat()) {
    value = unit_direction(image, unit, lookup);
  } else {
    const shd_sampler_desc& s = image.sampler;
    UnitPoint p = {reduce(s.wrap_u, lookup.p[0]), reduce(s.wrap_v, lookup.p[1]), reduce(s.wrap_w, lookup.p[2])};
    const UnitSteps d = {{lookup.dx[0], lookup.dx[1], lookup.dx[2]}, {lookup.dy[0], lookup.dy[1], lookup.dy[2]}};
    apply_axis_bugs(unit, &p);
    const int layer = unit.bug == Bug::kLayer ? (lookup.layer + 1) % image.layers : lookup.layer;
    value = unit_filter(image, unit, lookup, p, layer, d);
  }
  for (int c = 0; c < 4; ++c)
    value[static_cast<size_t>(c)] = unit_result(image, unit, value[static_cast<size_t>(c)], c);
  if (unit.bug == Bug::kSwappedChannels)
    std::swap(value[unit.option & 3], value[static_cast<size_t>(unit.option >> 2)]);
  return value;
}

}  // namespace ref
