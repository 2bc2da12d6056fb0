// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>

#include "abi/desc.h"
#include "texture/store/image_list.h"
#include "texture/store/storage.h"

namespace shd::abi {

/// Checks that an element of an array of images, called `element`, has the struct_size of the first one. Call it before
/// the element is read, because elements lie struct_size bytes apart.
inline shd_result check_same_size(const char* element, const shd_image* given, const char* first_name,
                                  const shd_image* first) {
  const uint32_t own = core::struct_size_of(given), want = core::struct_size_of(first);
  if (own == want) return SHD_OK;
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s.struct_size: %u is not the %u of %s", element, own, want,
                    first_name);
}

/// Checks element i of an array of images as a level of a base of a known format.
inline shd_result check_level(const char* name, const shd_image* levels, size_t i, uint32_t level, shd_format format,
                              uint32_t width, uint32_t height) {
  char element[48], first[48], field[64];
  std::snprintf(element, sizeof element, "%s[%zu]", name, i);
  std::snprintf(first, sizeof first, "%s[0]", name);
  shd_image image;
  const shd_image* given = texture::element_of(levels, i);
  SHD_TRY(check_same_size(element, given, first, levels));
  SHD_TRY(read_pixels_or_blocks(element, given, &image));
  if (image.format != format) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s.format: %d is not the base's %d", element,
                      static_cast<int>(image.format), static_cast<int>(format));
  }
  const uint32_t level_width = texture::level_size(width, level), level_height = texture::level_size(height, level);
  std::snprintf(field, sizeof field, "%s.width", element);
  SHD_TRY(check_count(field, image.width, level_width, level_width));
  std::snprintf(field, sizeof field, "%s.height", element);
  return check_count(field, image.height, level_height, level_height);
}

/// Checks [layers][count] images as levels 1..count.
inline shd_result check_levels(const char* name, const shd_image* levels, uint32_t layers, uint32_t count,
                               shd_format format, uint32_t width, uint32_t height) {
  if (count > 0) SHD_TRY(check_not_null(name, levels));
  for (size_t i = 0; i < size_t{layers} * count; ++i) {
    SHD_TRY(check_level(name, levels, i, static_cast<uint32_t>(i % count) + 1, format, width, height));
  }
  return SHD_OK;
}

/// Checks the slices of level 1, then of level 2 and so on, of a 3D texture.
inline shd_result check_slices(const char* name, const shd_image* levels, uint32_t count, shd_format format,
                               uint32_t width, uint32_t height, uint32_t depth) {
  size_t i = 0;
  for (uint32_t level = 1; level <= count; ++level) {
    for (uint32_t end = texture::level_size(depth, level); end > 0; --end, ++i) {
      SHD_TRY(check_level(name, levels, i, level, format, width, height));
    }
  }
  return SHD_OK;
}

}  // namespace shd::abi
