// SPDX-License-Identifier: MIT
#include "image/format.h"

namespace shd::image {

FormatInfo format_info(shd_format format) {
  switch (format) {
    case SHD_FORMAT_R8: return {1, 1, 1, true};
    case SHD_FORMAT_RGBA8: return {4, 1, 4, true};
    case SHD_FORMAT_RGBA8_SRGB: return {4, 1, 4, true};
    case SHD_FORMAT_RGBA16F: return {8, 2, 4, true};
    case SHD_FORMAT_RGBA32F: return {16, 4, 4, true};
    case SHD_FORMAT_RGBA16: return {8, 2, 4, false};
    default: return {0, 0, 0, false};
  }
}

}  // namespace shd::image
