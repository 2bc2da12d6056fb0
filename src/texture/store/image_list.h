// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>

#include <shd/image.h>

#include "core/read_desc.h"
#include "image/format.h"

namespace shd::texture {

/// Returns element i of the caller's array of images, whose elements are struct_size bytes apart.
inline const shd_image* element_of(const shd_image* images, size_t i) {
  return reinterpret_cast<const shd_image*>(reinterpret_cast<const uint8_t*>(images) +
                                            i * core::struct_size_of(images));
}

/// Copies image i of a checked array into the layout of this version and replaces a row stride of 0 by the packed one.
inline shd_image image_at(const shd_image* images, size_t i) {
  shd_image image = shd_image_default();
  const shd_image* given = element_of(images, i);
  const size_t size = core::struct_size_of(given);
  std::memcpy(&image, given, size < sizeof image ? size : sizeof image);
  if (image.row_stride == 0) image.row_stride = image::row_layout(image.format, image.width, image.height).row_size;
  return image;
}

}  // namespace shd::texture
