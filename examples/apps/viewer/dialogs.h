// SPDX-License-Identifier: MIT
#pragma once
#include "ui.h"

namespace viewer {

/// The window of keys and mouse moves (ui.help).
void show_help(Ui& ui);

/// The window in which a file is chosen (ui.open). A click opens it, as a drop on the window does.
void show_open(Ui& ui, State& state);

}  // namespace viewer
