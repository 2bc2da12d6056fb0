// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/io.h>

#include "io/limits.h"

namespace shd::io {

/// Format by content; SHD_FILE_FORMAT_NONE when no signature fits.
shd_file_format sniff(const unsigned char* bytes, size_t size);

/// Name for messages, such as "PNG".
const char* format_name(shd_file_format format);

/// Refuses a header that declares a size beyond the limits or a kind of image that is not supported. Formats whose
/// decoder reports the size before it takes memory are checked after opening instead.
void check_header(shd_file_format format, const unsigned char* bytes, size_t size, const Limits& limits);

/// A complete JPEG stream ends with an EOI marker; the decoder silently fills what is missing with grey.
bool jpeg_is_complete(const unsigned char* bytes, size_t size);

}  // namespace shd::io
