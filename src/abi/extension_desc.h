// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include <shd/image.h>

#include "abi/extension_guard.h"

/// Checks of caller structs, for libraries that reach libshd through its public functions only.
namespace shd::extension {

/// Copies the caller's desc over the defaults in `out`; `in` null keeps the defaults. Throws Failure.
template <class Desc>
void read_desc(const char* name, const Desc* in, Desc* out) {
  if (!in) return;
  if (reinterpret_cast<uintptr_t>(in) % alignof(uint32_t) != 0) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "%s: not aligned to %zu bytes", name, alignof(uint32_t));
  }
  uint32_t size;
  std::memcpy(&size, in, sizeof size);
  if (size < sizeof(Desc)) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "%s.struct_size: %u is below %zu; take the defaults function", name, size,
           sizeof(Desc));
  }
  constexpr uint32_t kMaximum = 1u << 16;
  if (size > kMaximum) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "%s.struct_size: %u is above %u", name, size, kMaximum);
  }
  const auto* bytes = reinterpret_cast<const unsigned char*>(in);
  for (size_t i = sizeof(Desc); i < size; ++i) {
    if (bytes[i] != 0) {
      refuse(SHD_ERROR_UNSUPPORTED, "%s: byte %zu is set, but this version knows %zu bytes only", name, i,
             sizeof(Desc));
    }
  }
  std::memcpy(out, in, sizeof(Desc));
}

/// Whether a format is one of those that images outside textures have: R8 and the ones of four channels.
inline bool is_image_format(shd_format format) {
  return format >= SHD_FORMAT_R8 && format <= SHD_FORMAT_RGBA16;
}

/// Bytes of one channel of such a format.
inline size_t channel_size(shd_format format) {
  switch (format) {
    case SHD_FORMAT_RGBA32F: return 4;
    case SHD_FORMAT_RGBA16F:
    case SHD_FORMAT_RGBA16: return 2;
    default: return 1;
  }
}

/// A caller's image of such a format; the result has its row stride filled in. Throws Failure.
inline shd_image read_image(const char* name, const shd_image* in) {
  constexpr shd_result kInvalid = SHD_ERROR_INVALID_ARGUMENT;
  if (!in) refuse(kInvalid, "%s: NULL", name);
  shd_image image = shd_image_default();
  read_desc(name, in, &image);
  if (!is_image_format(image.format)) {
    refuse(kInvalid, "%s.format: %d is not a format of images", name, static_cast<int>(image.format));
  }
  const size_t pixel = shd_format_size(image.format);
  constexpr uint32_t kMaximum = 65536;
  if (image.width < 1 || image.width > kMaximum) {
    refuse(kInvalid, "%s.width: %u is not in 1..%u", name, image.width, kMaximum);
  }
  if (image.height < 1 || image.height > kMaximum) {
    refuse(kInvalid, "%s.height: %u is not in 1..%u", name, image.height, kMaximum);
  }
  if (!image.pixels) refuse(kInvalid, "%s.pixels: NULL", name);
  const size_t row = pixel * image.width;
  if (image.row_stride == 0) image.row_stride = row;
  if (image.row_stride < row) refuse(kInvalid, "%s.row_stride: %zu is below %zu", name, image.row_stride, row);
  if (image.row_stride > PTRDIFF_MAX / image.height) {
    refuse(kInvalid, "%s.row_stride: %zu times %u rows exceeds the address space", name, image.row_stride,
           image.height);
  }
  const size_t channel = channel_size(image.format);
  if (reinterpret_cast<uintptr_t>(image.pixels) % channel != 0 || image.row_stride % channel != 0) {
    refuse(kInvalid, "%s.pixels: pixels or row_stride not aligned to a channel of %zu bytes", name, channel);
  }
  return image;
}

}  // namespace shd::extension
