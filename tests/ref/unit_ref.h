// SPDX-License-Identifier: MIT
// A texture unit in doubles, with every freedom that <shd/bounds.h> grants, and with bugs. Its steps are those of the
// Vulkan 1.3 specification, "Image Operations". It shares no code with the bounds.
#pragma once

#include <math.h>

#include <algorithm>
#include <array>
#include <vector>

#include "ref/projection_ref.h"
#include "ref/texture_ref.h"

namespace ref {

using Value = std::array<double, 4>;

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
  kShift,            // the coordinates are (a, b) texels off
  kWrap,             // axis `option` & 1 has wrap `option` >> 1
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
  kFlippedWeight,    // 1 - s or 1 - t, by `option`
  kOneColumn,        // the second column, or row, is the first one
  kFilterFirst,      // sRGB texels are decoded after filtering
  kNoDecode,         // sRGB texels are not decoded
  kAlphaDecoded,     // alpha is decoded
  kAddressBit,       // bit `option` >> 1 of the column or the row is flipped
  kWeightBit,        // bit of s of value a, or of t, is flipped
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
  kNoSeam,           // texels beyond an edge of the cube are those of the edge
  kLargerLevels,     // level sizes are rounded up
  kBorder,           // border texels are 0
  kCount
};

/// A texture unit: its freedoms, and its bug.
struct Unit {
  int subtexel_bits = 8, level_bits = 8, weight_bits = 0, result_bits = 0;
  Rounding rounding[2] = {Rounding::kNearest, Rounding::kNearest}, level_rounding = Rounding::kNearest;
  uint32_t rule = SHD_LEVEL_RULE_LENGTHS;
  double stretch = 0;     // 0..1 within the approximations of the rule
  bool lower_tie = true;  // nearest level: ceil(lod + 1/2) - 1
  bool floats = false;    // coordinates are computed in binary32
  double srgb_error = 0;  // [codes]
  double coordinate_error[2] = {0, 0}, level_error = 0;
  double isotropy = 0;        // 0 = the probes of the rule, 1 = one probe
  bool vulkan_places = true;  // i / (N + 1) - 1/2, else (k + 1/2) / N - 1/2
  double probe_falloff = 0;   // weights exp(-falloff x^2)
  Bug bug = Bug::kNone;
  double a = 0, b = 0;
  int option = 0;
};

/// Levels of the layers of a texture, and the sampler.
struct UnitImage {
  shd_format format;
  int level_count, layers;
  bool cube;
  std::vector<Level> levels;  // [layers][level_count]
  shd_sampler_desc sampler;

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
    const int64_t full = axis ? base.height : base.width, floor_size = axis ? plane().height : plane().width;
    if (unit.bug != Bug::kLargerLevels) return floor_size;
    return (full + (int64_t{1} << level) - 1) >> level;
  }
  Value stored(int of_layer, int64_t x, int64_t y) const {
    const Level& l = image.at(of_layer, level);
    if (unit.bug == Bug::kAddressBit) (unit.option & 1 ? y : x) ^= int64_t{1} << (unit.option >> 1);
    x = std::min(x, l.width - 1), y = std::min(y, l.height - 1);
    const uint8_t* texel = l.texels + (y * l.width + x) * static_cast<int64_t>(shd_format_size(image.format));
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
  Value texel(int64_t i, int64_t j) const {
    if (image.cube) return on_cube(i, j);
    shd_wrap wrap[2] = {image.sampler.wrap_u, image.sampler.wrap_v};
    if (unit.bug == Bug::kWrap) wrap[unit.option & 1] = static_cast<shd_wrap>(unit.option >> 1);
    const int64_t x = wrap_index(wrap[0], i, size(0)), y = wrap_index(wrap[1], j, size(1));
    return x < 0 || y < 0 ? border() : stored(layer, x, y);
  }
  /// Texel coordinate of u; a face of a cube ends at its edges.
  double coordinate(double u, int axis) const {
    const auto n = static_cast<double>(size(axis));
    const double x = unit.floats ? static_cast<double>(static_cast<float>(u) * static_cast<float>(n)) : u * n;
    const double error = unit.coordinate_error[axis] * n * fmax(1, fabs(u));
    const double moved = x + error + (unit.bug == Bug::kShift ? (axis ? unit.b : unit.a) : 0);
    return image.cube ? fmin(fmax(moved, 0), n) : moved;
  }
  double fixed(double x, int axis) const {
    return rounded(x, unit.bug == Bug::kFewBits ? unit.option : unit.subtexel_bits, unit.rounding[axis]);
  }
  Value nearest(double u, double v) const {
    const auto index = [&](double x, int axis) {
      const auto i = static_cast<int64_t>(floor(fixed(coordinate(x, axis), axis)));
      return image.cube ? std::clamp<int64_t>(i, 0, size(axis) - 1) : i;
    };
    return texel(index(u, 0), index(v, 1));
  }
  Value bilinear(double u, double v) const {
    if (unit.bug == Bug::kNoFilter) return nearest(u, v);
    const double x = fixed(coordinate(u, 0) - 0.5, 0), y = fixed(coordinate(v, 1) - 0.5, 1);
    double s = x - floor(x), t = y - floor(y);
    if (unit.bug == Bug::kSwappedWeights) std::swap(s, t);
    double& one = unit.option & 1 ? t : s;
    if (unit.bug == Bug::kFlippedWeight) one = 1 - one;
    if (unit.bug == Bug::kWeightBit) one = fmod(floor(one / unit.a), 2) != 0 ? one - unit.a : one + unit.a;
    const auto i = static_cast<int64_t>(floor(x)), j = static_cast<int64_t>(floor(y));
    const bool column = unit.bug == Bug::kOneColumn && !(unit.option & 1), row = unit.bug == Bug::kOneColumn && !column;
    const Value a = texel(i, j), b = texel(column ? i : i + 1, j), c = texel(i, row ? j : j + 1),
                d = texel(column ? i : i + 1, row ? j : j + 1);
    double w[4] = {(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t};
    if (unit.weight_bits) {
      // The largest weight takes the rest, so that no weight is negative.
      double &largest = *std::max_element(w, w + 4), rest = 1;
      for (double& weight : w) {
        if (&weight == &largest) continue;
        weight = rounded(weight, unit.weight_bits, Rounding::kNearest);
        rest -= weight;
      }
      largest = rest;
    }
    Value out;
    for (size_t k = 0; k < 4; ++k) out[k] = w[0] * a[k] + w[1] * b[k] + w[2] * c[k] + w[3] * d[k];
    return out;
  }
};

}  // namespace ref
