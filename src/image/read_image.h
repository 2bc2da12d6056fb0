// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/image.h>

#include "core/desc_size.h"
#include "core/read_desc.h"
#include "image/format.h"

namespace shd::image {

/// Checks a caller's image and copies it, with its row stride filled in. `takes(format)` returns whether the caller's
/// function supports a known format. `fail`: see core/read_desc.h.
template <class Fail, class Takes>
shd_result read_image(Fail fail, Takes takes, const char* name, const shd_image* in, shd_image* out) {
  constexpr shd_result kInvalid = SHD_ERROR_INVALID_ARGUMENT;
  constexpr uint32_t kMaxSide = 65536;
  *out = shd_image_default();
  if (!in) return fail(kInvalid, "%s: NULL", name);
  const shd_result read = core::read_desc_bytes(fail, name, in, core::DescSize<shd_image>::kRequired, out, sizeof *out);
  if (read != SHD_OK) return read;
  const uint32_t format = core::enum_bits(out->format);
  if (!is_format(format) || !takes(out->format)) {
    return fail(kInvalid, "%s.format: %u is not a format", name, format);
  }
  if (out->width < 1 || out->width > kMaxSide) {
    return fail(kInvalid, "%s.width: %u is not in 1..%u", name, out->width, kMaxSide);
  }
  if (out->height < 1 || out->height > kMaxSide) {
    return fail(kInvalid, "%s.height: %u is not in 1..%u", name, out->height, kMaxSide);
  }
  if (!out->pixels) return fail(kInvalid, "%s.pixels: NULL", name);
  const FormatInfo info = format_info(out->format);
  const size_t row = info.pixel_size * out->width;
  if (out->row_stride == 0) out->row_stride = row;
  if (out->row_stride < row) return fail(kInvalid, "%s.row_stride: %zu is below %zu", name, out->row_stride, row);
  if (out->row_stride > PTRDIFF_MAX / out->height) {
    return fail(kInvalid, "%s.row_stride: %zu times %u rows exceeds the address space", name, out->row_stride,
                out->height);
  }
  const size_t channel = info.channel_size;
  if (reinterpret_cast<uintptr_t>(out->pixels) % channel != 0 || out->row_stride % channel != 0) {
    return fail(kInvalid, "%s.pixels: pixels or row_stride not aligned to a channel of %zu bytes", name, channel);
  }
  return SHD_OK;
}

}  // namespace shd::image
