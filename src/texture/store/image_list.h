// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>

#include <shd/image.h>
#include <shd/texture.h>

#include "core/executor.h"
#include "core/read_desc.h"
#include "image/format.h"
#include "texture/store/storage.h"

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

/// Calls body(given, image, level) on the executor for each level that a checked desc gives: layer by layer, or the
/// slices of level 1, then of level 2 and so on.
template <class Body>
void for_given_levels(const core::Context& context, const shd_texture_desc& desc, const Body& body) {
  if (desc.depth == 0) {
    return core::parallel_for(context, desc.layer_count * desc.level_count, [&](uint32_t task, uint32_t) {
      body(image_at(desc.level_images, task), task / desc.level_count, task % desc.level_count + 1);
    });
  }
  size_t first = 0;
  for (uint32_t level = 1; level <= desc.level_count; ++level) {
    const uint32_t slices = level_size(desc.depth, level);
    core::parallel_for(context, slices, [&](uint32_t slice, uint32_t) {
      body(image_at(desc.level_images, first + slice), slice, level);
    });
    first += slices;
  }
}

}  // namespace shd::texture
