// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: extension, the common base of libshd_color, libshd_io, libshd_scene and libshd_embree.
///
/// Input:      untrusted descs and images of callers.
/// Output:     checked values, or a Failure; results with a text for shd_last_error().
/// Invariants: uses only the public functions of libshd, and headers of other folders that need no library. require()
///             and every function named require_<what> throw a Failure.
///
/// | file           | contents                                                         |
/// |----------------|------------------------------------------------------------------|
/// | error.h        | fail() based on shd_report_error(), require()                    |
/// | guard.h        | the guard of the C functions of these libraries                  |
/// | desc.h         | descs, images and contexts of callers                            |
/// | color_planes.h | colour of a framebuffer of any format                            |
#pragma once
