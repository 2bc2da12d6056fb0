// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include <shd/column.h>
#include <shd/image.h>

#include "core/desc_size.h"
#include "core/read_desc.h"
#include "core/status.h"

namespace shd::abi {

using core::enum_bits;

/// The name of a field, for messages: "camera.eye".
struct FieldName {
  FieldName(const char* desc, const char* field) { std::snprintf(text, sizeof text, "%s.%s", desc, field); }
  operator const char*() const { return text; }
  char text[64];
};

inline bool is_zero(const float (&v)[3]) {
  return v[0] == 0.0f && v[1] == 0.0f && v[2] == 0.0f;
}

/// Copies the caller's desc over the defaults in `out`. `in` null keeps the defaults if `optional`, else it fails.
template <class Desc>
shd_result read_desc(const char* name, const Desc* in, bool optional, Desc* out) {
  if (!in) {
    if (optional) return SHD_OK;
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: NULL", name);
  }
  return core::read_desc_bytes(core::fail, name, in, core::DescSize<Desc>::kRule, out, sizeof(Desc));
}

/// Checks a struct that the library only writes, and clears it: calls that fail leave it zero.
template <class Desc>
shd_result begin_output(const char* name, Desc* out) {
  if (!out) return core::fail(SHD_ERROR_INVALID_ARGUMENT, "%s: NULL", name);
  if (const shd_result result = core::check_desc_size(core::fail, name, out, core::DescSize<Desc>::kRule)) {
    return result;
  }
  core::clear_desc_bytes(out);
  return SHD_OK;
}

/// Writes a struct into the caller's, which was read by read_desc or begun by begin_output.
template <class Desc>
void write_desc(const Desc& from, Desc* to) {
  core::write_desc_bytes(&from, sizeof from, to);
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
/// Every one of `count` values is finite; the message names the first other one.
shd_result check_finite(const char* field, const float* values, size_t count);
/// Every one of `count` values lies in [low, high]; NaN does not.
shd_result check_values(const char* field, const float* values, size_t count, double low, double high);
/// Alignment, stride and the size of the whole column of elements of `size` bytes; data null is fine.
shd_result check_column(const char* field, const void* data, size_t stride, size_t count, size_t size = 4);
template <class Column>
shd_result check_column(const char* field, const Column& column, size_t count) {
  return check_column(field, column.data, column.stride, count, sizeof *column.data);
}
/// Checks a caller's image of any known format of pixels and copies it, with its row stride filled in.
shd_result read_image(const char* name, const shd_image* in, shd_image* out);
/// As read_image(), but formats of blocks are taken as well.
shd_result read_pixels_or_blocks(const char* name, const shd_image* in, shd_image* out);
/// That two images that read_image has read share no byte.
shd_result check_apart(const char* a_name, const shd_image& a, const char* b_name, const shd_image& b);

}  // namespace shd::abi

/// Returns from the enclosing function unless `expression` is SHD_OK.
#define SHD_TRY(expression)                                        \
  do {                                                             \
    if (const shd_result shd_try_ = (expression)) return shd_try_; \
  } while (0)
