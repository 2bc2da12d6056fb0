// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: data, plain types that other folders share.
///
/// Input and output: none; the folder defines types that stages pass to each other.
///
/// | file        | contents                                                          |
/// |-------------|-------------------------------------------------------------------|
/// | column.h    | reading and writing the caller's strided columns                  |
/// | vec3.h      | 3-vectors of floats and doubles, for setup code                   |
/// | box_sides.h | sides of a box and their texture coordinates                      |
/// | matrix.h    | products of 4 x 4 matrices                                        |
/// | trig.h      | angles, tangents, sines and cosines, bit-equal on all machines    |
/// | camera.h    | look-at matrices, bit-equal on all machines                       |
/// | transform.h | projections and placements, bit-equal on all machines             |
/// | inverse.h   | inverses of matrices; libshd_io has it, too                       |
/// | compare.h   | comparisons of depths and of texels, by less, equal and greater   |
/// | hash.h      | hashes of words                                                   |
/// | checksum.h  | checksums of stored bytes                                         |
#pragma once

#include <cstddef>

namespace shd::data {

/// Columns that kernels read or write are allocated in multiples of this many elements, so that whole vectors may run
/// past the last row. It is a multiple of the widest vector that shd is compiled for: 16 lanes of AVX-512.
constexpr size_t kRowPad = 64;

constexpr size_t padded(size_t rows) {
  return (rows + kRowPad - 1) / kRowPad * kRowPad;
}

}  // namespace shd::data
