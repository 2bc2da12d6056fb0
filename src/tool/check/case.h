// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <map>
#include <vector>

#include <shd/shd.h>

#include "tool/check/options.h"
#include "tool/check/table.h"

/// Columns of lookups, in the order of `Case::column`.
enum Input { kU, kV, kW, kDudx, kDvdx, kDwdx, kDudy, kDvdy, kDwdy, kLod, kReference, kInputs };

/// Names of the columns and of the channels of results.
extern const std::array<const char*, kInputs> kInputNames;
extern const std::array<const char*, 4> kChannelNames;

/// The numbers of 8-bit texels for the filter. Texels of other sizes are kAsStored.
enum class Decode {
  kAsStored,  // code / 255
  kSrgb,      // sRGB, but not alpha
  kTwice,     // sRGB of the number that sRGB gives
  kPower,     // the power 2.2
  kAlphaToo   // sRGB, alpha too
};

/// Whether the library has textures with this decoding.
inline bool is_stored(Decode decode) {
  return decode == Decode::kAsStored || decode == Decode::kSrgb;
}

/// Whether a filter reads other levels than the first one.
inline bool reads_levels(shd_filter filter) {
  return filter != SHD_FILTER_NEAREST && filter != SHD_FILTER_BILINEAR;
}

/// A curve on r, g and b after the filter.
enum class Curve { kNone, kDecoded, kEncoded };

/// Lookups, their results, and all that decides which results are legal. A hypothesis changes a copy.
struct Case {
  shd_sampler_desc sampler;
  shd_rules rules;
  shd_bounds_desc bounds;
  std::map<shd_rules, shd_bounds_desc> bounds_of_rules;  // as `bounds`, for the other APIs
  Decode decode = Decode::kAsStored;
  Curve curve = Curve::kNone;
  std::array<float, 2> shift = {0, 0};             // shift of u and v, in texels of each level that is read
  std::array<std::vector<float>, kInputs> column;  // empty = absent
  std::vector<uint32_t> layer;                     // empty = absent
  std::array<std::vector<float>, 4> result;        // empty = not given
  std::vector<size_t> row;                         // number of each row in the table

  size_t count() const { return row.size(); }
  bool has(Input input) const { return !column[input].empty(); }
  bool is_shifted() const { return shift[0] != 0.0f || shift[1] != 0.0f; }
};

/// Connects columns with lookups and results. Throws Failure.
Case make_case(const Options& options, const Table& table);

/// Some rows of a case, by their places in it.
Case select_rows(const Case& all, const std::vector<size_t>& places);

/// The columns of a case for the library. They lie in the case.
shd_lookups lookups_of(const Case& judged);
