// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <shd/image.h>

namespace shd::io {

/// Which channels of a file are r, g, b and a; -1 = absent. Grey has one index three times.
struct ChannelMap {
  int index[4];
};

/// Finds the channels by name (any case), else takes the first ones. `alpha` is the file's own alpha channel or -1.
ChannelMap map_channels(const std::vector<std::string>& names, int alpha);

/// Copies pixels of `channel_size`-byte channels, `in_channels` of them from file channel `first` on, to RGBA.
/// An absent alpha becomes 1, an absent colour 0.
void expand_pixels(const ChannelMap& map, int first, const unsigned char* in, size_t in_channels, size_t count,
                   shd_format format, unsigned char* out);

}  // namespace shd::io
