// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace shd::io {

/// Checks a BMP file (Microsoft, "Bitmap Storage"): fails on run-length and embedded compression, on files too
/// short for their pixels and palette, and on pixels outside the palette. The decoder trusts all of these.
void check_bmp_header(const unsigned char* bytes, size_t size);

}  // namespace shd::io
