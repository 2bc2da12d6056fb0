// SPDX-License-Identifier: MIT
#pragma once

#include <shd/bake.h>

#include "frame/bake.h"

namespace shd::abi {

/// Checks that a column of states has room for the texels of a bake.
shd_result check_states(const char* field, const shd_u32_out& states, uint64_t texels);

/// The statistics of a finished bake, and its states in a column whose data may be null.
shd_bake_stats finish_bake(const frame::Bake& bake, const shd_render_stats& stats, const shd_u32_out& states);

}  // namespace shd::abi
