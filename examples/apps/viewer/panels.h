// SPDX-License-Identifier: MIT
#pragma once
#include "ui.h"

namespace viewer {

/// The tab of settings: changes the state.
void show_settings(Ui& ui, const Picture* picture, State& state);

/// The buttons at the bottom of the panel.
void show_buttons(Ui& ui);

/// The line below the viewport: times and counts. `progress` 0..1 = a frame is being drawn, negative = none.
void show_status(Ui& ui, const Rect& place, const Picture* picture, float progress);

/// A count with separators of thousands, such as 12,345.
std::string with_commas(uint64_t count);

}  // namespace viewer
