// SPDX-License-Identifier: MIT
#pragma once

#include <shd/texture.h>

namespace shd::abi {

/// Checks the kind of a desc that was read, and gives the fields of other kinds the values that mean their absence:
/// depth 0, projection NONE, and the number of layers of the kind.
shd_result select_kind(shd_texture_desc* desc);

/// Checks a desc after select_kind(): format, sizes, tables, texels or tiles, levels.
shd_result check_texture_desc(const shd_texture_desc& desc);

}  // namespace shd::abi
