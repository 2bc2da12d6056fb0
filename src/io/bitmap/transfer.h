// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <shd/io.h>

namespace shd::io {

/// Curves between stored numbers and linear light.
enum class Curve { kUnknown, kLinear, kSrgb, kRec709, kGamma };

/// A curve with its parameter.
struct Transfer {
  Curve curve = Curve::kUnknown;
  double gamma = 1;
};

/// The curve of a colour space by name; shd_bitmap_get_color_space lists the names.
Transfer transfer_of(const std::string& color_space);

/// Number of digits and a point, in any locale of the host; 0 for other texts.
double parse_gamma(const std::string& text);

/// Name of the colour space of a file. `reported` is the name from the decoder, "" = none; `chromaticities` are x, y of
/// red, green, blue and white, or null.
std::string name_color_space(shd_color_encoding wanted, const std::string& reported, bool integers,
                             const float* chromaticities);

/// Converts a stored number to linear light. sRGB: image/srgb.h; Rec709: inverse OETF of ITU-R BT.709-6, 1.2. Odd
/// around 0.
double decode(const Transfer& transfer, double value);

/// Converts RGBA pixels of a bitmap format to linear RGBA32F; alpha is converted without a curve. in and out: [count],
/// packed.
void linearise(const Transfer& transfer, shd_format format, const void* in, size_t count, float* out);

/// Chromaticities of Rec. 709 with D65, in the order of OpenEXR.
constexpr float kRec709[8] = {0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};

}  // namespace shd::io
