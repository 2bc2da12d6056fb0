// SPDX-License-Identifier: MIT
#include <shd/image.h>

#include "abi/desc.h"
#include "image/format.h"

extern "C" size_t shd_format_size(shd_format format) {
  if (shd::abi::enum_bits(format) > SHD_FORMAT_RGB32F) return 0;
  return shd::image::format_info(format).pixel_size;
}
