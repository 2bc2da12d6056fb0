// SPDX-License-Identifier: MIT
#pragma once
#include "io/maketx/options.h"

/// Makes all outputs. Returns the exit code of the first one that failed; texts go to standard error. Throws Failure
/// for inputs and outputs that do not fit together.
int convert_all(const Options& options);
