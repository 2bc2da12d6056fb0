// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <shd/lookup.h>

#include "abi/batch.h"
#include "texture/texture.h"

namespace shd::abi {

constexpr size_t kLookupColumns = texture::kFloatColumns + texture::kIntegerColumns;
using LookupColumns = std::array<InColumn, kLookupColumns>;

/// Reads the handles of a texture and of the sampler that filters it.
shd_result read_texture_and_sampler(const shd_texture* texture, const shd_sampler* sampler,
                                    const texture::Texture** texture_body, const texture::Sampler** sampler_body);

/// Reads a caller's desc into columns and their count, and checks them.
shd_result read_lookups(const shd_lookups* in, LookupColumns* columns, size_t* count);

/// Returns the lookups of a piece whose inputs are LookupColumns.
template <size_t kOut>
texture::Lookups lookups_of(const Piece<kLookupColumns, kOut>& piece) {
  texture::Lookups lookups;
  lookups.count = piece.count;
  for (size_t c = 0; c < texture::kFloatColumns; ++c) lookups.real(c) = piece.floats(c);
  for (size_t c = 0; c < texture::kIntegerColumns; ++c) lookups.integer(c) = piece.integers(texture::kFloatColumns + c);
  return lookups;
}

/// Whether the texture has the table that the filter cannot do without.
shd_result check_tables(const texture::Texture& texture, const texture::Sampler& sampler);

}  // namespace shd::abi
