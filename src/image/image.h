// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: image, (stored pixels <-> floats).
///
/// Input:      pixels in the layout of a format.
/// Output:     linear floats, and back.
/// Units:      unsigned integer channels are value / maximum in [0, 1]; sRGB channels are encoded, alpha never is.
/// Invariants: every conversion is correctly rounded and defined for all inputs; no libm, so that the bits are the same
///             on every machine. The two functions of srgb.h on doubles are an exception; libshd does not call them.
///
/// | file         | contents                                               |
/// |--------------|--------------------------------------------------------|
/// | format.h     | layout of each pixel format                            |
/// | read_image.h | checks of a caller's shd_image                         |
/// | channel.h    | one stored channel to a number and back, scalar        |
/// | encode-inl.h | vectors of floats to codes                             |
/// | pixels.h     | rows of pixels to floats and back                      |
/// | srgb.h       | sRGB to linear and back (IEC 61966-2-1)                |
/// | dither.h     | thresholds of the ordered dither                       |
/// | half.h       | IEEE 754 binary16 to binary32 and back, nearest even   |
#pragma once
