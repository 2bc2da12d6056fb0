// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <shd/io.h>

namespace shd::io {

/// Removes EXIF, XMP, ICC, IPTC and text from PNG, JPEG, TIFF and WebP files in place: their parsers recurse and
/// have killed processes, and nothing in them changes the pixels. Returns the new size. `strict` refuses a PNG with
/// a chunk missing, cut off or of a wrong CRC, and a TIFF that is cut off.
size_t scrub(shd_file_format format, unsigned char* bytes, size_t size, bool strict);

}  // namespace shd::io
