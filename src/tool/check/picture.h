// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include <shd/shd.h>

#include "tool/check/options.h"

/// Types of channels.
enum class Channel { kCode, kSrgb, kU16, kHalf, kFloat };

/// The format of 1 to 4 channels of a type.
shd_format format_with(Channel type, size_t channels);

/// Layers of packed texels in memory.
struct Picture {
  shd_format format;
  uint32_t width, height, layers;
  std::vector<uint8_t> texels;
};

/// Reads a .npy array or, with libshd_io, an image file. Throws Failure.
Picture read_picture(shd_context* context, const std::string& path, bool srgb);

/// Level 0 of a texture and, if they are given, its other levels.
struct Pictures {
  Picture base;
  std::vector<Picture> levels;
};

/// Reads the files of the command line. Throws Failure.
Pictures read_pictures(shd_context* context, const Options& options);

/// Number of channels of a picture.
size_t channels_of(const Picture& picture);

/// Whether texels have channels of 8 bits, linear or sRGB.
bool has_codes(const Picture& picture);

/// Whether results of lookups may be rounded to `result_bits`.
bool is_unorm(const Picture& picture);

/// Returns the columns of the channels of a picture of floats. Throws Failure for other formats.
std::vector<std::vector<float>> float_columns(const std::string& path, const Picture& picture);
