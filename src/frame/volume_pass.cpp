// SPDX-License-Identifier: MIT
#include "frame/volume_pass.h"

#include <cstring>

#include "data/hash.h"
#include "volume/march.h"

namespace shd::frame {
namespace {

/// Pixels and samples of the rays of a batch.
struct Targets {
  uint32_t pixel[volume::kRays];
  uint32_t mask[volume::kRays];
};

/// Hashes the place of a pixel to [0, 1).
float jitter_of(int32_t x, int32_t y, uint32_t seed) {
  const uint32_t row = data::mix_bits(static_cast<uint32_t>(y) + data::mix_bits(seed + data::kHashStep));
  return data::unit_of(data::mix_bits(static_cast<uint32_t>(x) + row));
}

/// Draws one volume over a tile.
class VolumeDrawer {
 public:
  VolumeDrawer(TileState* tile, const volume::Lens& lens, const VolumeDraw& draw)
      : tile_(*tile),
        lens_(lens),
        draw_(draw),
        shading_{tile->renderer.lights, draw.world_to_box, &tile->worker.workspace},
        march_(tile->worker.march[0]) {
    march_.count = 0;
  }

  void draw() {
    const geometry::PixelBox box = tile_.box();
    for (int32_t y = box.min_y; y <= box.max_y; ++y) {
      for (int32_t x = box.min_x; x <= box.max_x; ++x) add_pixel(x, y);
    }
    flush();
  }

 private:
  void add_pixel(int32_t x, int32_t y) {
    const volume::Sight sight = volume::sight_of(lens_, x, y);
    volume::Ray ray;
    if (!sight.is_valid) return;
    const bool has_samples = tile_.pattern.count > 1;
    if (has_samples && !volume::make_ray(sight, draw_.world_to_box, sight.end, draw_.volume->step, &ray)) return;
    const auto pixel = static_cast<uint32_t>((y - tile_.top) * raster::kTile + (x - tile_.left));
    const float h = draw_.volume->jitter > 0.0f ? jitter_of(x, y, draw_.volume->seed) : 0.5f;
    for (uint32_t rest = tile_.all_samples(); rest != 0;) {
      const float depth = *tile_.depth_of(first_sample(rest), pixel);
      const uint32_t mask = samples_at(depth, pixel, rest);
      rest &= ~mask;
      const double end = volume::distance_of(lens_, sight, x, y, static_cast<double>(depth));
      if (!volume::make_ray(sight, draw_.world_to_box, end, draw_.volume->step, &ray)) continue;
      ray.offset = 0.5f + draw_.volume->jitter * (h - 0.5f);
      add_ray(ray, pixel, mask);
    }
  }

  /// Returns the samples among `rest` that have a depth.
  uint32_t samples_at(float depth, uint32_t pixel, uint32_t rest) const {
    uint32_t mask = rest & (~rest + 1u);
    for (uint32_t others = rest & (rest - 1); others; others &= others - 1) {
      const uint32_t sample = first_sample(others);
      if (*tile_.depth_of(sample, pixel) == depth) mask |= 1u << sample;
    }
    return mask;
  }

  void add_ray(const volume::Ray& ray, uint32_t pixel, uint32_t mask) {
    targets_.pixel[march_.count] = pixel;
    targets_.mask[march_.count] = mask;
    march_.ray[march_.count++] = ray;
    if (march_.count == volume::kRays) flush();
  }

  void flush() {
    if (march_.count == 0) return;
    volume::march(tile_.simd(), *draw_.volume, draw_.volume->material ? &shading_ : nullptr, &march_);
    for (size_t i = 0; i < march_.count; ++i) {
      film::FragmentColor color;
      std::memcpy(color.channel, march_.color[i], sizeof color.channel);
      if (color.channel[3] > 0.0f) tile_.color.over(targets_.pixel[i], targets_.mask[i], color);
    }
    march_.count = 0;
  }

  TileState& tile_;
  const volume::Lens& lens_;
  const VolumeDraw& draw_;
  const volume::PointShading shading_;
  volume::March& march_;
  Targets targets_;
};

}  // namespace

void draw_volumes(TileState* tile) {
  const Frame& frame = tile->renderer.frame;
  const geometry::Viewport& v = frame.viewport;
  const double viewport[4] = {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.width),
                              static_cast<double>(v.height)};
  const volume::Lens lens = volume::make_lens(frame.view, viewport, frame.clear_depth < 0.5f);
  if (!lens.is_valid) return;
  for (size_t i = 0; i < frame.volume_count; ++i) VolumeDrawer(tile, lens, frame.volumes[i]).draw();
}

}  // namespace shd::frame
