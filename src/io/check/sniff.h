// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/io.h>

#include "io/file/limits.h"

namespace shd::io {

/// Format by content; SHD_FILE_FORMAT_NONE if no signature matches.
shd_file_format sniff(const unsigned char* bytes, size_t size);

/// Name of a format for messages, such as "PNG".
const char* format_name(shd_file_format format);

/// Refuses a header that declares a size beyond the limits or an unsupported kind of image. Formats whose decoder
/// reports the size before it allocates memory are checked after opening instead.
void check_header(shd_file_format format, const unsigned char* bytes, size_t size, const Limits& limits);

/// Whether a JPEG stream ends with an EOI marker. The decoder silently fills missing parts with grey.
bool jpeg_is_complete(const unsigned char* bytes, size_t size);

}  // namespace shd::io
