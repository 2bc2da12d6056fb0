// SPDX-License-Identifier: MIT
/// A finished picture: what the window shows, and the numbers behind it.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "explanation.h"
#include "layout.h"
#include "state.h"

namespace viewer {

/// One side of a picture.
struct Image {
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> display;  // [height][width][4], encoded for the display, opaque
  std::vector<float> linear;     // [height][width][4], scene-linear, premultiplied
  shd::render_stats stats;
  double seconds = 0.0;  // time of shd_render() and the display transform
};

struct Picture {
  State state;
  std::shared_ptr<const Image> side[2];  // null after an error, and the second one without a wipe
  Explanation explanation;
  Bounds bounds;
  uint64_t triangles = 0;
  std::vector<std::string> warnings;  // problems with parts of the model file
  std::string error;                  // "" = the images are those of the state
  bool from_file = false;
  bool cancelled = false;
  std::string simd;
  uint32_t workers = 0;
};

/// The pixels of the viewport: A left of the divider, B right of it. [height][width][4].
std::vector<uint8_t> compose(const Picture& picture, uint32_t divider);

/// Pixels that the magnifier shows.
constexpr int kMagnifiedColumns = 9, kMagnifiedRows = 7;

/// First pixel of the magnifier around `middle`, so that all of its pixels are in a picture of that size if it is
/// large enough.
Pixel first_magnified(Pixel middle, uint32_t width, uint32_t height);

/// Place of the magnifier's cells: in the lower left corner of the viewport.
struct MagnifierLayout {
  int x, y, cell, margin, line;  // left and top of the first cell; side of a cell; border; height of the text below
};
MagnifierLayout magnifier_layout(const Rect& viewport, float scale);

/// Writes RGBA pixels as PNG, or in another format by the extension. Returns the text of an error, or "".
std::string save_pixels(const std::vector<uint8_t>& pixels, uint32_t width, uint32_t height, const std::string& path);

/// Writes the pixels of the viewport. Returns the text of an error, or "".
std::string save_viewport(const Picture& picture, uint32_t divider, const std::string& path);

/// FNV-1a, 64 bits.
uint64_t hash_of(const std::vector<uint8_t>& bytes);

}  // namespace viewer
