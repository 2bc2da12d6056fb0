// SPDX-License-Identifier: MIT
#pragma once

#include <shd/solid.h>

namespace shd::abi {

/// Reads a caller's solid texture and checks it; messages begin with `name`.
shd_result read_solid(const char* name, const shd_solid_desc* in, shd_solid_desc* out);

}  // namespace shd::abi
