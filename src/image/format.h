// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <shd/image.h>

namespace shd::image {

/// How one channel is stored.
enum class Component { kUnorm8, kSrgb8, kUnorm16, kFloat16, kFloat32 };

/// How a format is laid out; all zero for an unknown one.
struct FormatInfo {
  size_t pixel_size;    // bytes
  size_t channel_size;  // bytes
  size_t channels;      // 1..4
  Component component;  // of r, g and b: the alpha of kSrgb8 is kUnorm8
};

FormatInfo format_info(shd_format format);

}  // namespace shd::image
