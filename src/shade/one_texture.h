// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/simd_target.h"
#include "raster/texture_places.h"
#include "shade/run.h"

namespace shd::shade {

/// Whether the colour of opaque fragments is one lookup: an unlit material whose diffuse slot has a texture of
/// normalised integers, without border colour, and which has no other slot and no emission. Such colours are finite.
bool is_one_texture(const material::Material& material);

/// Whether the pixels of such a material can be written as RGBA8: nothing multiplies the lookup.
bool writes_rgba8(const material::Material& material);

/// Writes the colours of pixels of one triangle, whose material is_one_texture(), to columns of r, g and b, with the
/// bits of shade_batch(). At most raster::kBatch rows. Nothing is written past the rows. Overwrites the uv
/// columns of the workspace. `rgba8`: null, or for writes_rgba8() opaque pixels with the codes of the colours, in place
/// of the columns, which then are scratch; a whole vector may be written at the end.
void shade_one_texture(const core::SimdTarget& simd, const DrawShading& shading, const raster::TrianglePixels& pixels,
                       size_t rows, Workspace* workspace, float* const out[3], uint32_t* rgba8);

}  // namespace shd::shade
