// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: data, the plain vocabulary of the other folders.
///
/// Input and output: nothing of its own; the types that stages hand to each other.
///
/// | file        | what                                                           |
/// |-------------|----------------------------------------------------------------|
/// | column.h    | reading and writing the caller's strided columns               |
/// | vec3.h      | 3-vectors of floats and doubles, for setup code                |
/// | matrix.h    | products of 4 x 4 matrices                                     |
/// | trig.h      | angles, tangents, sines and cosines, same bits everywhere      |
/// | camera.h    | look-at matrices, same bits everywhere                         |
/// | transform.h | projections, placements and inverses, same bits everywhere     |
#pragma once

#include <cstddef>

namespace shd::data {

/// Columns that kernels read or write are allocated in multiples of this many elements, so that whole vectors
/// may run past the last row. A multiple of the widest vector that shd is compiled for: 16 lanes of AVX-512.
constexpr size_t kRowPad = 64;

constexpr size_t padded(size_t rows) {
  return (rows + kRowPad - 1) / kRowPad * kRowPad;
}

}  // namespace shd::data
