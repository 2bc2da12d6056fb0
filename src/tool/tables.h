// SPDX-License-Identifier: MIT
#pragma once
#include "tool/stage.h"

/// A table of the texture of the options. Throws Failure (kExitInput) for a file that cannot be read.
Picture show_table(shd_context* context, const Options& options);

/// The depths of the first shadow of a frame as greys, from black at the near plane to white at the far one: the faces
/// of a cube side by side, +X, -X, +Y, -Y, +Z, -Z. Throws Failure (kExitUsage) if no light casts a shadow.
Picture show_shadow_map(const Stage& stage, const Frame& frame);
