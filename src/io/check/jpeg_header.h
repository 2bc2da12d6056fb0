// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "io/file/limits.h"

namespace shd::io {

/// Checks the frame header of a JPEG file (ITU-T T.81, B.2.2). Refuses sizes beyond the limits, because OpenImageIO
/// decodes every scan of a progressive file when it opens the file, before it reports the size.
/// @param file_size  size of the file before scrubbing
void check_jpeg_header(const unsigned char* bytes, size_t size, size_t file_size, const Limits& limits);

/// Refuses a JPEG file of more than 256 scans. A scan of a few bytes makes the decoder visit every pixel.
void check_jpeg_scans(const unsigned char* bytes, size_t size);

}  // namespace shd::io
