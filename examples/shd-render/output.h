// SPDX-License-Identifier: MIT
#pragma once
#include "handles.h"
#include "options.h"

/// Throws Failure (kExitUsage) for a name whose extension cannot be written, before any time is spent on the picture.
void check_output_name(const Options& options);

/// Writes the picture: scene-linear to .exr, through the display transform to all other formats.
void save_picture(shd_context* context, const shd_framebuffer* framebuffer, const Options& options);
