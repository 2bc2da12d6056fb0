// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace shd::io {

/// Order of the pixels of a file: scan lines are columns, and the picture is mirrored in x or in y.
struct Turn {
  bool columns = false;
  bool mirror_x = false, mirror_y = false;
  bool any() const { return columns || mirror_x || mirror_y; }
};

/// The resolution string of a Radiance picture (Ward, "Radiance File Formats"): "-Y rows +X columns" is upright, and y
/// grows upwards. Throws Failure for pixels that are not RGBE.
Turn read_hdr_header(const unsigned char* bytes, size_t size);

}  // namespace shd::io
