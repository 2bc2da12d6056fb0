// SPDX-License-Identifier: MIT
// The objects of a scene, made from its block, and windows of its pictures.
#ifndef SHD_FARM_STAGE_H
#define SHD_FARM_STAGE_H

#include <cstdint>
#include <memory>
#include <vector>

#include "options.h"

namespace farm {

/// A rectangle of the picture.
struct Window {
  uint32_t x, y, width, height;
};

/// Pixels of a window: binary16, [height][width][4], scene-linear, premultiplied. Valid until the next render.
struct Pixels {
  const uint16_t* halves;
  size_t row_stride;  // in elements
};

struct Stage;
struct StageDeleter {
  void operator()(Stage* stage) const noexcept;
};
using StagePtr = std::unique_ptr<Stage, StageDeleter>;

/// Makes the objects and the map of shadows. Textures borrow their texels from `block`, which must outlive the stage.
/// Throws shd::error.
StagePtr make_stage(const Options& options, const char* block);

/// Bytes that the objects of the stage borrow from its block.
uint64_t borrowed_bytes(const char* block);

/// Renders a window of a frame. One thread per stage. Throws shd::error.
Pixels render_window(Stage* stage, uint32_t frame, const Window& window);

}  // namespace farm

#endif  // SHD_FARM_STAGE_H
