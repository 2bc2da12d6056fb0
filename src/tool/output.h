// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "tool/handles.h"
#include "tool/options.h"

#ifdef SHD_RENDER_WITH_COLOR
#include <shd/color.h>
using Color = Owned<shd_color, shd_color_release>;
#else
struct Color {};
#endif

/// Throws Failure (kExitUsage) for planes without a file and for a name whose extension cannot be written, and Failure
/// (kExitOutput) for a missing folder, before any time is spent on the picture.
void check_output_name(const Options& options);

/// The name of a picture, counted from 0: the name of the options; for a turntable or frames with -0001 and following
/// before its extension. Empty if it is not saved.
std::string picture_name(const Options& options, uint32_t picture);

/// FNV-1a of the bits of the linear colours.
uint64_t picture_hash(const shd_framebuffer* framebuffer, const Options& options);

/// Opens the colour config if the picture needs it. Throws Failure (kExitUsage) for an unknown display or view.
Color open_color(shd_context* context, const Options& options);

/// Writes the picture: scene-linear to .exr, through the display transform to all other formats.
void save_picture(const Color& color, const shd_framebuffer* framebuffer, const Options& options,
                  const std::string& name);
