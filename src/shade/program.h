// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "raster/fragments.h"
#include "raster/varyings.h"
#include "shade/columns.h"
#include "shade/run.h"

namespace shd::shade {

/// What programs see of rows.
shd_fragments make_inputs(const DrawShading& shading, const raster::Fragments& rows, const raster::Varyings& varyings);

/// Runs the material's fragment program for rows whose varyings, if it has any, are there. Throws Failure if it threw.
/// @param discard  by row, written where the material discards
void run_program(const DrawShading& shading, const raster::Fragments& rows, const raster::Varyings& varyings,
                 uint32_t* discard, Radiance* radiance);

/// Runs a slot's procedure. Throws Failure if it threw.
void call_procedure(const DrawShading& shading, const shd_fragments& in, const material::Slot& slot, uint32_t index,
                    float* const out[4]);

/// 0 in all targets but colour.
void clear_targets(size_t count, Radiance* radiance);

}  // namespace shd::shade
