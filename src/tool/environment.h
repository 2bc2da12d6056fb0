// SPDX-License-Identifier: MIT
#pragma once
#include "tool/handles.h"
#include "tool/options.h"

/// Loads the environment of the command line; none without `--environment`.
Environment load_environment(shd_context* context, const Options& options);

/// Sets the environment of a frame.
void set_environment(const Options& options, shd_environment* environment, shd_render_desc& desc);
