// SPDX-License-Identifier: MIT
#include "frame/tile_state.h"

namespace shd::frame {

TileState::TileState(const TileRenderer& tile_renderer, uint32_t tile, Worker* tile_worker)
    : renderer(tile_renderer),
      framebuffer(*renderer.frame.framebuffer),
      pattern(raster::sample_pattern(framebuffer.samples)),
      index(tile),
      area(film::tile_area(framebuffer, tile, renderer.scene.bins.tiles_x)),
      left(renderer.frame.window.left + static_cast<int32_t>(area.left)),
      top(renderer.frame.window.top + static_cast<int32_t>(area.top)),
      worker(*tile_worker),
      color_planes(worker.color.planes(area, &framebuffer)),
      color(area, color_planes, &framebuffer, &worker.split) {}

shade::DrawShading TileState::shading_of(uint32_t draw) const {
  const Draw& d = renderer.frame.draws[draw];
  const Scene& scene = renderer.scene;
  return {&scene.vertices[draw],
          d.material,
          d.frequency,
          scene.transforms[draw].orientation,
          d.index,
          d.instance,
          film::columns_of(framebuffer.aovs),
          d.uniforms,
          d.object_to_world,
          renderer.frame.bake != nullptr};
}

geometry::PixelBox TileState::box() const {
  return geometry::intersection(geometry::pixel_rectangle(left, top, area.width, area.height),
                                visible_box(renderer.frame));
}

bool TileState::is_drawn_once() const {
  const Frame& frame = renderer.frame;
  if (renderer.present || renderer.samples || frame.volume_count > 0 || frame.bake || framebuffer.aovs) return false;
  bool plain = true;
  for_each_run([&](const Run& run) {
    const material::Material* material = draw_of(run).material;
    plain = plain && (!material || is_plain(*material));
  });
  return plain;
}

bool TileState::is_bare() const {
  if (renderer.frame.volume_count > 0) return false;
  const raster::Bins& bins = renderer.scene.bins;
  for (uint32_t g = 0; g < bins.group_count; ++g) {
    if (raster::segment(bins, index, g).count) return false;
  }
  return true;
}

void TileState::fill(const film::TileArea& part) {
  if (renderer.background.map) {
    fill_background(simd(), renderer.background, area, part, left, top, color_planes);
  } else {
    film::fill_color(area, part, renderer.frame.clear_color, color_planes);
  }
}

void TileState::clear_color() {
  if (color_is_unclear) fill(area);
  color_is_unclear = false;
}

void TileState::clear_bare(const core::Buffer<raster::PixelRun>& bare) {
  if (!color_is_unclear || renderer.background.map) return clear_color();
  for (size_t i = 0; i < bare.size(); ++i) {
    film::fill_color(area, bare[i], renderer.frame.clear_color, color_planes);
  }
  color_is_unclear = false;
}

uint64_t TileState::count_masked() const {
  uint64_t count = 0;
  for_each_masked([&](uint32_t, uint32_t mask) { count += static_cast<uint64_t>(__builtin_popcount(mask)); });
  return count;
}

void TileState::count_hidden(const raster::CoverArea& covered, const geometry::ScreenTriangle& triangle,
                             uint64_t passed) const {
  if (!renderer.frame.counts_hidden) return;
  const raster::DepthState always = {SHD_COMPARE_ALWAYS, false, 0.0f, 0.0f};
  raster::cover_mask(simd(), covered, always, triangle, worker.tile, &worker.mask);
  worker.hidden_samples += count_masked() - passed;
}

}  // namespace shd::frame
