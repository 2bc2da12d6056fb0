// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <shd/image.h>

namespace shd::image {

/// How a format is laid out; all zero for an unknown one.
struct FormatInfo {
  size_t pixel_size;    // bytes
  size_t channel_size;  // bytes
  size_t channels;      // 1 or 4
  bool textures;        // textures can have it
};

FormatInfo format_info(shd_format format);

}  // namespace shd::image
