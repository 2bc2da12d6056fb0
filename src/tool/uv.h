// SPDX-License-Identifier: MIT
#pragma once
#include "tool/camera.h"
#include "tool/model.h"

/// The projection that gives coordinates to vertices; none for the coordinates of meshes and of fragments.
shd_uv_projection projection_of(Uv uv);

/// The matrix that takes the centre of a box to `middle` and its longest side to the length `side`.
std::array<float, 16> fit_box(const Box& box, double middle, double side);

/// The coordinates of the textures of the command line, as a slot without its texture: those of the mesh, triplanar
/// with the box in the cube of the texture, or the picture of the camera.
shd_slot uv_slot(Uv uv, const Box& box, const Camera& camera);
