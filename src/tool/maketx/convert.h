// SPDX-License-Identifier: MIT
#pragma once
#include "tool/maketx/options.h"

/// Makes the output. Throws Failure.
void convert(const Options& options);
