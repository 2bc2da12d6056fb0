// SPDX-License-Identifier: MIT
#pragma once
#include "tool/handles.h"
#include "tool/options.h"

/// Throws Failure (kExitUsage) for a name whose extension cannot be written, before any time is spent on the picture.
void check_output_name(const Options& options);

/// The name of a picture, counted from 0: the name of the options; for a turntable or frames with -0001 and following before its
/// extension.
std::string picture_name(const Options& options, uint32_t picture);

/// Writes the picture: scene-linear to .exr, through the display transform to all other formats.
void save_picture(shd_context* context, const shd_framebuffer* framebuffer, const Options& options,
                  const std::string& name);
