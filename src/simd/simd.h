// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: simd, what kernels are written with.
///
/// Input and output: Highway vectors; every lane is computed from its own inputs only.
/// Invariants: only operations that IEEE 754 rounds correctly (add, multiply, divide, square root) and exact integer
///             work, so that every target gives the same bits: no fused multiply-add, no approximate reciprocal, no
///             libm. Min and Max see no NaN (targets differ there).
///
/// | file           | what                                        | error                            |
/// |----------------|---------------------------------------------|----------------------------------|
/// | math-inl.h     | Log2, Exp2, Pow, UnitPow                    | stated at each, tested           |
/// | vec3-inl.h     | three-component columns: sum, dot, unit     | the operations' own rounding     |
#pragma once
