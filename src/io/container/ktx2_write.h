// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <shd/texture_file.h>

namespace shd::io {

/// A texture to write. levels: the images of each level, packed, in the order of a KTX2 file.
struct Ktx2Content {
  shd_format format = SHD_FORMAT_NONE;
  uint32_t width = 0, height = 0;
  uint32_t depth = 0;   // 0 = not a 3D texture
  uint32_t layers = 0;  // 0 = not an array
  uint32_t faces = 1;
  std::vector<std::vector<unsigned char>> levels;
};

/// The bytes of a KTX 2.0 file. Throws Failure.
std::vector<unsigned char> write_ktx2(const Ktx2Content& content, shd_supercompression scheme, int32_t effort);

}  // namespace shd::io
