// SPDX-License-Identifier: MIT
#pragma once
#include "io/maketx/options.h"

/// Makes the output. Throws Failure.
void convert(const Options& options);
