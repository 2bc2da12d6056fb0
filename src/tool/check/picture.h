// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include <shd/shd.h>

#include "tool/check/options.h"

/// Layers of packed texels in memory.
struct Picture {
  shd_format format;
  uint32_t width, height, layers;
  std::vector<uint8_t> texels;
};

/// Reads a .npy array or, with libshd_io, an image file. Throws Failure.
Picture read_picture(shd_context* context, const std::string& path, bool srgb);

/// Returns the number of channels of a texture.
size_t channels_of(const shd_texture* texture);

/// Returns the columns of the channels of a picture of floats. Throws Failure for other formats.
std::vector<std::vector<float>> float_columns(const std::string& path, const Picture& picture);

/// Makes the texture of the command line. Throws Failure.
shd_texture* make_texture(shd_context* context, const Options& options);
