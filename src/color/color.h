// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: color, from scene-linear planes to display pixels.
///
/// Input:      framebuffer planes or an RGBA16F / RGBA32F image, scene-linear, premultiplied by alpha.
/// Output:     pixels in the caller's memory, encoded for a display, straight alpha; or an image converted in place.
/// Invariants: a library of its own that reaches libshd through its public functions only; OpenColorIO is
///             included by ocio.cpp alone; the output is finite for any input bits.
///
/// | file             | what                                                                    |
/// |------------------|-------------------------------------------------------------------------|
/// | default_config.h | the built-in config, as text                                            |
/// | source.h         | which config: a path, a text, $OCIO or the built-in one; read to memory |
/// | config.h         | a loaded config: its names, and transforms built from it (ocio.cpp)     |
/// | cycle.h          | refuses colour spaces that are defined in a circle                      |
/// | pixels.h         | blocks of pixels between the caller's memory and planes                 |
/// | apply.h          | a transform over a whole image, on the executor                         |
#pragma once
