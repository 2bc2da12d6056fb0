// SPDX-License-Identifier: MIT
#include "abi/desc.h"

#include <cstring>

#include "image/read_image.h"

namespace shd::abi {

using core::fail;

shd_result check_range(const char* field, double value, double low, double high) {
  if (value >= low && value <= high) return SHD_OK;
  return fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %g is not in %g..%g", field, value, low, high);
}

shd_result check_count(const char* field, uint64_t value, uint64_t low, uint64_t high) {
  if (value >= low && value <= high) return SHD_OK;
  return fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %llu is not in %llu..%llu", field,
              static_cast<unsigned long long>(value), static_cast<unsigned long long>(low),
              static_cast<unsigned long long>(high));
}

shd_result check_zero(const char* field, uint64_t value) {
  if (value == 0) return SHD_OK;
  return fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %llu is not 0", field, static_cast<unsigned long long>(value));
}

shd_result check_flags(const char* field, uint32_t value, uint32_t known) {
  if ((value & ~known) == 0) return SHD_OK;
  return fail(SHD_ERROR_UNSUPPORTED, "%s: bits 0x%x are not known", field, value & ~known);
}

shd_result check_not_null(const char* field, const void* pointer) {
  if (pointer) return SHD_OK;
  return fail(SHD_ERROR_INVALID_ARGUMENT, "%s: NULL", field);
}

shd_result check_finite(const char* field, const float* values, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    if (!std::isfinite(values[i])) {
      return fail(SHD_ERROR_INVALID_ARGUMENT, "%s[%zu]: %g is not finite", field, i, static_cast<double>(values[i]));
    }
  }
  return SHD_OK;
}

shd_result check_values(const char* field, const float* values, size_t count, double low, double high) {
  for (size_t i = 0; i < count; ++i) {
    const double value = static_cast<double>(values[i]);
    if (!(value >= low && value <= high)) {
      return fail(SHD_ERROR_INVALID_ARGUMENT, "%s[%zu]: %g is not in %g..%g", field, i, value, low, high);
    }
  }
  return SHD_OK;
}

shd_result check_column(const char* field, const void* data, size_t stride, size_t count, size_t size) {
  if (!data || count == 0) return SHD_OK;
  if (reinterpret_cast<uintptr_t>(data) % size != 0) {
    return fail(SHD_ERROR_INVALID_ARGUMENT, "%s.data: not aligned to %zu bytes", field, size);
  }
  if (stride % size != 0) {
    return fail(SHD_ERROR_INVALID_ARGUMENT, "%s.stride: %zu is not a multiple of %zu", field, stride, size);
  }
  size_t bytes;
  if (__builtin_mul_overflow(stride ? stride : size, count, &bytes) || bytes > PTRDIFF_MAX) {
    return fail(SHD_ERROR_INVALID_ARGUMENT, "%s: %zu elements of stride %zu exceed the address space", field, count,
                stride);
  }
  return SHD_OK;
}

shd_result read_image(const char* name, const shd_image* in, shd_image* out) {
  const auto takes = [](shd_format) { return true; };
  return image::read_image(core::fail, takes, name, in, out);
}

shd_result read_pixels_or_blocks(const char* name, const shd_image* in, shd_image* out) {
  const auto takes = [](shd_format) { return true; };
  return image::read_image<true>(core::fail, takes, name, in, out);
}

shd_result check_apart(const char* a_name, const shd_image& a, const char* b_name, const shd_image& b) {
  const auto a_begin = reinterpret_cast<uintptr_t>(a.pixels), b_begin = reinterpret_cast<uintptr_t>(b.pixels);
  const size_t a_row = a.width * image::format_info(a.format).pixel_size;
  const size_t b_row = b.width * image::format_info(b.format).pixel_size;
  for (uint32_t i = 0, j = 0; i < a.height && j < b.height;) {  // images may lie beside each other in a larger one
    const uintptr_t a_at = a_begin + i * a.row_stride, b_at = b_begin + j * b.row_stride;
    if (a_at + a_row <= b_at) {
      ++i;
    } else if (b_at + b_row <= a_at) {
      ++j;
    } else {
      return fail(SHD_ERROR_INVALID_ARGUMENT, "%s.pixels: overlaps %s.pixels", a_name, b_name);
    }
  }
  return SHD_OK;
}

namespace {

template <class Desc>
shd_result write_defaults(const Desc& defaults, void* ptr, size_t size) {
  SHD_TRY(core::check_size(fail, "desc_init", "size", size, core::DescSize<Desc>::kRule));
  const auto struct_size = static_cast<uint32_t>(size);
  std::memcpy(ptr, &struct_size, sizeof struct_size);
  core::write_desc_bytes(&defaults, sizeof defaults, ptr);
  return SHD_OK;
}

}  // namespace
}  // namespace shd::abi

extern "C" {

shd_result shd_desc_init(shd_desc_kind kind, void* ptr, size_t size) {
  using shd::abi::write_defaults;
  SHD_TRY(shd::abi::check_not_null("desc_init.ptr", ptr));
  switch (shd::abi::enum_bits(kind)) {
#define SHD_CASE(kind, type, required, last, size_in_0_1) \
  case SHD_DESC_KIND_##kind: return write_defaults(type##_default(), ptr, size);
    SHD_SIZED_STRUCTS(SHD_CASE)
#undef SHD_CASE
    default:
      return shd::core::fail(SHD_ERROR_INVALID_ARGUMENT, "desc_init.kind: %u is not a desc", shd::abi::enum_bits(kind));
  }
}

}  // extern "C"
