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

/// The struct_size with which a sized struct of the caller begins.
inline uint32_t struct_size_of(const void* desc) {
  uint32_t size;
  std::memcpy(&size, desc, sizeof size);
  return size;
}

/// The sizes that a sized struct has in any version: at least `minimum`, and a multiple of `alignment`.
struct SizeRule {
  size_t minimum, alignment;
};

/// Checks a size of a caller's struct; `field` names it.
template <class Fail>
shd_result check_size(Fail fail, const char* name, const char* field, size_t size, const SizeRule& rule) {
  if (size < rule.minimum) {
    return fail(SHD_ERROR_INVALID_ARGUMENT, "%s.%s: %zu is below %zu; use the defaults function", name, field, size,
                rule.minimum);
  }
  constexpr size_t kMaxSize = size_t{1} << 16;
  if (size > kMaxSize) {
    return fail(SHD_ERROR_INVALID_ARGUMENT, "%s.%s: %zu is above %zu", name, field, size, kMaxSize);
  }
  if (size % rule.alignment != 0) {
    return fail(SHD_ERROR_INVALID_ARGUMENT, "%s.%s: %zu is not a multiple of %zu, the alignment of the struct", name,
                field, size, rule.alignment);
  }
  return SHD_OK;
}

/// Checks the address and the struct_size of a caller's struct.
template <class Fail>
shd_result check_desc_size(Fail fail, const char* name, const void* desc, const SizeRule& rule) {
  if (reinterpret_cast<uintptr_t>(desc) % alignof(uint32_t) != 0) {
    return fail(SHD_ERROR_INVALID_ARGUMENT, "%s: not aligned to %zu bytes", name, alignof(uint32_t));
  }
  return check_size(fail, name, "struct_size", struct_size_of(desc), rule);
}

/// Copies the caller's desc over the defaults in `out`. Bytes of a larger desc beyond this version's must be
/// zero.
template <class Fail>
shd_result read_desc_bytes(Fail fail, const char* name, const void* in, const SizeRule& rule, void* out,
                           size_t out_size) {
  if (const shd_result result = check_desc_size(fail, name, in, rule)) return result;
  const uint32_t size = struct_size_of(in);
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

/// Copies `from`, an element of this version, to an element of `to_size` bytes. Bytes beyond this version's
/// become zero.
inline void write_element_bytes(const void* from, size_t from_size, void* to, size_t to_size) {
  std::memcpy(to, from, to_size < from_size ? to_size : from_size);
  if (to_size > from_size) std::memset(static_cast<unsigned char*>(to) + from_size, 0, to_size - from_size);
}

/// Writes a struct of this version into the caller's, whose struct_size was checked. The size stays as it is, no byte
/// beyond it is written, and bytes beyond this version's become zero.
inline void write_desc_bytes(const void* from, size_t from_size, void* to) {
  const uint32_t size = struct_size_of(to);
  write_element_bytes(from, from_size, to, size);
  std::memcpy(to, &size, sizeof size);
}

/// Sets a caller's struct, whose struct_size was checked, to zero behind its struct_size.
inline void clear_desc_bytes(void* desc) {
  const uint32_t size = struct_size_of(desc);
  std::memset(static_cast<unsigned char*>(desc) + sizeof size, 0, size - sizeof size);
}

}  // namespace shd::core
