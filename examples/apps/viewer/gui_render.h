// SPDX-License-Identifier: MIT
#pragma once
#include <SDL.h>

struct ImDrawData;

namespace viewer {

/// Makes the texture of the fonts and sets it in the current ImGui context. Returns null on failure.
SDL_Texture* make_font_texture(SDL_Renderer* renderer);

/// Draws what ImGui::Render() made, with SDL_RenderGeometryRaw(), which every renderer of SDL has. Debian's libimgui
/// has no back end for SDL_Renderer.
void draw_gui(SDL_Renderer* renderer, const ImDrawData& data);

}  // namespace viewer
