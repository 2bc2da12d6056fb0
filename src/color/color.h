// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: color, from scene-linear planes to display pixels.
///
/// Input:      framebuffer planes or an RGBA16F / RGBA32F image, scene-linear, premultiplied by alpha.
/// Output:     pixels in the caller's memory, encoded for a display, straight alpha; or an image converted in place.
/// Invariants: a separate library that uses only the public functions of libshd; only ocio.cpp and ocio_parts.cpp use
///             OpenColorIO; the output is finite for any input bits; a baked display has the same bits on every target.
///
/// | file             | contents                                                                |
/// |------------------|-------------------------------------------------------------------------|
/// | default_config.h | the built-in config, as text                                            |
/// | source.h         | choice of config: a path, a text, $OCIO or built-in; read to memory     |
/// | config.h         | a loaded config: its names, and transforms built from it (ocio.cpp)     |
/// | cycle.h          | rejection of colour spaces with a circular definition                   |
/// | pixels.h         | blocks of pixels between the caller's memory and planes                 |
/// | parts.h          | a display transform as matrices, curves, lookup tables and ACES modules |
/// | ocio_transform.h | OpenColorIO's processors, and their parts (ocio_parts.cpp)              |
/// | program.h        | a baked display transform, and its kernels (show.cpp)                   |
/// | bake.h           | parts to a program, and its deviation in 8-bit codes (measure.cpp)      |
/// | baked_views.h    | programs baked so far; views that stay exact                            |
/// | memory.h         | blocks of the context's memory                                          |
/// | apply.h          | a transform over a whole image, on the executor                         |
#pragma once
