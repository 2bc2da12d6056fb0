// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: color, from scene-linear planes to display pixels.
///
/// Input:      framebuffer planes or an RGBA16F / RGBA32F image, scene-linear, premultiplied by alpha.
/// Output:     pixels in the caller's memory, encoded for a display, straight alpha; or an image converted in place.
/// Invariants: a separate library that uses only the public functions of libshd; only ocio.cpp includes OpenColorIO;
///             the output is finite for any input bits.
///
/// | file             | contents                                                                |
/// |------------------|-------------------------------------------------------------------------|
/// | default_config.h | the built-in config, as text                                            |
/// | source.h         | choice of config: a path, a text, $OCIO or built-in; read to memory     |
/// | config.h         | a loaded config: its names, and transforms built from it (ocio.cpp)     |
/// | cycle.h          | rejection of colour spaces with a circular definition                   |
/// | pixels.h         | blocks of pixels between the caller's memory and planes                 |
/// | apply.h          | a transform over a whole image, on the executor                         |
#pragma once
