// SPDX-License-Identifier: MIT
#include "abi/lookup_columns.h"

#include <iterator>

#include "abi/desc.h"
#include "abi/handle.h"

namespace shd::abi {

namespace {

/// One column: of the caller's desc and of the kernels' lookups.
template <class Given, class Element>
struct Row {
  const char* name;
  Need need;
  Given shd_lookups::*given;
  const Element* texture::Lookups::*packed;
};

constexpr Row<shd_f32_in, float> kFloatRows[] = {
    {"lookups.u", Need::kRequired, &shd_lookups::u, &texture::Lookups::u},
    {"lookups.v", Need::kRequired, &shd_lookups::v, &texture::Lookups::v},
    {"lookups.dudx", Need::kOptional, &shd_lookups::dudx, &texture::Lookups::dudx},
    {"lookups.dvdx", Need::kOptional, &shd_lookups::dvdx, &texture::Lookups::dvdx},
    {"lookups.dudy", Need::kOptional, &shd_lookups::dudy, &texture::Lookups::dudy},
    {"lookups.dvdy", Need::kOptional, &shd_lookups::dvdy, &texture::Lookups::dvdy},
    {"lookups.lod", Need::kOptional, &shd_lookups::lod, &texture::Lookups::lod},
};
constexpr Row<shd_u32_in, uint32_t> kIntegerRows[] = {
    {"lookups.layer", Need::kOptional, &shd_lookups::layer, &texture::Lookups::layer},
    {"lookups.random", Need::kOptional, &shd_lookups::random, &texture::Lookups::random},
};
static_assert(std::size(kFloatRows) == texture::kFloatColumns && std::size(kIntegerRows) == texture::kIntegerColumns);

}  // namespace

shd_result read_texture_and_sampler(const shd_texture* texture, const shd_sampler* sampler,
                                    const texture::Texture** texture_body, const texture::Sampler** sampler_body) {
  SHD_TRY(read_handle("texture", texture, core::ObjectType::kTexture, texture_body));
  return read_handle("sampler", sampler, core::ObjectType::kSampler, sampler_body);
}

shd_result read_lookups(const shd_lookups* in, LookupColumns* columns, size_t* count) {
  shd_lookups read = shd_lookups_default();
  SHD_TRY(read_desc("lookups", in, false, &read));
  InColumn* next = columns->data();
  for (const auto& row : kFloatRows) *next++ = in_column(row.name, read.*row.given, row.need);
  for (const auto& row : kIntegerRows) *next++ = in_column(row.name, read.*row.given, row.need);
  *count = read.count;
  return check_columns(columns->data(), columns->size(), read.count);
}

texture::Lookups lookups_of(const void* const* columns, size_t count) {
  texture::Lookups lookups = {};
  lookups.count = count;
  for (const auto& row : kFloatRows) lookups.*row.packed = static_cast<const float*>(*columns++);
  for (const auto& row : kIntegerRows) lookups.*row.packed = static_cast<const uint32_t*>(*columns++);
  return lookups;
}

shd_result check_tables(const texture::Texture& texture, const texture::Sampler& sampler) {
  if (sampler.filter == SHD_FILTER_RIPMAP && !(texture.tables & SHD_TABLE_RIPMAP)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "sampler.filter: RIPMAP, but the texture has no SHD_TABLE_RIPMAP");
  }
  if (sampler.filter == SHD_FILTER_SUMMED_AREA && !(texture.tables & SHD_TABLE_SUMMED_AREA)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "sampler.filter: SUMMED_AREA, but the texture has no SHD_TABLE_SUMMED_AREA");
  }
  return SHD_OK;
}

}  // namespace shd::abi
