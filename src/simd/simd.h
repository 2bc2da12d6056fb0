// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: simd, vocabulary of the kernels.
///
/// Input and output: Highway vectors; every lane is computed only from its own inputs.
/// Invariants: only operations that IEEE 754 rounds correctly (add, multiply, divide, square root) and exact integer
///             operations, so that every target gives the same bits: no fused multiply-add, no approximate reciprocal,
///             no libm. Min and Max never receive a NaN, because targets differ there. round-inl.h is the
///             place of Highway's Floor, Ceil and Round, which lose the sign of a zero on some targets.
///
/// | file           | contents                                             | error                            |
/// |----------------|------------------------------------------------------|----------------------------------|
/// | choices-inl.h  | choices that nearly all lanes decide in one way      | exact                            |
/// | math-inl.h     | Log2, Exp2, Pow, UnitPow; kInvPi                     | stated at each function, tested  |
/// | angle-inl.h    | Atan2; sine and cosine of multiples of pi            | stated at each function, tested  |
/// | vec3-inl.h     | 3-vectors: load, store, sum, dot, cross, unit        | rounding of the operations       |
/// | double-inl.h   | doubles for WebAssembly with Highway 1.0.3           | rounding of the operations       |
/// | finite-inl.h   | tests for finite values                              | exact                            |
/// | hash-inl.h     | hashes of 32-bit words                               | exact                            |
/// | gather-inl.h   | pairs of adjacent 32-bit words at an index           | exact                            |
/// | integer-inl.h  | products of 16-bit integers                          | exact                            |
/// | round-inl.h    | nearest whole numbers, and those below and above     | exact, with the sign of a zero   |
/// | kernel_part.h  | the mark of parts that are inlined                   | none                             |
/// | tail-inl.h     | stores of the first lanes                            | exact                            |
#pragma once
