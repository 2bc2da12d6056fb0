// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

#include <shd/image.h>

namespace shd::io {

/// Indices of the file channels r, g, b and a; -1 = absent. A grey file has one index three times.
struct ChannelMap {
  int index[4];
};

/// Pixels before their expansion to RGBA: `channels` values of the bitmap's type, 1..4, to which the map refers.
struct Packing {
  int channels;
  ChannelMap map;
};

/// Pixels that are RGBA already.
constexpr Packing kExpanded = {4, {{0, 1, 2, 3}}};

/// Pixels of one channel that stay so.
constexpr Packing kSingle = {1, {{0, 0, 0, -1}}};

inline bool operator==(const Packing& a, const Packing& b) {
  return a.channels == b.channels && std::equal(std::begin(a.map.index), std::end(a.map.index), b.map.index);
}

/// Finds the channels by name (any case), otherwise uses the first channels. `alpha` is the file's own alpha channel
/// or -1.
ChannelMap map_channels(const std::vector<std::string>& names, int alpha);

/// Expands pixels to RGBA. `in` has `in_channels` channels per pixel, from file channel `first` on. An absent alpha
/// becomes 1, an absent colour 0.
void expand_pixels(const ChannelMap& map, int first, const unsigned char* in, size_t in_channels, size_t count,
                   shd_format format, unsigned char* out);

}  // namespace shd::io
