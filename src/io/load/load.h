// SPDX-License-Identifier: MIT
#pragma once

#include "io/bitmap/bitmap.h"

namespace shd::io {

/// Returns the format of the bytes. Throws Failure unless the options allow it and its header is within the limits.
shd_file_format accept(const unsigned char* bytes, size_t size, const LoadOptions& options);

/// Decodes in this process. Scrubs `bytes` in place. The sink may be null.
Bitmap load(unsigned char* bytes, size_t size, const LoadOptions& options, const Memory& memory,
            const Deadline& deadline, const Sink* sink);

}  // namespace shd::io
