// SPDX-License-Identifier: MIT
#pragma once

#include <shd/texture.h>

namespace shd::abi {

/// Checks that a desc has the fields of its kind alone. A cube map gets its six layers.
shd_result check_kind_fields(shd_texture_desc* desc);

/// Checks a desc after check_kind_fields(): format, sizes, tables, texels or tiles, levels.
shd_result check_texture_desc(const shd_texture_desc& desc);

}  // namespace shd::abi
