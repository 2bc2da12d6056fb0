// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "io/file/limits.h"

namespace shd::io {

/// Checks the attributes of every part ("OpenEXR File Layout", 2.x). Refuses windows beyond the limits, deep parts and
/// subsampled channels.
void check_exr_header(const unsigned char* bytes, size_t size, const Limits& limits);

}  // namespace shd::io
