// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <iterator>

#include <shd/lookup.h>

#include "abi/batch.h"
#include "texture/support.h"
#include "texture/texture.h"

namespace shd::abi {

constexpr size_t kLookupColumns = texture::kFloatColumns + texture::kIntegerColumns;
using LookupColumns = std::array<InColumn, kLookupColumns>;

/// A column of a caller's lookups. Their tables have the order of texture::Lookups::real() and integer().
template <class Column>
struct LookupRow {
  const char* name;
  Need need;
  Column shd_lookups::*column;
};

inline constexpr LookupRow<shd_f32_in> kFloatRows[] = {
    {"lookups.u", Need::kRequired, &shd_lookups::u},
    {"lookups.v", Need::kRequired, &shd_lookups::v},
    {"lookups.dudx", Need::kOptional, &shd_lookups::dudx},
    {"lookups.dvdx", Need::kOptional, &shd_lookups::dvdx},
    {"lookups.dudy", Need::kOptional, &shd_lookups::dudy},
    {"lookups.dvdy", Need::kOptional, &shd_lookups::dvdy},
    {"lookups.lod", Need::kOptional, &shd_lookups::lod},
    {"lookups.w", Need::kOptional, &shd_lookups::w},
    {"lookups.dwdx", Need::kOptional, &shd_lookups::dwdx},
    {"lookups.dwdy", Need::kOptional, &shd_lookups::dwdy},
    {"lookups.reference", Need::kOptional, &shd_lookups::reference},
};
inline constexpr LookupRow<shd_u32_in> kIntegerRows[] = {
    {"lookups.layer", Need::kOptional, &shd_lookups::layer},
    {"lookups.random", Need::kOptional, &shd_lookups::random},
};
static_assert(std::size(kFloatRows) == texture::kFloatColumns && std::size(kIntegerRows) == texture::kIntegerColumns);

/// Place of `w` among LookupColumns.
constexpr size_t kColumnW = texture::kPlaneColumns;

/// Reads the handles of a texture and of the sampler that filters it.
shd_result read_texture_and_sampler(const shd_texture* texture, const shd_sampler* sampler,
                                    const texture::Texture** texture_body, const texture::Sampler** sampler_body);

/// Reads a caller's desc into columns and their count, and checks them. Columns that the texture ignores are absent.
shd_result read_lookups(const shd_lookups* in, const texture::Texture& texture, LookupColumns* columns, size_t* count);

/// Returns the lookups of a piece whose inputs are LookupColumns.
template <size_t kOut>
texture::Lookups lookups_of(const Piece<kLookupColumns, kOut>& piece) {
  texture::Lookups lookups;
  lookups.count = piece.count;
  for (size_t c = 0; c < texture::kFloatColumns; ++c) lookups.real(c) = piece.floats(c);
  for (size_t c = 0; c < texture::kIntegerColumns; ++c) lookups.integer(c) = piece.integers(texture::kFloatColumns + c);
  return lookups;
}

/// Whether a texture has two coordinates.
shd_result check_flat(const char* field, const texture::Texture& texture);

/// Whether a sampler works with a texture for a use (texture/support.h), and the texture has the table that its filter
/// reads. The lookups have references if the sampler compares.
shd_result check_lookups(const texture::Texture& texture, const texture::Sampler& sampler, texture::Use use);

/// check_lookups() for values of lookups without references.
shd_result check_use(const texture::Texture& texture, const texture::Sampler& sampler);

}  // namespace shd::abi
