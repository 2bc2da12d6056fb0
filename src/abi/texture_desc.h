// SPDX-License-Identifier: MIT
#pragma once

#include <shd/texture.h>

namespace shd::abi {

/// Checks a desc that was read: format, sizes, kind, tables, texels or tiles, levels.
shd_result check_texture_desc(const shd_texture_desc& desc);

}  // namespace shd::abi
