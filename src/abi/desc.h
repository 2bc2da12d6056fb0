// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <shd/column.h>
#include <shd/image.h>

#include "core/read_desc.h"
#include "core/status.h"

namespace shd::abi {

using core::enum_bits;

/// Copies the caller's desc over the defaults in `out`. `in` null keeps the defaults if `optional`, else it fails.
template <class Desc>
shd_result read_desc(const char* name, const Desc* in, bool optional, Desc* out) {
  if (!in) {
    if (optional) return SHD_OK;
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: NULL", name);
  }
  return core::read_desc_bytes(core::fail, name, in, sizeof(Desc), out, sizeof(Desc));
}

/// Writes a desc back into the caller's, of which it fills no more than struct_size bytes.
template <class Desc>
void write_desc(const Desc& from, Desc* to) {
  const uint32_t size = to->struct_size;
  std::memcpy(static_cast<void*>(to), &from, size < sizeof from ? size : sizeof from);
  to->struct_size = size;
}

/// Checks that name the field: each answers SHD_OK or SHD_ERROR_INVALID_ARGUMENT.
shd_result check_range(const char* field, double value, double low, double high);
shd_result check_count(const char* field, uint64_t value, uint64_t low, uint64_t high);
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
/// Checks a caller's image of any known format and copies it, with its row stride filled in.
shd_result read_image(const char* name, const shd_image* in, shd_image* out);

}  // namespace shd::abi

/// Returns from the enclosing function unless `expression` is SHD_OK.
#define SHD_TRY(expression)                                        \
  do {                                                             \
    if (const shd_result shd_try_ = (expression)) return shd_try_; \
  } while (0)
