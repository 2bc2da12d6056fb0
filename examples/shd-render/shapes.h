// SPDX-License-Identifier: MIT
#pragma once
#include <shd/shapes.h>

#include "model.h"

/// A shape of shd/shapes.h: the teapot with `steps` parts on each side of a patch, a sphere of 4 steps around and
/// 2 steps down, a plane of steps x steps.
Model make_shape(shd_shape shape, int steps);

/// Adds a square floor under the model, four radii to each side.
void add_floor(Model& model, const Bounds& bounds);
