// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "material/material.h"
#include "shade/light_table.h"
#include "shade/run.h"

namespace shd::shade {

/// geometry::Extra bits of the vertex columns that a material reads.
uint32_t needed_extras(const material::Material& material);

/// raster::Interpolated bits of the fragment columns that shading reads.
uint32_t needed_columns(const DrawShading& shading, const LightTable& lights);

/// Whether a material reads dp/du and dp/dv of triangles.
bool needs_tangent_frames(const material::Material& material);

/// Whether a material runs the caller's code at points: a program or procedures.
bool runs_caller_code(const material::Material& material);

}  // namespace shd::shade
