// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <shd/image.h>

namespace shd::io {

/// Indices of the file channels r, g, b and a; -1 = absent. A grey file has one index three times.
struct ChannelMap {
  int index[4];
};

/// Finds the channels by name (any case), otherwise uses the first channels. `alpha` is the file's own alpha channel
/// or -1.
ChannelMap map_channels(const std::vector<std::string>& names, int alpha);

/// Expands pixels to RGBA. `in` has `in_channels` channels per pixel, from file channel `first` on. An absent alpha
/// becomes 1, an absent colour 0.
void expand_pixels(const ChannelMap& map, int first, const unsigned char* in, size_t in_channels, size_t count,
                   shd_format format, unsigned char* out);

}  // namespace shd::io
