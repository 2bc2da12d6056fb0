// SPDX-License-Identifier: MIT
#pragma once
#include "tool/handles.h"
#include "tool/options.h"

/// Throws Failure (kExitUsage) for a name whose ending cannot be written, so that nobody waits for it in vain.
void check_output_name(const Options& options);

/// The name of a picture, from 0: that of the options, on a turntable with -0001 and on before its ending.
std::string picture_name(const Options& options, uint32_t picture);

/// Writes the picture: scene-linear to .exr, through the display transform to everything else.
void save_picture(shd_context* context, const shd_framebuffer* framebuffer, const Options& options,
                  const std::string& name);
