// SPDX-License-Identifier: MIT
/// Tiles of a frame that is still being drawn, for the window. No SDL, no ImGui.
#pragma once
#include <cstdint>
#include <mutex>
#include <vector>

#include <shd/present.h>

namespace viewer {

/// Finished tiles of one side, copied out.
struct TileImage {
  uint32_t width = 0, height = 0;
  int side = 0;
  std::vector<uint8_t> pixels;  // [height][width][4]; alpha 0 = not finished
};

/// Any thread may call any function.
class Tiles {
 public:
  /// Begins a frame without finished tiles. `is_light` = values are light, to be encoded by the sRGB curve.
  void begin(uint32_t width, uint32_t height, int side, bool is_light);

  /// Drops the tiles: the frame is complete or was stopped.
  void end();

  /// Callback for shd_render_desc.present that adds to these tiles.
  shd_present present() { return {add, this}; }

  /// Copies the tiles if they differ from those of `version`, and sets `version`. An empty image = no frame.
  bool take(uint64_t& version, TileImage& out) const;

 private:
  static shd_result add(const shd_present_tile* tile, void* user_data);

  mutable std::mutex mutex_;
  TileImage image_;
  bool is_light_ = true;
  uint64_t version_ = 1;
};

}  // namespace viewer
