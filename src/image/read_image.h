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
/// function supports a known format; kBlocks: formats of blocks are among them. `fail`: see core/read_desc.h.
template <bool kBlocks = false, class Fail, class Takes>
shd_result read_image(Fail fail, Takes takes, const char* name, const shd_image* in, shd_image* out) {
  constexpr shd_result kInvalid = SHD_ERROR_INVALID_ARGUMENT;
  constexpr uint32_t kMaxSide = 65536;
  *out = shd_image_default();
  if (!in) return fail(kInvalid, "%s: NULL", name);
  const shd_result read = core::read_desc_bytes(fail, name, in, core::DescSize<shd_image>::kRule, out, sizeof *out);
  if (read != SHD_OK) return read;
  const uint32_t format = core::enum_bits(out->format);
  if (!kBlocks && is_block_format(format)) {
    return fail(kInvalid, "%s.format: %u has compressed blocks, which only textures take", name, format);
  }
  if ((!is_format(format) && !is_block_format(format)) || !takes(out->format)) {
    return fail(kInvalid, "%s.format: %u is not a format", name, format);
  }
  if (out->width < 1 || out->width > kMaxSide) {
    return fail(kInvalid, "%s.width: %u is not in 1..%u", name, out->width, kMaxSide);
  }
  if (out->height < 1 || out->height > kMaxSide) {
    return fail(kInvalid, "%s.height: %u is not in 1..%u", name, out->height, kMaxSide);
  }
  if (!out->pixels) return fail(kInvalid, "%s.pixels: NULL", name);
  const RowLayout layout = row_layout(out->format, out->width, out->height);
  const size_t row = layout.row_size;
  if (out->row_stride == 0) out->row_stride = row;
  if (out->row_stride < row) return fail(kInvalid, "%s.row_stride: %zu is below %zu", name, out->row_stride, row);
  if (out->row_stride > PTRDIFF_MAX / layout.rows) {
    return fail(kInvalid, "%s.row_stride: %zu times %u rows exceeds the address space", name, out->row_stride,
                layout.rows);
  }
  const size_t channel = layout.alignment;
  if (reinterpret_cast<uintptr_t>(out->pixels) % channel != 0 || out->row_stride % channel != 0) {
    return fail(kInvalid, "%s.pixels: pixels or row_stride not aligned to a channel of %zu bytes", name, channel);
  }
  return SHD_OK;
}

}  // namespace shd::image
