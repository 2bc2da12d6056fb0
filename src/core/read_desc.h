// SPDX-License-Identifier: MIT
/// @file
/// Structs of callers whose headers may be older or newer than the library. This header needs no library: `fail` is the
/// fail() of the library, which stores a text for shd_last_error() and returns the code.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include <shd/result.h>

namespace shd::core {

/// The number stored in an enum of the caller, which may be any number. Loading it as an enum is undefined for numbers
/// beyond the bits of the enumerators, so that checks must use this number first.
template <class Enum>
uint32_t enum_bits(const Enum& value) {
  static_assert(sizeof value == sizeof(uint32_t));
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

/// Copies the caller's desc over the defaults in `out`. The desc begins with its size, struct_size. `minimum` is the
/// smallest struct_size of any version. Bytes beyond the size of this version must be zero.
template <class Fail>
shd_result read_desc_bytes(Fail fail, const char* name, const void* in, size_t minimum, void* out, size_t out_size) {
  if (reinterpret_cast<uintptr_t>(in) % alignof(uint32_t) != 0) {
    return fail(SHD_ERROR_INVALID_ARGUMENT, "%s: not aligned to %zu bytes", name, alignof(uint32_t));
  }
  uint32_t size;
  std::memcpy(&size, in, sizeof size);
  if (size < minimum) {
    return fail(SHD_ERROR_INVALID_ARGUMENT, "%s.struct_size: %u is below %zu; use the defaults function", name, size,
                minimum);
  }
  constexpr uint32_t kMaxSize = 1u << 16;
  if (size > kMaxSize) {
    return fail(SHD_ERROR_INVALID_ARGUMENT, "%s.struct_size: %u is above %u", name, size, kMaxSize);
  }
  const auto* bytes = static_cast<const unsigned char*>(in);
  for (size_t i = out_size; i < size; ++i) {
    if (bytes[i] != 0) {
      return fail(SHD_ERROR_UNSUPPORTED, "%s: byte %zu is set, but this version reads only %zu bytes", name, i,
                  out_size);
    }
  }
  std::memcpy(out, in, size < out_size ? size : out_size);
  return SHD_OK;
}

}  // namespace shd::core
