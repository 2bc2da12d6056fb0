// SPDX-License-Identifier: MIT
#pragma once
#include "command/program.h"
#include "tool/options.h"

// The options of shd-render, group by group. They set `out`, which must outlive them.

command::Group picture_options(Options& out);
command::Group camera_options(Options& out);
command::Group show_options(Options& out);
command::Group light_options(Options& out);
command::Group environment_options(Options& out);
command::Group surface_options(Options& out);
command::Group shape_options(Options& out);
command::Group volume_options(VolumeOptions& out);
command::Group machine_options(Options& out);

/// One number for all three channels, or three numbers.
command::Values color_values(std::optional<std::array<float, 3>>& out);
