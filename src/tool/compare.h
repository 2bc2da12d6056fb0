// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "tool/picture.h"

/// The absolute difference of the colours of two pictures of one size, times the largest power of two from 1 to 1024
/// that leaves all of it up to 1. The factor and the largest difference are printed on stderr.
Picture difference_of(const Picture& a, const Picture& b);
