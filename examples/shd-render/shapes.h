// SPDX-License-Identifier: MIT
#pragma once
#include "model.h"

/// A sphere of radius 1 with uv as on a globe: u from west to east, v from north to south.
Model make_sphere(int steps);

/// A square of side 2 in the plane y = 0 that faces up, divided into steps x steps parts.
Model make_plane(int steps);

/// Adds a square floor under the model that extends four radii to each side.
void add_floor(Model& model, const Bounds& bounds);
