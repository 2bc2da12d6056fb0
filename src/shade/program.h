// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "raster/fragments.h"
#include "raster/varyings.h"
#include "shade/columns.h"
#include "shade/run.h"

namespace shd::shade {

/// The inputs of a program or a procedure, and the list of columns that they point to.
struct ProgramInputs {
  shd_fragments fragments;
  const float* attribute[SHD_MAX_ATTRIBUTES];
};

/// The columns of points that programs and procedures read.
void make_inputs(const DrawShading& shading, const raster::Fragments& points, const raster::Varyings& varyings,
                 ProgramInputs* out);

/// Runs the material's fragment program at points with their varyings. Throws Failure if the program threw.
/// @param discard  [points.count], written only if the material may discard
void run_program(const DrawShading& shading, const raster::Fragments& points, const raster::Varyings& varyings,
                 uint32_t* discard, Radiance* radiance);

/// Runs a slot's procedure. Throws Failure if the procedure threw.
void call_procedure(const DrawShading& shading, const shd_fragments& in, const material::Slot& slot,
                    float* const out[4]);

/// Sets all targets except colour to 0.
void clear_targets(size_t count, Radiance* radiance);

}  // namespace shd::shade
