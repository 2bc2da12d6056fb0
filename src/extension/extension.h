// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: extension, what libshd_color, libshd_io and libshd_scene share.
///
/// Input:      descs and images of callers, of which nothing is trusted.
/// Output:     checked values, or a Failure; results with a text for shd_last_error().
/// Invariants: reaches libshd through its public functions only; from other folders it takes headers that link to
///             nothing. require() and every function named require_<what> throw a Failure.
///
/// | file    | what                                                             |
/// |---------|------------------------------------------------------------------|
/// | error.h | fail() by way of shd_report_error(), require()                   |
/// | guard.h | the guard of the C functions of these libraries                  |
/// | desc.h  | descs, images and contexts of callers                            |
#pragma once
