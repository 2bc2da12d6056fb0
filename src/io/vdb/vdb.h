// SPDX-License-Identifier: MIT
#pragma once

#include "io/bitmap/bitmap.h"

namespace shd::io {

/// Reads a grid of an OpenVDB file and sends or stores the voxels of its box, of format R32F.
/// @param sink  or null
Bitmap decode_grid(const unsigned char* bytes, size_t size, const LoadOptions& options, const Memory& memory,
                   const Deadline& deadline, const Sink* sink);

}  // namespace shd::io
