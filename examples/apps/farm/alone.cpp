// SPDX-License-Identifier: MIT
// The picture without windows, to compare with: one process, one call of shd_render() for each band of rows.
#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <shd.hpp>

#include "frame_file.h"
#include "ranks.h"
#include "scene_block.h"

namespace farm {
namespace {

void render_band(const Options& options, Stage* stage, uint32_t y, FrameFile* file) {
  const uint32_t rows = std::min(options.single, options.height - y);
  const Pixels band = render_window(stage, file->frame, {0, y, options.width, rows});
  std::vector<char> chunk;
  for (uint32_t i = 0; i < window_count(file->layout); ++i) {
    const Window window = window_at(file->layout, i);
    if (window.y < y || window.y >= y + rows) continue;
    const uint16_t* first = band.halves + (window.y - y) * band.row_stride + size_t{4} * window.x;
    encode_chunk(file->layout, i, {first, band.row_stride}, &chunk);
    write_at(file->part, chunk_offset(file->layout, i), chunk.data(), chunk.size());
    record_window(file, i, checksum(chunk.data(), chunk.size()), false);
  }
}

}  // namespace

int render_alone(const Options& options) {
  const Clock::time_point begin = Clock::now();
  const shd::context context = shd::context_create(nullptr);
  const std::vector<char> block = make_scene_block(context, options);
  const StagePtr stage = make_stage(options, block.data());
  const uint32_t first = options.frame < 0 ? 0 : static_cast<uint32_t>(options.frame);
  const uint32_t end = options.frame < 0 ? options.frames : first + 1;
  for (uint32_t frame = first; frame < end; ++frame) {
    FrameFile file = open_frame(options, checksum(block.data(), block.size()), frame);
    if (file.complete) continue;
    for (uint32_t y = 0; y < options.height; y += options.single) render_band(options, stage.get(), y, &file);
    finish_frame(&file);
    std::printf("%s %016" PRIx64 "\n", file.path.c_str(), picture_sum(file));
  }
  std::printf("1 process, %.3f s\n", seconds_since(begin));
  return 0;
}

}  // namespace farm
