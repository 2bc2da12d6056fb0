// SPDX-License-Identifier: MIT
#include "gui_render.h"

#include <algorithm>
#include <cstddef>

#include <imgui.h>

namespace viewer {
namespace {

void draw_command(SDL_Renderer* renderer, const ImDrawData& data, const ImDrawList& list, const ImDrawCmd& command) {
  const int left = std::max(static_cast<int>(command.ClipRect.x - data.DisplayPos.x), 0);
  const int top = std::max(static_cast<int>(command.ClipRect.y - data.DisplayPos.y), 0);
  const int right = static_cast<int>(std::min(command.ClipRect.z - data.DisplayPos.x, data.DisplaySize.x));
  const int bottom = static_cast<int>(std::min(command.ClipRect.w - data.DisplayPos.y, data.DisplaySize.y));
  if (right <= left || bottom <= top) return;
  const SDL_Rect clip = {left, top, right - left, bottom - top};
  SDL_RenderSetClipRect(renderer, &clip);
  const ImDrawVert* const vertices = list.VtxBuffer.Data + command.VtxOffset;
  const auto* const bytes = reinterpret_cast<const unsigned char*>(vertices);
  const auto* const position = reinterpret_cast<const float*>(bytes + offsetof(ImDrawVert, pos));
  const auto* const uv = reinterpret_cast<const float*>(bytes + offsetof(ImDrawVert, uv));
  const auto* const color = reinterpret_cast<const SDL_Color*>(bytes + offsetof(ImDrawVert, col));
  SDL_RenderGeometryRaw(
      renderer, static_cast<SDL_Texture*>(command.GetTexID()), position, sizeof *vertices, color, sizeof *vertices, uv,
      sizeof *vertices, list.VtxBuffer.Size - static_cast<int>(command.VtxOffset),
      list.IdxBuffer.Data + command.IdxOffset, static_cast<int>(command.ElemCount), sizeof(ImDrawIdx));
}

}  // namespace

SDL_Texture* make_font_texture(SDL_Renderer* renderer) {
  ImGuiIO& io = ImGui::GetIO();
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  SDL_Texture* const texture =
      SDL_CreateTexture(renderer, SDL_PIXELFORMAT_RGBA32, SDL_TEXTUREACCESS_STATIC, width, height);
  if (!texture) return nullptr;
  SDL_UpdateTexture(texture, nullptr, pixels, 4 * width);
  SDL_SetTextureBlendMode(texture, SDL_BLENDMODE_BLEND);
  SDL_SetTextureScaleMode(texture, SDL_ScaleModeLinear);
  io.Fonts->SetTexID(texture);
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  return texture;
}

void draw_gui(SDL_Renderer* renderer, const ImDrawData& data) {
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      if (!command.UserCallback) draw_command(renderer, data, list, command);
    }
  }
  SDL_RenderSetClipRect(renderer, nullptr);
}

}  // namespace viewer
