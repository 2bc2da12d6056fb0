// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <shd/texture_file.h>

namespace shd::io {

/// Decompresses a whole stream of Zstandard or zlib into exactly `out_size` bytes. Throws Failure: SHD_ERROR_CORRUPT
/// for damaged streams and those of another size, SHD_ERROR_UNSUPPORTED if this build lacks the library.
void inflate_level(shd_supercompression scheme, const unsigned char* in, size_t in_size, unsigned char* out,
                   size_t out_size);

/// Largest `effort` of shd_ktx2_desc; 0 if this build lacks the library.
int32_t most_effort(shd_supercompression scheme);

/// Compresses bytes; effort 0 is the library's default. Throws Failure.
std::vector<unsigned char> deflate_level(shd_supercompression scheme, int32_t effort,
                                         const std::vector<unsigned char>& in);

}  // namespace shd::io
