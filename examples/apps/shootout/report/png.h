// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "../picture.h"

namespace shootout {

/// A PNG file of 8 bits a channel (W3C, "Portable Network Graphics Specification", third edition), grey if all pixels
/// are.
std::string png_of(const Picture& picture);
/// A grey PNG of one channel in [0, 1], with half the size: each pixel is the mean of 2 x 2 values, in
/// 32 steps.
std::string half_png_of(const std::vector<float>& map, uint32_t edge);
/// A data URI of a PNG file.
std::string data_uri(const std::string& png);

}  // namespace shootout
