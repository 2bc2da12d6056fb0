// SPDX-License-Identifier: MIT
#include "io/channels.h"

#include <cstdint>
#include <cstring>

#include "io/io.h"

namespace shd::io {

namespace {

bool same_letter(const std::string& name, char letter) {
  return name.size() == 1 && (name[0] == letter || name[0] == letter + ('a' - 'A'));
}

int find_channel(const std::vector<std::string>& names, char letter) {
  for (size_t i = 0; i < names.size(); ++i) {
    if (same_letter(names[i], letter)) return static_cast<int>(i);
  }
  return -1;
}

/// Expands pixels with channels of type T to RGBA; `one` is an opaque alpha.
template <class T>
void expand(const ChannelMap& map, int first, const unsigned char* in, size_t in_channels, size_t count, T one,
            unsigned char* out) {
  for (size_t i = 0; i < count; ++i) {
    const unsigned char* pixel = in + i * in_channels * sizeof(T);
    T rgba[4] = {T(), T(), T(), one};
    for (int c = 0; c < 4; ++c) {
      if (map.index[c] >= 0)
        std::memcpy(&rgba[c], pixel + static_cast<size_t>(map.index[c] - first) * sizeof(T), sizeof(T));
    }
    std::memcpy(out + i * sizeof rgba, rgba, sizeof rgba);
  }
}

}  // namespace

ChannelMap map_channels(const std::vector<std::string>& names, int alpha) {
  const int count = static_cast<int>(names.size());
  const int r = find_channel(names, 'R');
  const int g = find_channel(names, 'G');
  const int b = find_channel(names, 'B');
  if (alpha < 0) alpha = find_channel(names, 'A');
  if (r >= 0 && g >= 0 && b >= 0) return {{r, g, b, alpha}};
  if (r >= 0 && g >= 0) return {{r, g, -1, alpha}};
  // Without names, one or two channels including alpha are grey, three or more are colour.
  int plain[3] = {-1, -1, -1};
  int found = 0;
  for (int i = 0; i < count && found < 3; ++i) {
    if (i != alpha) plain[found++] = i;
  }
  const int y = find_channel(names, 'Y');
  if (y >= 0) return {{y, y, y, alpha}};
  if (r >= 0) return {{r, r, r, alpha}};
  if (found == 0) return {{alpha, alpha, alpha, alpha}};
  if (found == 1) return {{plain[0], plain[0], plain[0], alpha}};
  return {{plain[0], plain[1], plain[2], alpha}};
}

void expand_pixels(const ChannelMap& map, int first, const unsigned char* in, size_t in_channels, size_t count,
                   shd_format format, unsigned char* out) {
  switch (format) {
    case SHD_FORMAT_RGBA8: expand<uint8_t>(map, first, in, in_channels, count, 0xff, out); break;
    case SHD_FORMAT_RGBA16: expand<uint16_t>(map, first, in, in_channels, count, 0xffff, out); break;
    case SHD_FORMAT_RGBA16F: expand<uint16_t>(map, first, in, in_channels, count, 0x3c00, out); break;
    default: expand<float>(map, first, in, in_channels, count, 1.0f, out); break;
  }
}

}  // namespace shd::io
