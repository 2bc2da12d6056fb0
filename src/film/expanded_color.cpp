// SPDX-License-Identifier: MIT
#include "film/expanded_color.h"

#include <utility>

#include "image/pixels.h"

namespace shd::film {

ExpandedColor::ExpandedColor(const core::Context& context, Framebuffer* framebuffer)
    : context_(context), framebuffer_(*framebuffer), format_(framebuffer->color_format) {
  if (has_color_planes(framebuffer_)) return;
  core::Array<float> planes[4];
  for (core::Array<float>& plane : planes) {
    plane = core::Array<float>(context.allocator, framebuffer_.stride * framebuffer_.height);
  }
  for (size_t y = 0; y < framebuffer_.height; ++y) {
    float* row[4];
    for (uint32_t c = 0; c < 4; ++c) row[c] = planes[c].data() + y * framebuffer_.stride;
    image::decode_pixels(format_, pixel_at(framebuffer_, 0, y), framebuffer_.width, row);
  }
  for (uint32_t c = 0; c < 4; ++c) framebuffer_.plane[c] = std::move(planes[c]);
  framebuffer_.color_format = SHD_FORMAT_RGBA32F;
}

ExpandedColor::~ExpandedColor() {
  if (framebuffer_.color_format == format_) return;
  framebuffer_.color_format = format_;
  for (size_t y = 0; y < framebuffer_.height; ++y) {
    const float* row[4];
    for (uint32_t c = 0; c < 4; ++c) row[c] = framebuffer_.plane[c].data() + y * framebuffer_.stride;
    image::encode_pixels(context_.simd, format_, row, framebuffer_.width, pixel_at(&framebuffer_, 0, y));
  }
  for (uint32_t c = 0; c < 4; ++c) framebuffer_.plane[c] = core::Array<float>();
}

}  // namespace shd::film
