// SPDX-License-Identifier: MIT
#pragma once
#include "ui.h"

namespace viewer {

/// Draws the pixels around `middle` with their codes in the lower left corner of the viewport, and the linear values of
/// `middle`.
void draw_magnifier(const Ui& ui, const Rect& viewport, const Picture& picture, uint32_t divider, Pixel middle);

}  // namespace viewer
