// SPDX-License-Identifier: MIT
#pragma once

#include "io/io.h"

namespace shd::io {

/// Format of the bytes, allowed by the options and with a header within the limits; throws Failure otherwise.
shd_file_format accept(const unsigned char* bytes, size_t size, const LoadOptions& options);

/// Decodes in this process. `bytes` is scrubbed in place.
Bitmap load(unsigned char* bytes, size_t size, const LoadOptions& options, const Memory& memory,
            const Deadline& deadline);

}  // namespace shd::io
