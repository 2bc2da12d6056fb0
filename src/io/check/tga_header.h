// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace shd::io {

/// Checks a TGA file (Truevision TGA 2.0) with a width and height above 0. Refuses depths that its kind of image cannot
/// have, palettes whose first index is not 0, files that are too short for their pixels and palette, pixels outside the
/// palette, and an extension area over the pixels. The decoder does not check these.
void check_tga_header(const unsigned char* bytes, size_t size);

/// Offset of the extension area that decoders read; `size` if there is none.
size_t find_tga_extension(const unsigned char* bytes, size_t size);

/// Size of an extension area of TGA 2.0 in bytes.
constexpr size_t kTgaExtension = 495;

}  // namespace shd::io
