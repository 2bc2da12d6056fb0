// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <shd/lookup.h>

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

}  // namespace shd::abi
