// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: procedural, (places -> values of solid textures).
///
/// Input:      a checked shd_solid_desc as a Solid; places and widths as packed columns.
/// Output:     values, their gradients and colours as packed columns; the number of places that are not finite.
/// Units:      places, widths and gradients in the units of the caller; kernels divide by the size of a cell.
/// Invariants: a value depends only on its own place and width; every target gives the same bits; kernels read and
///             write no element past the last one.
///
/// | file              | contents                                                            |
/// |-------------------|---------------------------------------------------------------------|
/// | solid.h           | Solid, and the evaluation of batches                                |
/// | gradient_table.h  | permutation and gradients of the classic Perlin noise               |
/// | batch-inl.h       | loops over the rows of a batch                                      |
/// | wave-inl.h        | the square wave of stripes and checkers, and its average over pixels |
/// | lattice-inl.h     | cells of the integer lattice, their hashes, weights of their corners |
/// | octaves-inl.h     | sums of octaves, and their band limit                               |
/// | perlin-inl.h      | hashed Perlin noise of one octave                                   |
/// | stripes.cpp       | kernel                                                              |
/// | checker.cpp       | kernel                                                              |
/// | perlin.cpp        | kernel: hashed gradients                                            |
/// | perlin_table.cpp  | kernel: gradients of a table                                        |
/// | value.cpp         | kernel                                                              |
/// | simplex.cpp       | kernel                                                              |
/// | worley.cpp        | kernel                                                              |
/// | marble.cpp        | kernel                                                              |
/// | wood.cpp          | kernel                                                              |
/// | colors.cpp        | kernel: colours of values                                           |
#pragma once
