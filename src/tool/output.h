// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tool/handles.h"
#include "tool/options.h"

#ifdef SHD_RENDER_WITH_COLOR
#include <shd/color.h>
using Color = Owned<shd_color, shd_color_release>;
#else
struct Color {};
#endif

/// The type of a name that means standard input or output: "" of "-", ".obj" of "obj:-". None for names of files.
std::optional<std::string> stream_type(const std::string& name);

/// Sends what was printed to standard output. Throws Failure (kExitOutput), also if nobody reads it any longer.
void flush_stream();

/// Throws Failure (kExitUsage) for planes without a file and for a name or a compression that cannot be written, and
/// Failure (kExitOutput) for a missing folder, before any time is spent on the picture.
void check_output(shd_context* context, const Options& options);

/// The name of one of several pictures, counted from 0: the name of the options with the number from 1 in place of %04d
/// or of another width; without %04d, and if there are several, with -0001 and following before its extension. Empty if
/// it is not saved.
std::string picture_name(const Options& options, uint32_t picture, uint32_t pictures);

/// FNV-1a of the bits of the linear colours.
uint64_t picture_hash(const shd_framebuffer* framebuffer);

/// Opens the colour config if the picture needs it. Throws Failure (kExitUsage) for an unknown display or view.
Color open_color(shd_context* context, const Options& options);

/// Parts of an .exr besides the planes of its framebuffer.
struct FileExtras {
  const shd_view* view = nullptr;
  std::vector<shd_file_channel> channels;
  std::vector<shd_file_attribute> attributes;
};

/// Writes the picture: scene-linear to .exr and .hdr, through the display transform to all other formats.
void save_picture(const Color& color, const shd_framebuffer* framebuffer, const Options& options,
                  const std::string& name, const FileExtras& extras);
