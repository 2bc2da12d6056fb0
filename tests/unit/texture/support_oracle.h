// SPDX-License-Identifier: MIT
// The values and derivatives of the cells of the table of support in doubles.
#pragma once

#include <array>

#include "ref/any_filter_ref.h"
#include "ref/comparison_ref.h"
#include "support_cells.h"

namespace cells {

/// The levels of a shape in the form of the oracles, in memory of its own.
class OracleTexels {
 public:
  explicit OracleTexels(const Shape& shape) {
    const shd::tests::StoredLevels levels(shape.stored);
    const shd::tests::TextureShape& s = shape.stored;
    image_ = {SHD_FORMAT_RGBA8,
              static_cast<int>(levels.count),
              static_cast<int>(s.layers),
              s.projection,
              s.depth,
              {},
              shd_sampler_desc_default()};
    for (uint32_t layer = 0; layer < s.layers; ++layer) {
      for (uint32_t l = 0; l < levels.count; ++l) {
        std::vector<uint8_t> bytes;
        for (uint32_t i = 0; i < (s.depth ? levels.images(l) : 1); ++i) {
          const std::vector<unsigned char>& texels = levels.at(layer + i, l).texels;
          bytes.insert(bytes.end(), texels.begin(), texels.end());
        }
        bytes_.push_back(bytes);
        image_.levels.push_back({nullptr, levels.at(layer, l).width, levels.at(layer, l).height});
      }
    }
  }

  /// The levels with a sampler. The oracles point into this object.
  ref::UnitImage image(const shd_sampler_desc& sampler) const {
    ref::UnitImage image = image_;
    image.sampler = sampler;
    for (size_t i = 0; i < bytes_.size(); ++i) image.levels[i].texels = bytes_[i].data();
    return image;
  }

  /// Makes r 1 where the comparison of a reference with it is true, and else 0.
  void compare(shd_compare compare, float reference) {
    for (std::vector<uint8_t>& level : bytes_) {
      for (size_t i = 0; i < level.size(); i += 4) {
        const float texel = static_cast<float>(level[i]) / 255.0f;
        level[i] = static_cast<uint8_t>(ref::compare(compare, image_.format, reference, texel) * 255.0f);
      }
    }
  }

 private:
  ref::UnitImage image_;
  std::vector<std::vector<uint8_t>> bytes_;
};

constexpr ref::Value kUnknown = {NAN, NAN, NAN, NAN};
inline bool is_known(const ref::Value& value) {
  return !std::isnan(value[0]);
}

/// The largest difference of a channel; infinite if one is NaN.
inline double difference(const ref::Value& a, const ref::Value& b) {
  double largest = 0.0;
  for (size_t c = 0; c < 4; ++c) {
    const double distance = std::fabs(a[c] - b[c]);
    largest = std::isnan(distance) ? HUGE_VAL : std::fmax(largest, distance);
  }
  return largest;
}

/// The error of a value. EXACT has it in the samples of its oracle, and RIPMAP in texels that are rounded to 8 bits.
inline double tolerance_of(shd_filter filter) {
  return 3e-4 + (filter == SHD_FILTER_EXACT ? 3e-3 : 0.0) + (filter == SHD_FILTER_RIPMAP ? 0.5 / 255.0 : 0.0);
}

/// A filter with a set of wraps on a shape, in doubles: values, and derivatives in the three coordinates. A value with
/// a step beside the lookup is unknown, and so is a derivative with a kink.
struct Expected {
  ref::AnyFilter filter;
  std::array<ref::Value, kCount> value;
  std::array<ref::Value, kCount> slope[3];

  Expected(const ref::UnitImage& image, const CellLookups& lookups, bool slopes)
      : filter(image), other_faces_(image, 1) {
    for (size_t i = 0; i < kCount; ++i) {
      const ref::UnitLookup lookup = lookups.at(i);
      value[i] = stable_value(lookup);
      for (size_t axis = 0; slopes && axis < 3; ++axis)
        slope[axis][i] = is_known(value[i]) ? slope_of(lookup, axis) : kUnknown;
    }
  }

 private:
  /// The length of a texel along an axis of the coordinates.
  double texel(size_t axis) const {
    const ref::UnitImage& image = filter.image();
    if (!image.is_flat()) return 2.0 / static_cast<double>(image.at(0, 0).width);
    if (axis == 2) return image.depth ? 1.0 / static_cast<double>(image.depth) : 1.0;
    return 1.0 / static_cast<double>(axis ? image.at(0, 0).height : image.at(0, 0).width);
  }

  /// Compares the value with those of lookups that differ by the errors of floats.
  ref::Value stable_value(const ref::UnitLookup& lookup) const {
    const ref::Value want = filter.value(lookup);
    if (filter.image().sampler.filter == SHD_FILTER_EXACT) return want;  // it is smooth
    const double tolerance = 0.5 * tolerance_of(filter.image().sampler.filter);
    if (difference(other_faces_.value(lookup), want) > tolerance) return kUnknown;
    for (int k = 0; k < 6; ++k) {
      ref::UnitLookup near = lookup;
      for (size_t c = 0; c < 3; ++c) {
        if (k == 0 || k == 1) near.p[c] += (k ? 1.0 : -1.0) * 2e-5 * texel(c);
        if (k == 2 || k == 3) near.p[c] += (k == 2 ? 1.0 : -1.0) * (c == 0 ? 2e-5 : -2e-5) * texel(c);
        if (k == 4 || k == 5) near.dx[c] *= k == 4 ? 1.0 - 1e-5 : 1.0 + 1e-5;
      }
      if (difference(filter.value(near), want) > tolerance) return kUnknown;
    }
    return want;
  }

  /// The mean of the differences on both sides.
  ref::Value slope_of(const ref::UnitLookup& lookup, size_t axis) const {
    const double step = 2e-4 * texel(axis);
    ref::Value at[3];
    for (int k = 0; k < 3; ++k) {
      ref::UnitPoint place = {lookup.p[0], lookup.p[1], lookup.p[2]};
      place[axis] += (k - 1) * step;
      at[k] = filter.value(lookup, place);
    }
    ref::Value out;
    for (size_t c = 0; c < 4; ++c) {
      out[c] = (at[2][c] - at[0][c]) / (2.0 * step);
      if (std::fabs(at[2][c] - 2.0 * at[1][c] + at[0][c]) / step > slope_tolerance(axis)) return kUnknown;
    }
    return out;
  }

 public:
  /// The error of a derivative: a part of the largest derivative of texels of 0 and 1.
  double slope_tolerance(size_t axis) const {
    const bool rounded = filter.image().sampler.filter == SHD_FILTER_RIPMAP;
    return (rounded ? 8e-3 : 4e-3) / texel(axis);
  }

 private:
  ref::AnyFilter other_faces_;
};

/// Channel r of comparison lookups, whose texels are 0 and 1.
inline std::array<ref::Value, kCount> compared_values(const Shape& shape, const shd_sampler_desc& desc,
                                                      const CellLookups& lookups) {
  std::array<ref::Value, kCount> out;
  for (const float reference : kReferences) {
    OracleTexels texels(shape);
    texels.compare(desc.compare, reference);
    shd_sampler_desc numbers = desc;
    numbers.border[0] = ref::compare(desc.compare, SHD_FORMAT_RGBA8, reference, desc.border[0]);
    const Expected want(texels.image(numbers), lookups, false);
    for (size_t i = 0; i < kCount; ++i) {
      if (lookups.reference[i] == reference) out[i] = {want.value[i][0], 0.0, 0.0, 1.0};
    }
  }
  return out;
}

}  // namespace cells
