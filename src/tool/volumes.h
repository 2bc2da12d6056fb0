// SPDX-License-Identifier: MIT
#pragma once
#include "tool/handles.h"
#include "tool/model.h"
#include "tool/options.h"

/// The volume of `--volume`.
struct StageVolume {
  Volume volume;  // empty without the option
  std::array<float, 16> object_to_world = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
};

/// Loads the file and makes a volume with a transfer function that suits its densities. Throws Failure (kExitInput).
StageVolume load_volume(shd_context* context, const Options& options);

/// A model without surfaces that has the extent of the volume.
Model volume_model(const StageVolume& volume);
