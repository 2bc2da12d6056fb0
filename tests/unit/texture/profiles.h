// SPDX-License-Identifier: MIT
// Common code of the tests of sampler profiles.
#pragma once

#include "filter_cases.h"

namespace fixture {

constexpr shd_profile kProfiles[] = {SHD_PROFILE_VULKAN, SHD_PROFILE_D3D11, SHD_PROFILE_OIIO};
constexpr shd_filter kFilters[] = {SHD_FILTER_NEAREST_MIP, SHD_FILTER_BILINEAR_MIP, SHD_FILTER_TRILINEAR,
                                   SHD_FILTER_ANISOTROPIC, SHD_FILTER_NEAREST_MIP_LINEAR};
constexpr uint32_t kFilterCount = 5, kProfiledCount = 3 * kFilterCount;

inline shd_sampler_desc make_desc(shd_profile profile, shd_filter filter, uint32_t pair) {
  const float limits[] = {16, 1, 3.5f, 64, 2};
  shd_sampler_desc desc = wrap_desc(filter, pair);
  desc.profile = profile;
  desc.max_anisotropy = limits[(pair + pair / 5) % 5];
  return desc;
}

}  // namespace fixture
