// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/volume_file.h>

namespace shd::io {

/// Bytes of a number of a file of voxels; 0 for an unknown one.
size_t raw_sample_size(shd_raw_sample sample);

/// Texture format of voxels with `channels` numbers, 1..4.
shd_format raw_format(shd_raw_sample sample, uint32_t channels);

/// Whether the texture stores the numbers of the file without conversion.
bool raw_is_stored(shd_raw_sample sample);

/// Reverses the bytes of each number if the file's order is not that of this machine. `bytes`: [count] numbers.
void order_bytes(shd_byte_order order, shd_raw_sample sample, size_t count, unsigned char* bytes);

/// Converts integers in this machine's byte order to the nearest floats. in and out: [count], packed.
void raw_to_floats(shd_raw_sample sample, size_t count, const unsigned char* in, float* out);

/// Reverses the rows of each slice in place: [depth][height] rows of `row` bytes.
void flip_rows(size_t row, uint32_t height, uint32_t depth, unsigned char* voxels);

}  // namespace shd::io
