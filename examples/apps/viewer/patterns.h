// SPDX-License-Identifier: MIT
/// Textures and an environment that the viewer computes, so that it starts without files.
#pragma once
#include <string>

#include <shd.hpp>

namespace viewer {

/// Blue ornaments on white, for the model. Repeats.
shd::texture make_porcelain(shd_context* context, shd_table_flags tables);

/// Light and dark tiles with thin joints, for the floor. Repeats after four tiles.
shd::texture make_tiles(shd_context* context, shd_table_flags tables);

/// A photographer's studio: a grey room with three bright panels.
shd::environment make_studio(shd_context* context);

/// The environment of a lat-long image file. Throws shd::error.
shd::environment load_environment(shd_context* context, const std::string& path);

}  // namespace viewer
