// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <shd/column.h>
#include <shd/image.h>

#include "core/status.h"

namespace shd::abi {

/// Copies the caller's desc of `in_size` bytes (its struct_size) over the defaults in `out`.
/// `minimum` is the size of the 0.1 layout.
shd_result read_desc_bytes(const char* name, const void* in, size_t minimum, void* out, size_t out_size);

/// `in` null = keep the defaults in `out`, where `optional`; otherwise an error.
template <class Desc>
shd_result read_desc(const char* name, const Desc* in, bool optional, Desc* out) {
  if (!in) {
    if (optional) return SHD_OK;
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: NULL", name);
  }
  return read_desc_bytes(name, in, sizeof(Desc), out, sizeof(Desc));
}

/// Checks that name the field: each answers SHD_OK or SHD_ERROR_INVALID_ARGUMENT.
shd_result check_range(const char* field, double value, double low, double high);
shd_result check_count(const char* field, uint64_t value, uint64_t low, uint64_t high);
/// The number behind an enum, which a C caller may have set to anything: loading it as the enum is undefined
/// for values beyond the enumerators' bits, so it is checked as bytes first.
template <class Enum>
uint32_t enum_bits(const Enum& value) {
  static_assert(sizeof value == sizeof(uint32_t));
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}
template <class Enum>
shd_result check_enum(const char* field, const Enum& value, uint32_t low, uint32_t high) {
  return check_count(field, enum_bits(value), low, high);
}
shd_result check_zero(const char* field, uint64_t value);
shd_result check_flags(const char* field, uint32_t value, uint32_t known);
shd_result check_not_null(const char* field, const void* pointer);
/// Every one of `count` values is finite; the message says which is not.
shd_result check_finite(const char* field, const float* values, size_t count);
/// Every one of `count` values lies in [low, high]; NaN does not.
shd_result check_values(const char* field, const float* values, size_t count, double low, double high);
/// Alignment, stride and the size of the whole column of elements of `size` bytes; data null is fine.
shd_result check_column(const char* field, const void* data, size_t stride, size_t count, size_t size = 4);
template <class Column>
shd_result check_column(const char* field, const Column& column, size_t count) {
  return check_column(field, column.data, column.stride, count, sizeof *column.data);
}
/// A caller's image; `out` gets the row stride filled in. Accepts any known format.
shd_result read_image(const char* name, const shd_image* in, shd_image* out);

}  // namespace shd::abi

/// Returns from the enclosing function unless `expression` is SHD_OK.
#define SHD_TRY(expression)                                        \
  do {                                                             \
    if (const shd_result shd_try_ = (expression)) return shd_try_; \
  } while (0)
