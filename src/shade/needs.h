// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "material/material.h"
#include "shade/light_table.h"
#include "shade/run.h"

namespace shd::shade {

/// Columns of vertices that a material reads, as geometry::Extra bits.
uint32_t needed_extras(const material::Material& material);

/// Columns of fragments that shading reads, as raster::Interpolated bits.
uint32_t needed_columns(const DrawShading& shading, const LightTable& lights);

/// Whether the frames of triangles are wanted: dp/du and dp/dv.
bool needs_frames(const material::Material& material);

/// Whether programs or procedures see the rows.
bool shows_rows(const material::Material& material);

}  // namespace shd::shade
