// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace shd::io {

/// Checks a TGA file (Truevision TGA 2.0) with a width and height above 0. Refuses depths that its kind of image cannot
/// have, palettes whose first index is not 0, files that are too short for their pixels and palette, and pixels outside
/// the palette. The decoder does not check these.
void check_tga_header(const unsigned char* bytes, size_t size);

}  // namespace shd::io
