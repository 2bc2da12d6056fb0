// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: image, (stored pixels <-> floats).
///
/// Input:      pixels as a format stores them.
/// Output:     linear floats, and back.
/// Units:      unsigned integer channels are value / maximum in [0, 1]; sRGB channels are encoded, alpha never is.
/// Invariants: every conversion is correctly rounded and total; no libm, so the same bits on every machine. The two
///             functions of srgb.h on doubles are the exception; libshd does not call them.
///
/// | file         | what                                                   |
/// |--------------|--------------------------------------------------------|
/// | format.h     | how a pixel format is laid out                         |
/// | read_image.h | checks of a caller's shd_image                         |
/// | srgb.h       | sRGB to linear and back (IEC 61966-2-1)                |
/// | dither.h     | thresholds of the ordered dither                       |
/// | half.h       | IEEE 754 binary16 to binary32 and back, nearest even   |
#pragma once
