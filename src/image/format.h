// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/image.h>

namespace shd::image {

/// Storage of one channel.
enum class Component { kUnorm8, kSrgb8, kUnorm16, kFloat16, kFloat32, kRgb9e5 };

/// Layout of a format; all zero for an unknown format.
struct FormatInfo {
  size_t pixel_size;    // bytes
  size_t channel_size;  // bytes; of the whole pixel for kRgb9e5
  size_t channels;      // 1..4
  Component component;  // component of r, g and b; the alpha of kSrgb8 is kUnorm8
};

constexpr FormatInfo format_info(size_t channels, Component component) {
  if (component == Component::kRgb9e5) return {4, 4, channels, component};
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
    case SHD_FORMAT_RGB9E5: return format_info(3, Component::kRgb9e5);
    default: return {0, 0, 0, Component::kUnorm8};
  }
}

/// Whether a pixel is three numbers, which textures store as four.
constexpr bool has_three_numbers(const FormatInfo& format) {
  return format.channels == 3 && format.pixel_size == 3 * format.channel_size;
}

/// Whether the values of a component are codes of 0..1.
constexpr bool is_unorm(Component component) {
  return component == Component::kUnorm8 || component == Component::kSrgb8 || component == Component::kUnorm16;
}

/// Whether the bits of a caller's enum are a format of pixels.
constexpr bool is_format(uint32_t bits) {
  return bits <= SHD_FORMAT_MAX_ENUM && format_info(static_cast<shd_format>(bits)).channels != 0;
}

/// Side of a compressed block [texels].
constexpr uint32_t kBlockSide = 4;

/// Layout of a block-compressed format; all zero for other formats.
struct BlockInfo {
  size_t block_size;    // bytes
  size_t channels;      // channels of a block, 1..4
  size_t stored;        // channels of a decoded texel: 1, 2 or 4
  Component component;  // component of decoded texels
};

constexpr BlockInfo block_info(shd_format format) {
  switch (format) {
    case SHD_FORMAT_BC1_RGB: return {8, 3, 4, Component::kUnorm8};
    case SHD_FORMAT_BC1_RGB_SRGB: return {8, 3, 4, Component::kSrgb8};
    case SHD_FORMAT_BC1_RGBA: return {8, 4, 4, Component::kUnorm8};
    case SHD_FORMAT_BC1_RGBA_SRGB: return {8, 4, 4, Component::kSrgb8};
    case SHD_FORMAT_BC2:
    case SHD_FORMAT_BC3:
    case SHD_FORMAT_BC7: return {16, 4, 4, Component::kUnorm8};
    case SHD_FORMAT_BC2_SRGB:
    case SHD_FORMAT_BC3_SRGB:
    case SHD_FORMAT_BC7_SRGB: return {16, 4, 4, Component::kSrgb8};
    case SHD_FORMAT_BC4: return {8, 1, 1, Component::kUnorm16};
    case SHD_FORMAT_BC4_SNORM: return {8, 1, 1, Component::kFloat32};
    case SHD_FORMAT_BC5: return {16, 2, 2, Component::kUnorm16};
    case SHD_FORMAT_BC5_SNORM: return {16, 2, 2, Component::kFloat32};
    case SHD_FORMAT_BC6H_UFLOAT:
    case SHD_FORMAT_BC6H_SFLOAT: return {16, 3, 4, Component::kFloat16};
    default: return {0, 0, 0, Component::kUnorm8};
  }
}

/// Whether the bits of a caller's enum are a format of blocks.
constexpr bool is_block_format(uint32_t bits) {
  return bits <= SHD_FORMAT_MAX_ENUM && block_info(static_cast<shd_format>(bits)).block_size != 0;
}

/// Rows of an image in memory: of pixels, or of blocks.
struct RowLayout {
  size_t row_size;  // bytes of a packed row
  uint32_t rows;
  size_t alignment;  // alignment of rows [bytes]
};

/// Layout of an image of a known format.
constexpr RowLayout row_layout(shd_format format, uint32_t width, uint32_t height) {
  if (const size_t block_size = block_info(format).block_size) {
    return {(width + kBlockSide - 1) / kBlockSide * block_size, (height + kBlockSide - 1) / kBlockSide, 1};
  }
  return {width * format_info(format).pixel_size, height, format_info(format).channel_size};
}

}  // namespace shd::image
