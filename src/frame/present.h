// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <shd/present.h>

#include "core/context.h"
#include "film/tile_planes.h"
#include "frame/frame.h"

namespace shd::frame {

/// Passes the colour of a finished tile to the host. Throws Failure with the host's result.
/// @param planes  from the first pixel of `area` on
void present_tile(const shd_present& host, const film::TileArea& area, const film::TilePlanes& planes, uint32_t worker);

/// Passes all tiles of a finished frame whose colour is stored in planes, on the context's executor.
void present_planes(const core::Context& context, const Frame& frame);

}  // namespace shd::frame
