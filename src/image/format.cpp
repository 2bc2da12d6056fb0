// SPDX-License-Identifier: MIT
#include "image/format.h"

namespace shd::image {
namespace {

constexpr size_t channel_size(Component component) {
  return component == Component::kFloat32                                       ? 4
         : component == Component::kFloat16 || component == Component::kUnorm16 ? 2
                                                                                : 1;
}

constexpr FormatInfo info(size_t channels, Component component) {
  return {channels * channel_size(component), channel_size(component), channels, component};
}

}  // namespace

FormatInfo format_info(shd_format format) {
  switch (format) {
    case SHD_FORMAT_R8: return info(1, Component::kUnorm8);
    case SHD_FORMAT_RG8: return info(2, Component::kUnorm8);
    case SHD_FORMAT_RGB8: return info(3, Component::kUnorm8);
    case SHD_FORMAT_RGBA8: return info(4, Component::kUnorm8);
    case SHD_FORMAT_R8_SRGB: return info(1, Component::kSrgb8);
    case SHD_FORMAT_RG8_SRGB: return info(2, Component::kSrgb8);
    case SHD_FORMAT_RGB8_SRGB: return info(3, Component::kSrgb8);
    case SHD_FORMAT_RGBA8_SRGB: return info(4, Component::kSrgb8);
    case SHD_FORMAT_R16: return info(1, Component::kUnorm16);
    case SHD_FORMAT_RG16: return info(2, Component::kUnorm16);
    case SHD_FORMAT_RGB16: return info(3, Component::kUnorm16);
    case SHD_FORMAT_RGBA16: return info(4, Component::kUnorm16);
    case SHD_FORMAT_R16F: return info(1, Component::kFloat16);
    case SHD_FORMAT_RG16F: return info(2, Component::kFloat16);
    case SHD_FORMAT_RGB16F: return info(3, Component::kFloat16);
    case SHD_FORMAT_RGBA16F: return info(4, Component::kFloat16);
    case SHD_FORMAT_R32F: return info(1, Component::kFloat32);
    case SHD_FORMAT_RG32F: return info(2, Component::kFloat32);
    case SHD_FORMAT_RGB32F: return info(3, Component::kFloat32);
    case SHD_FORMAT_RGBA32F: return info(4, Component::kFloat32);
    default: return {0, 0, 0, Component::kUnorm8};
  }
}

}  // namespace shd::image
