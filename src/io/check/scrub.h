// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <shd/io.h>

namespace shd::io {

/// Removes EXIF, XMP, ICC, IPTC and text from PNG, JPEG, TIFF and WebP files in place. Their parsers recurse and have
/// crashed processes, and none of these data change the pixels. Returns the new size. `strict` refuses a PNG with a
/// chunk that is missing, cut off or has a wrong CRC, and a TIFF that is cut off.
size_t scrub(shd_file_format format, unsigned char* bytes, size_t size, bool strict);

}  // namespace shd::io
