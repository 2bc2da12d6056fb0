// SPDX-License-Identifier: MIT
#pragma once
#include "handles.h"
#include "options.h"

/// Throws Failure (kExitUsage) for a name whose ending cannot be written, so that nobody waits for it in vain.
void check_output_name(const Options& options);

/// Writes the picture: scene-linear to .exr, through the display transform to everything else.
void save_picture(shd_context* context, const shd_framebuffer* framebuffer, const Options& options);
