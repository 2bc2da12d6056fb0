// SPDX-License-Identifier: MIT
#include <shd/image.h>

#include "image/format.h"

extern "C" size_t shd_format_size(shd_format format) {
  return shd::image::format_info(format).pixel_size;
}
