// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <shd/lookup.h>

#include "data/column.h"
#include "texture/texture.h"

namespace shd::abi {

constexpr size_t kLookupFloats = texture::kFloatColumns;
constexpr size_t kLookupIntegers = texture::kIntegerColumns;

/// The columns of a caller's shd_lookups, in the order of texture::Lookups.
struct LookupColumns {
  size_t count;
  shd_f32_in floats[kLookupFloats];
  shd_u32_in integers[kLookupIntegers];
};

/// "lookups.u" and so on.
extern const char* const kLookupFloatNames[kLookupFloats];
extern const char* const kLookupIntegerNames[kLookupIntegers];

/// Reads and checks a caller's desc, its columns included.
shd_result read_lookups(const shd_lookups* in, LookupColumns* out);

/// Whether the texture has the table that the filter cannot do without.
shd_result check_tables(const texture::Texture& texture, const texture::Sampler& sampler);

/// Elements of the columns in packed copies; absent columns stay null.
template <size_t kCapacity>
struct LookupStage {
  float floats[kLookupFloats][kCapacity];
  uint32_t integers[kLookupIntegers][kCapacity];

  /// Elements first..first + count - 1, count <= kCapacity; valid as long as this is.
  texture::Lookups load(const LookupColumns& columns, size_t first, size_t count) {
    const float* f[kLookupFloats] = {};
    const uint32_t* n[kLookupIntegers] = {};
    for (size_t i = 0; i < kLookupFloats; ++i) {
      if (!columns.floats[i].data) continue;
      for (size_t k = 0; k < count; ++k) floats[i][k] = data::load(columns.floats[i], first + k);
      f[i] = floats[i];
    }
    for (size_t i = 0; i < kLookupIntegers; ++i) {
      if (!columns.integers[i].data) continue;
      for (size_t k = 0; k < count; ++k) integers[i][k] = data::load(columns.integers[i], first + k);
      n[i] = integers[i];
    }
    return {count, f[0], f[1], f[2], f[3], f[4], f[5], f[6], n[0], n[1]};
  }
};

}  // namespace shd::abi
