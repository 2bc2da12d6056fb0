// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace shd::io {

/// Checks a BMP file (Microsoft, "Bitmap Storage") whose width and height passed check_extent(). Refuses run-length and
/// embedded compression, files that are too short for their pixels and palette, and pixels outside the palette. The
/// decoder does not check these.
void check_bmp_header(const unsigned char* bytes, size_t size);

/// Whether the fourth byte of a pixel of 32 bits has no meaning, as with the compression BI_RGB.
bool bmp_has_unused_byte(const unsigned char* bytes, size_t size);

}  // namespace shd::io
