// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <initializer_list>

#include <shd/bounds.h>
#include <shd/names.h>
#include <shd/shd.h>

#include "command/values.h"

namespace command {

/// The values of an enum, from 0 on, with their names of shd/names.h, in which dashes replace underscores. The values
/// of `left_out` have no rows.
template <class Value>
std::vector<Name<Value>> names_of(const char* (*name_of)(Value), std::initializer_list<Value> left_out = {}) {
  std::vector<Name<Value>> rows;
  for (uint32_t i = 0; name_of(static_cast<Value>(i)); ++i) {
    const auto value = static_cast<Value>(i);
    if (std::find(left_out.begin(), left_out.end(), value) != left_out.end()) continue;
    rows.push_back({name_of(value), value});
    std::replace(rows.back().name.begin(), rows.back().name.end(), '_', '-');
  }
  return rows;
}

// Enums without names in shd/names.h.
inline const Name<uint32_t> kAovs[] = {{"uv", SHD_AOV_UV},
                                       {"normal", SHD_AOV_NORMAL},
                                       {"triangle", SHD_AOV_TRIANGLE},
                                       {"position", SHD_AOV_POSITION},
                                       {"derivatives", SHD_AOV_DERIVATIVES},
                                       {"barycentrics", SHD_AOV_BARYCENTRICS},
                                       {"level", SHD_AOV_LEVEL},
                                       {"draw", SHD_AOV_DRAW},
                                       {"overdraw", SHD_AOV_OVERDRAW},
                                       {"all", 2 * SHD_AOV_OVERDRAW - 1}};
inline const Name<shd_bump> kBumps[] = {
    {"none", SHD_BUMP_NONE}, {"gradient", SHD_BUMP_GRADIENT}, {"texel", SHD_BUMP_TEXEL}};
inline const Name<shd_rules> kRules[] = {{"vulkan", SHD_RULES_VULKAN},
                                         {"d3d11", SHD_RULES_D3D11},
                                         {"webgpu", SHD_RULES_WEBGPU},
                                         {"opengl", SHD_RULES_OPENGL}};

}  // namespace command
