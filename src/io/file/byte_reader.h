// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace shd::io {

/// Bounds-checked reading of numbers from untrusted bytes. Reading past the end gives 0 and clears `ok`.
struct ByteReader {
  const unsigned char* bytes;
  size_t size;
  bool big_endian;
  bool ok = true;
  uint64_t behind = 0;  // bytes of the file that follow and are not here

  bool has(uint64_t at, uint64_t count) const { return at <= size && count <= size - at; }
  bool file_has(uint64_t at, uint64_t count) const { return at <= file_size() && count <= file_size() - at; }
  uint64_t file_size() const { return size + behind; }
  uint64_t number(uint64_t at, size_t count) {
    if (!has(at, count)) {
      ok = false;
      return 0;
    }
    uint64_t value = 0;
    for (size_t i = 0; i < count; ++i) {
      const uint64_t byte = bytes[at + i];
      value |= byte << (8 * (big_endian ? count - 1 - i : i));
    }
    return value;
  }
  uint32_t u8(uint64_t at) { return static_cast<uint32_t>(number(at, 1)); }
  uint32_t u16(uint64_t at) { return static_cast<uint32_t>(number(at, 2)); }
  uint32_t u32(uint64_t at) { return static_cast<uint32_t>(number(at, 4)); }
  uint64_t u64(uint64_t at) { return number(at, 8); }
  bool is(uint64_t at, const void* what, size_t count) const {
    return has(at, count) && std::memcmp(bytes + at, what, count) == 0;
  }
};

}  // namespace shd::io
