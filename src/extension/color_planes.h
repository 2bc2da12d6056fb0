// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <new>

#include <shd/extension.h>
#include <shd/framebuffer.h>

#include "extension/error.h"

namespace shd::extension {

/// The colour of a framebuffer as four planes of linear floats: its own planes, or copies of interleaved colour.
class ColorPlanes {
 public:
  /// Throws Failure and std::bad_alloc.
  ColorPlanes(const shd_framebuffer* framebuffer, const shd_framebuffer_info& info)
      : context_(shd_framebuffer_get_context(framebuffer)) {
    const bool copies = info.color_format != SHD_FORMAT_RGBA32F;
    const size_t plane_size = sizeof(float) * info.width * info.height;
    if (copies) allocate(4 * plane_size);
    for (size_t c = 0; c < 4; ++c) {
      const auto plane = static_cast<shd_plane>(SHD_PLANE_R + c);
      view[c] = shd_plane_view_default();
      if (copies) {
        float* const copy = copies_ + c * (plane_size / sizeof(float));
        const shd_f32_out out = shd_f32_out_column(copy, 0);
        require(shd_framebuffer_read_plane(framebuffer, plane, &out));
        view[c].f32 = copy;
        view[c].row_stride = sizeof(float) * info.width;
      } else {
        require(shd_framebuffer_view_plane(framebuffer, plane, &view[c]));
      }
    }
  }
  ~ColorPlanes() { shd_context_free(context_, copies_, size_, kAlignment); }
  ColorPlanes(const ColorPlanes&) = delete;
  ColorPlanes& operator=(const ColorPlanes&) = delete;

  shd_plane_view view[4];  // r, g, b, a

 private:
  static constexpr size_t kAlignment = 64;

  void allocate(size_t size) {
    copies_ = static_cast<float*>(shd_context_allocate(context_, size, kAlignment));
    if (!copies_) throw std::bad_alloc();
    size_ = size;
  }

  shd_context* const context_;
  float* copies_ = nullptr;
  size_t size_ = 0;
};

}  // namespace shd::extension
