// SPDX-License-Identifier: MIT
/// Pictures of planes that are no colours.
#pragma once
#include "picture.h"

namespace viewer {

/// Number of times that a pixel was drawn: black for none, then blue, green, yellow and red for 8 and more.
void show_overdraw(const shd_framebuffer* framebuffer, Image& image);

/// Distance from the near plane: white near, dark far, on a logarithmic scale between the nearest and farthest pixel.
void show_depth(const shd_framebuffer* framebuffer, const shd_camera& camera, Image& image);

}  // namespace viewer
