// SPDX-License-Identifier: MIT
// A texture unit in doubles, with every freedom that <shd/bounds.h> grants, and with bugs. Its steps are those of the
// Vulkan 1.3 specification, "Image Operations". It shares no code with the bounds.
#pragma once

#include <math.h>

#include <algorithm>
#include <array>
#include <vector>

#include <shd/bounds.h>

#include "ref/projection_ref.h"
#include "ref/texture_ref.h"

namespace ref {

using Value = std::array<double, 4>;
using UnitPoint = std::array<double, 3>;  // (u, v), or (u, v, w) of a 3D texture

enum class Rounding { kDown, kNearest, kUp };

inline double rounded(double x, int bits, Rounding rounding) {
  const double scaled = ldexp(x, bits);
  return ldexp(rounding == Rounding::kDown ? floor(scaled)
               : rounding == Rounding::kUp ? ceil(scaled)
                                           : floor(scaled + 0.5),
               -bits);
}

/// Errors of a texture unit.
enum class Bug {
  kNone,
  kShift,            // the coordinates are (a, b, c) texels off
  kWrap,             // axis `option` & 3 has wrap `option` >> 2
  kSwappedAxes,      // (v, u)
  kMirroredAxis,     // 1 - u or 1 - v, by `option`
  kLevelShift,       // the level of detail is `a` off
  kLevelScale,       // the level of detail times `a`
  kOneStep,          // derivatives of x, or of y, have no effect, by `option`
  kShorterAxis,      // the shorter axis gives the level
  kOneSize,          // the width, or the height, scales both axes, by `option`
  kNoBias,           // no bias
  kNoClamps,         // no clamps of the level
  kFewBits,          // coordinates have `option` bits
  kFewLevelBits,     // levels have `option` bits
  kSwappedWeights,   // s and t are swapped
  kFlippedWeight,    // 1 - s, 1 - t or 1 - r, by `option`
  kOneColumn,        // the second column, row or slice is the first one
  kFilterFirst,      // sRGB texels are decoded after filtering
  kNoDecode,         // sRGB texels are not decoded
  kAlphaDecoded,     // alpha is decoded
  kAddressBit,       // bit `option` >> 1 of the column or the row is flipped
  kWeightBit,        // bit of s, t or r of value a is flipped
  kResultBit,        // bit `option` & 7 of an 8-bit result is flipped, in channel `option` >> 3
  kLevelBit,         // bit 0 of the level is flipped
  kSwappedChannels,  // channels `option` & 3 and `option` >> 2
  kLayer,            // the next layer or face
  kNoFilter,         // nearest in place of bilinear
  kNoBlend,          // the finer level, or the coarser one, in place of both
  kBlendFlipped,     // the shares of two levels are swapped
  kLongLine,         // the line of probes is `a` times as long
  kWrongLine,        // probes lie along the shorter axis
  kProbeSum,         // the sum of probes is divided by one more, or one less
  kLineShift,        // probes are (a) of the line off
  kFlippedFace,      // s, or t, of face `option` >> 1 is flipped
  kNoSeam,           // texels beyond an edge of directions are those of the edge
  kLargerLevels,     // level sizes are rounded up
  kBorder,           // border texels are 0
  kCount
};

/// A texture unit: its freedoms, and its bug.
struct Unit {
  int subtexel_bits = 8, level_bits = 8, weight_bits = 0, result_bits = 0;
  Rounding rounding[3] = {Rounding::kNearest, Rounding::kNearest, Rounding::kNearest};
  Rounding level_rounding = Rounding::kNearest;
  uint32_t rule = SHD_LEVEL_RULE_LENGTHS;
  double stretch = 0;     // 0..1 within the approximations of the rule
  bool lower_tie = true;  // nearest level: ceil(lod + 1/2) - 1
  bool floats = false;    // coordinates are computed in binary32
  double srgb_error = 0;  // [codes]
  double coordinate_error[3] = {0, 0, 0}, level_error = 0;
  double isotropy = 0;        // 0 = the probes of the rule, 1 = one probe
  bool vulkan_places = true;  // i / (N + 1) - 1/2, else (k + 1/2) / N - 1/2
  double probe_falloff = 0;   // weights exp(-falloff x^2)
  int face_tie = 0;           // face of directions at an edge of the cube, among those that are as near
  Bug bug = Bug::kNone;
  double a = 0, b = 0, c = 0;
  int option = 0;
};

/// Levels of the layers of a texture, and the sampler. A level of a 3D texture has all of its slices, one by one.
struct UnitImage {
  shd_format format;
  int level_count, layers;
  shd_projection projection;
  int64_t depth;              // slices of level 0; 0 = 2D
  std::vector<Level> levels;  // [layers][level_count]
  shd_sampler_desc sampler;

  bool is_flat() const { return projection == SHD_PROJECTION_NONE; }
  int axes() const { return depth ? 3 : 2; }
  const Level& at(int layer, int level) const { return levels[static_cast<size_t>(layer * level_count + level)]; }
};

struct UnitLookup {
  double p[3], dx[3], dy[3], lod;
  bool has_lod;
  int layer;
};

inline double code_decode(shd_format format, const uint8_t* texel, int c, const Unit& unit) {
  const Layout l = layout(format);
  if (l.component != Layout::kSrgb8 || c >= l.channels) return decode(format, texel, c);
  const bool linear =
      c == 3 ? unit.bug != Bug::kAlphaDecoded : unit.bug == Bug::kFilterFirst || unit.bug == Bug::kNoDecode;
  if (linear) return texel[c] / 255.0;
  return srgb_to_linear(fmin(fmax(texel[c] + unit.srgb_error, 0), 255) / 255);
}

struct Texels {
  const UnitImage& image;
  const Unit& unit;
  int layer, level;

  const Level& plane() const { return image.at(layer, level); }
  int64_t size(int axis) const {
    const Level& base = image.at(layer, 0);
    const int64_t full = axis == 2 ? image.depth : axis ? base.height : base.width;
    const int64_t floor_size = axis == 2 ? std::max<int64_t>(full >> level, 1) : axis ? plane().height : plane().width;
    if (unit.bug != Bug::kLargerLevels) return floor_size;
    return (full + (int64_t{1} << level) - 1) >> level;
  }
  Value stored(int of_layer, int64_t x, int64_t y, int64_t z = 0) const {
    const Level& l = image.at(of_layer, level);
    if (unit.bug == Bug::kAddressBit) (unit.option & 1 ? y : x) ^= int64_t{1} << (unit.option >> 1);
    x = std::min(x, l.width - 1), y = std::min(y, l.height - 1);
    if (image.depth) z = std::min(z, std::max<int64_t>(image.depth >> level, 1) - 1);
    const auto bytes = static_cast<int64_t>(shd_format_size(image.format));
    const uint8_t* texel = l.texels + ((z * l.height + y) * l.width + x) * bytes;
    Value value;
    for (int c = 0; c < 4; ++c) value[static_cast<size_t>(c)] = code_decode(image.format, texel, c, unit);
    return value;
  }
  Value border() const {
    Value value = {0, 0, 0, 1};
    for (int c = 0; c < layout(image.format).channels; ++c)
      value[static_cast<size_t>(c)] = unit.bug == Bug::kBorder ? 0 : static_cast<double>(image.sampler.border[c]);
    return value;
  }
  /// A texel of the cube, found by its direction; the missing texel of a corner is the average of three.
  Value on_cube(int64_t i, int64_t j) const {
    const int64_t n = plane().width;
    const auto inside = [&](int64_t k) { return k >= 0 && k < n; };
    if (unit.bug == Bug::kNoSeam || (inside(i) && inside(j)))
      return stored(layer, std::clamp<int64_t>(i, 0, n - 1), std::clamp<int64_t>(j, 0, n - 1));
    if (!inside(i) && !inside(j)) {
      const int64_t x = i < 0 ? 0 : n - 1, y = j < 0 ? 0 : n - 1;
      const Value a = on_cube(x, y), b = on_cube(i, y), d = on_cube(x, j);
      Value mean;
      for (size_t c = 0; c < 4; ++c) mean[c] = (a[c] + b[c] + d[c]) / 3;
      return mean;
    }
    const auto centre = [&](int64_t k) {
      return k < 0 ? -1e-9L : k >= n ? 1 + 1e-9L : (static_cast<long double>(k) + 0.5L) / static_cast<long double>(n);
    };
    long double v[3];
    ref_unproject(SHD_PROJECTION_CUBE, centre(i), centre(j), static_cast<uint32_t>(layer), v);
    const ref_place place = ref_project(SHD_PROJECTION_CUBE, v);
    return stored(static_cast<int>(place.face), std::clamp<int64_t>(static_cast<int64_t>(place.u * n), 0, n - 1),
                  std::clamp<int64_t>(static_cast<int64_t>(place.v * n), 0, n - 1));
  }
  /// A texel of an octahedral map, found by its direction: straight ahead over the edge. The map of one step inwards is
  /// linear, so that as long a step outwards is the reflection of its vector.
  Value on_octahedron(int64_t i, int64_t j) const {
    const int64_t n = plane().width;
    constexpr long double kStep = 1e-7L;
    const auto at = [&](int64_t k, long double inwards) {
      if (k < 0) return inwards;
      return k >= n ? 1 - inwards : (static_cast<long double>(k) + 0.5L) / static_cast<long double>(n);
    };
    long double edge[3], inner[3], beyond[3];
    vector_of(at(i, 0), at(j, 0), edge);
    vector_of(at(i, kStep), at(j, kStep), inner);
    for (int c = 0; c < 3; ++c) beyond[c] = 2 * edge[c] - inner[c];
    const ref_place place = ref_project(SHD_PROJECTION_OCTAHEDRAL, beyond);
    return stored(layer, std::clamp<int64_t>(static_cast<int64_t>(place.u * n), 0, n - 1),
                  std::clamp<int64_t>(static_cast<int64_t>(place.v * n), 0, n - 1));
  }
  /// A vector to the octahedron |x| + |y| + |z| = 1.
  static void vector_of(long double u, long double v, long double* n) {
    ref_unproject(SHD_PROJECTION_OCTAHEDRAL, u, v, 0, n);
    const long double sum = fabsl(n[0]) + fabsl(n[1]) + fabsl(n[2]);
    for (int c = 0; c < 3; ++c) n[c] /= sum;
  }
  /// A texel of a disc. One beyond the rim is the texel of the point as far inside, on the other side, and at least
  /// half the diagonal of a texel inside.
  Value on_disc(int64_t i, int64_t j) const {
    const auto n = static_cast<double>(plane().width);
    const double p = (2 * static_cast<double>(i) + 1) / n - 1, q = (2 * static_cast<double>(j) + 1) / n - 1;
    const double r = hypot(p, q), inner = fmax(fmin(2 - r, 1 - sqrt(2) / n), 0);
    if (r <= 1) return stored(layer, i, j);
    const auto index = [&](double x) {
      return std::clamp<int64_t>(static_cast<int64_t>(floor((1 - x / r * inner) / 2 * n)), 0, plane().width - 1);
    };
    return stored(layer, index(p), index(q));
  }
  Value texel(int64_t i, int64_t j, int64_t k) const {
    const bool cube = image.projection == SHD_PROJECTION_CUBE;
    if (!image.is_flat() && !cube && unit.bug == Bug::kNoSeam)
      return stored(layer, std::clamp<int64_t>(i, 0, size(0) - 1), std::clamp<int64_t>(j, 0, size(1) - 1));
    if (cube) return on_cube(i, j);
    if (image.projection == SHD_PROJECTION_OCTAHEDRAL) return on_octahedron(i, j);
    if (!image.is_flat()) return on_disc(i, j);
    shd_wrap wrap[3] = {image.sampler.wrap_u, image.sampler.wrap_v, image.sampler.wrap_w};
    if (unit.bug == Bug::kWrap) wrap[unit.option & 3] = static_cast<shd_wrap>(unit.option >> 2);
    const int64_t x = wrap_index(wrap[0], i, size(0)), y = wrap_index(wrap[1], j, size(1));
    const int64_t z = image.depth ? wrap_index(wrap[2], k, size(2)) : 0;
    return x < 0 || y < 0 || z < 0 ? border() : stored(layer, x, y, z);
  }
  /// Texel coordinate of u; images of directions end at their edges.
  double coordinate(double u, int axis) const {
    const auto n = static_cast<double>(size(axis));
    const double x = unit.floats ? static_cast<double>(static_cast<float>(u) * static_cast<float>(n)) : u * n;
    const double error = unit.coordinate_error[axis] * n * fmax(1, fabs(u));
    const double shift[3] = {unit.a, unit.b, unit.c};
    const double moved = x + error + (unit.bug == Bug::kShift ? shift[axis] : 0);
    return image.is_flat() ? moved : fmin(fmax(moved, 0), n);
  }
  double fixed(double x, int axis) const {
    return rounded(x, unit.bug == Bug::kFewBits ? unit.option : unit.subtexel_bits, unit.rounding[axis]);
  }
  Value nearest(const UnitPoint& p) const {
    int64_t index[3] = {};
    for (int a = 0; a < image.axes(); ++a) {
      index[a] = static_cast<int64_t>(floor(fixed(coordinate(p[static_cast<size_t>(a)], a), a)));
      if (!image.is_flat()) index[a] = std::clamp<int64_t>(index[a], 0, size(a) - 1);
    }
    if (!image.is_flat()) return stored(layer, index[0], index[1]);
    return texel(index[0], index[1], index[2]);
  }
  Value linear(const UnitPoint& p) const {
    if (unit.bug == Bug::kNoFilter) return nearest(p);
    int64_t first[3] = {};
    double s[3] = {};
    for (int a = 0; a < image.axes(); ++a) {
      const double x = fixed(coordinate(p[static_cast<size_t>(a)], a) - 0.5, a);
      first[a] = static_cast<int64_t>(floor(x));
      s[a] = x - floor(x);
      if (image.sampler.filter == SHD_FILTER_HERMITE) s[a] = hermite_weight(s[a]);
    }
    if (unit.bug == Bug::kSwappedWeights) std::swap(s[0], s[1]);
    double& one = s[unit.option % image.axes()];
    if (unit.bug == Bug::kFlippedWeight) one = 1 - one;
    if (unit.bug == Bug::kWeightBit) one = fmod(floor(one / unit.a), 2) != 0 ? one - unit.a : one + unit.a;
    const int corners = 1 << image.axes();
    double w[8];
    for (int k = 0; k < corners; ++k) {
      w[k] = 1;
      for (int a = 0; a < image.axes(); ++a) w[k] *= k >> a & 1 ? s[a] : 1 - s[a];
    }
    round_weights(w, corners);
    Value out = {};
    for (int k = 0; k < corners; ++k) {
      int64_t at[3];
      for (int a = 0; a < 3; ++a) {
        const bool stuck = unit.bug == Bug::kOneColumn && a == unit.option % image.axes();
        at[a] = first[a] + (stuck ? 0 : k >> a & 1);
      }
      const Value value = texel(at[0], at[1], at[2]);
      for (size_t c = 0; c < 4; ++c) out[c] += w[k] * value[c];
    }
    return out;
  }
  /// The largest weight takes the rest, so that no weight is negative. Eight weights need another bit for the sum of
  /// their errors.
  void round_weights(double* w, int count) const {
    if (!unit.weight_bits) return;
    double &largest = *std::max_element(w, w + count), rest = 1;
    for (int k = 0; k < count; ++k) {
      if (&w[k] == &largest) continue;
      w[k] = rounded(w[k], unit.weight_bits + (count == 8), Rounding::kNearest);
      rest -= w[k];
    }
    largest = rest;
  }
};

}  // namespace ref
