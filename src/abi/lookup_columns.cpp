// SPDX-License-Identifier: MIT
#include "abi/lookup_columns.h"

#include "abi/desc.h"

namespace shd::abi {

const char* const kLookupFloatNames[kLookupFloats] = {"lookups.u",    "lookups.v",    "lookups.dudx", "lookups.dvdx",
                                                      "lookups.dudy", "lookups.dvdy", "lookups.lod"};
const char* const kLookupIntegerNames[kLookupIntegers] = {"lookups.layer", "lookups.random"};

shd_result read_lookups(const shd_lookups* in, LookupColumns* out) {
  shd_lookups read = shd_lookups_default();
  SHD_TRY(read_desc("lookups", in, false, &read));
  SHD_TRY(check_zero("lookups.reserved", read.reserved));
  *out = {
      read.count, {read.u, read.v, read.dudx, read.dvdx, read.dudy, read.dvdy, read.lod}, {read.layer, read.random}};
  for (size_t i = 0; i < kLookupFloats; ++i) SHD_TRY(check_column(kLookupFloatNames[i], out->floats[i], read.count));
  for (size_t i = 0; i < kLookupIntegers; ++i) {
    SHD_TRY(check_column(kLookupIntegerNames[i], out->integers[i], read.count));
  }
  if (read.count == 0) return SHD_OK;
  SHD_TRY(check_not_null("lookups.u.data", read.u.data));
  return check_not_null("lookups.v.data", read.v.data);
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
