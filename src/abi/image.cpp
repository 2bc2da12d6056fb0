// SPDX-License-Identifier: MIT
#include <shd/image.h>

#include "abi/desc.h"
#include "image/format.h"

extern "C" size_t shd_format_size(shd_format format) {
  if (!shd::image::is_format(shd::abi::enum_bits(format))) return 0;
  return shd::image::format_info(format).pixel_size;
}

extern "C" size_t shd_format_block_size(shd_format format) {
  if (!shd::image::is_block_format(shd::abi::enum_bits(format))) return 0;
  return shd::image::block_info(format).block_size;
}
