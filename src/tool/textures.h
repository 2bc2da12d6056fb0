// SPDX-License-Identifier: MIT
#pragma once
#include "tool/handles.h"
#include "tool/options.h"

/// Tables that a filter reads.
uint32_t tables_of(shd_filter filter);

/// Loads a texture with its mipmap or other tables. Throws Failure (kExitInput) when it cannot be read.
Texture load_texture(shd_context* context, const std::string& path, bool data, uint32_t tables = SHD_TABLE_MIPMAP);

/// Textures of a normal map: SHD_SLOT_NORMAL and, with KeepRoughness::kLean, SHD_SLOT_NORMAL_MIXED.
struct NormalMap {
  Texture texture, mixed;
};

/// Loads a normal map whose levels keep the roughness of bumps that are smaller than their texels. Throws Failure
/// (kExitInput).
NormalMap load_normal_map(shd_context* context, const Options& options);

/// A built-in pattern: squares in two colours with a mark in the corner where (u, v) = (0, 0).
Texture make_checker(shd_context* context, uint32_t tables);

/// A window of four panes, projected by a light.
Texture make_window(shd_context* context);

/// A sphere with studio lighting, looked up by the normal in view space.
Texture make_matcap(shd_context* context);
