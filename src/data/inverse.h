// SPDX-License-Identifier: MIT
#pragma once

namespace shd::data {

/// The inverse of a finite matrix; false, with `out` undefined, if it is singular to within the rounding of double.
bool invert(const float m[16], double out[16]);
bool invert(const double m[16], double out[16]);

/// The inverse of the upper left 3 x 3, [9]; false as above.
bool invert_linear(const float m[16], double out[9]);

}  // namespace shd::data
