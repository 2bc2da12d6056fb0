// SPDX-License-Identifier: MIT
#pragma once
#include "ui.h"

namespace viewer {

/// The tab of the picked pixel: its taps over the texture level, their weights and the resulting colour.
void show_explanation(Ui& ui, const Explanation& explanation);

}  // namespace viewer
