// SPDX-License-Identifier: MIT
#pragma once
#include "handles.h"
#include "model.h"

/// Loads a texture with its mipmap. False, with shd_last_error() set, when it cannot be read.
bool load_texture(shd_context* context, const TextureSource& source, Texture& out);

/// A built-in pattern: squares in two colours with a mark in the corner where (u, v) = (0, 0).
Texture make_checker(shd_context* context);

/// Average of a texture with a mipmap, linear.
std::array<float, 3> average_color(shd_context* context, const shd_texture* texture);
