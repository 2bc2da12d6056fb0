// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "io/maketx/source.h"

/// An angular probe as the rows of an image of latitude and longitude, which is in memory: as wide, and half as high.
/// Throws Failure: kExitInput if the probe is no square of at least 2 x 2, kExitUsage if it needs more than --memory.
std::unique_ptr<Rows> make_probe(const Options& options, Rows& probe);
