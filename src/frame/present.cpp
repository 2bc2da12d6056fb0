// SPDX-License-Identifier: MIT
#include "frame/present.h"

#include "core/executor.h"
#include "core/read_desc.h"
#include "core/status.h"

namespace shd::frame {
namespace {

[[noreturn]] void refuse_tile(shd_result result) {
  if (core::enum_bits(result) <= SHD_ERROR_INTERNAL) throw core::Failure(result, core::last_error());
  core::refuse(SHD_ERROR_CALLBACK, "render.present.tile returned %s", shd_result_name(result));
}

}  // namespace

void present_tile(const shd_present& host, const film::TileArea& area, const film::TilePlanes& planes,
                  uint32_t worker) {
  shd_present_tile tile = {};
  tile.struct_size = sizeof tile;
  tile.worker = worker;
  tile.area.x = area.left;
  tile.area.y = area.top;
  tile.area.width = area.width;
  tile.area.height = area.height;
  for (int c = 0; c < 4; ++c) tile.channel[c] = planes.plane[c];
  tile.row_stride = planes.stride * sizeof(float);
  const shd_result result = host.tile(&tile, host.user_data);
  if (result != SHD_OK) refuse_tile(result);
}

void present_planes(const core::Context& context, const Frame& frame) {
  film::Framebuffer& framebuffer = *frame.framebuffer;
  const uint32_t tiles_x = raster::tile_count(framebuffer.width);
  core::parallel_for(context, tiles_x * raster::tile_count(framebuffer.height), [&](uint32_t index, uint32_t worker) {
    const film::TileArea area = film::tile_area(framebuffer, index, tiles_x);
    present_tile(frame.present, area, film::planes_of(area, SHD_PLANE_R, &framebuffer), worker);
  });
}

}  // namespace shd::frame
