// SPDX-License-Identifier: MIT
#pragma once

#include "tool/options.h"

/// A built-in solid texture: colours, octaves and distortion that suit its kind, which the options must name.
shd_solid_desc make_solid(const SolidOptions& options);
