// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/image.h>

namespace shd::image {

/// Storage of one channel.
enum class Component { kUnorm8, kSrgb8, kUnorm16, kFloat16, kFloat32 };

/// Layout of a format; all zero for an unknown format.
struct FormatInfo {
  size_t pixel_size;    // bytes
  size_t channel_size;  // bytes
  size_t channels;      // 1..4
  Component component;  // component of r, g and b; the alpha of kSrgb8 is kUnorm8
};

constexpr FormatInfo format_info(size_t channels, Component component) {
  const size_t channel_size = component == Component::kFloat32                                       ? 4
                              : component == Component::kFloat16 || component == Component::kUnorm16 ? 2
                                                                                                     : 1;
  return {channels * channel_size, channel_size, channels, component};
}

constexpr FormatInfo format_info(shd_format format) {
  switch (format) {
    case SHD_FORMAT_R8: return format_info(1, Component::kUnorm8);
    case SHD_FORMAT_RG8: return format_info(2, Component::kUnorm8);
    case SHD_FORMAT_RGB8: return format_info(3, Component::kUnorm8);
    case SHD_FORMAT_RGBA8: return format_info(4, Component::kUnorm8);
    case SHD_FORMAT_R8_SRGB: return format_info(1, Component::kSrgb8);
    case SHD_FORMAT_RG8_SRGB: return format_info(2, Component::kSrgb8);
    case SHD_FORMAT_RGB8_SRGB: return format_info(3, Component::kSrgb8);
    case SHD_FORMAT_RGBA8_SRGB: return format_info(4, Component::kSrgb8);
    case SHD_FORMAT_R16: return format_info(1, Component::kUnorm16);
    case SHD_FORMAT_RG16: return format_info(2, Component::kUnorm16);
    case SHD_FORMAT_RGB16: return format_info(3, Component::kUnorm16);
    case SHD_FORMAT_RGBA16: return format_info(4, Component::kUnorm16);
    case SHD_FORMAT_R16F: return format_info(1, Component::kFloat16);
    case SHD_FORMAT_RG16F: return format_info(2, Component::kFloat16);
    case SHD_FORMAT_RGB16F: return format_info(3, Component::kFloat16);
    case SHD_FORMAT_RGBA16F: return format_info(4, Component::kFloat16);
    case SHD_FORMAT_R32F: return format_info(1, Component::kFloat32);
    case SHD_FORMAT_RG32F: return format_info(2, Component::kFloat32);
    case SHD_FORMAT_RGB32F: return format_info(3, Component::kFloat32);
    case SHD_FORMAT_RGBA32F: return format_info(4, Component::kFloat32);
    default: return {0, 0, 0, Component::kUnorm8};
  }
}

/// Whether the bits of a caller's enum are a format.
constexpr bool is_format(uint32_t bits) {
  return bits <= SHD_FORMAT_MAX_ENUM && format_info(static_cast<shd_format>(bits)).channels != 0;
}

}  // namespace shd::image
