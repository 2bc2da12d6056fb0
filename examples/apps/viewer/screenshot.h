// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include <SDL.h>

#include "layout.h"
#include "picture.h"

namespace viewer {

/// Writes what the renderer has drawn as PNG. Returns the text of an error, or "".
std::string save_window(SDL_Renderer* renderer, const std::string& path);

/// Lines for tests: the place of the viewport, the divider, the hash of the pixels, and the explained lookup.
std::string report_of(const Picture& picture, const Layout& layout, uint32_t divider);

}  // namespace viewer
