// SPDX-License-Identifier: MIT
#include "screenshot.h"

#include <cstdio>

#include <shd/io.h>

namespace viewer {

std::string save_window(SDL_Renderer* renderer, const std::string& path) {
  int width = 0, height = 0;
  if (SDL_GetRendererOutputSize(renderer, &width, &height) != 0) return SDL_GetError();
  std::vector<uint8_t> pixels(size_t{4} * static_cast<size_t>(width) * static_cast<size_t>(height));
  if (SDL_RenderReadPixels(renderer, nullptr, SDL_PIXELFORMAT_RGBA32, pixels.data(), 4 * width) != 0) {
    return SDL_GetError();
  }
  for (size_t i = 3; i < pixels.size(); i += 4) pixels[i] = 255;  // windows are opaque
  return save_pixels(pixels, static_cast<uint32_t>(width), static_cast<uint32_t>(height), path);
}

std::string report_of(const Picture& picture, const Layout& layout, uint32_t divider) {
  char text[512];
  const Rect& place = layout.viewport;
  std::snprintf(text, sizeof text, "viewport %d %d %d %d\ndivider %u\nhash %016llx\n", place.x, place.y, place.width,
                place.height, divider, static_cast<unsigned long long>(hash_of(compose(picture, divider))));
  std::string report = text;
  const Explanation& e = picture.explanation;
  if (!e.asked) return report;
  std::snprintf(text, sizeof text,
                "pixel %u %u side %d surface \"%s\" taps %zu levels %zu\n"
                "weighted %.9g %.9g %.9g\nsampled %.9g %.9g %.9g\nreplay %s\n",
                e.pixel.x, e.pixel.y, e.side, e.surface.c_str(), e.taps.size(), e.levels.size(), e.weighted[0],
                e.weighted[1], e.weighted[2], e.sampled[0], e.sampled[1], e.sampled[2],
                e.replay_is_exact ? "exact" : "inexact");
  return report + text;
}

}  // namespace viewer
