// SPDX-License-Identifier: MIT
#pragma once
#include "handles.h"
#include "model.h"
#include "options.h"

/// Loads a texture with its mipmap. Returns false, with shd_last_error() set, if it cannot be read.
bool load_texture(shd_context* context, const TextureSource& source, Texture& out);

/// Loads a normal map whose levels keep the roughness of the bumps that they no longer resolve. Returns false as
/// load_texture().
bool load_normal_map(shd_context* context, const std::string& path, KeepRoughness keep, Texture& out);

/// A built-in pattern: squares in two colours with a mark in the corner where (u, v) = (0, 0).
Texture make_checker(shd_context* context);

/// A window of four panes, projected by a light.
Texture make_window(shd_context* context);

/// A sphere with studio lighting, looked up by the normal in view space.
Texture make_matcap(shd_context* context);
