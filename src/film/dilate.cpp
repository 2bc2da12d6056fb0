// SPDX-License-Identifier: MIT
#include "film/dilate.h"

#include <algorithm>
#include <cstring>

#include "core/executor.h"

namespace shd::film {
namespace {

/// Distances in rows from each texel to the nearest filled texel of its column; equally near ones are above.
class Columns {
 public:
  Columns(const core::Context& context, uint32_t width, uint32_t height, const uint8_t* texels)
      : width_(width), above_(context.allocator, size_t{width} * height), below_(context.allocator, above_.size()) {
    core::parallel_for(context, (width + kStrip - 1) / kStrip, [&](uint32_t strip, uint32_t) {
      const uint32_t begin = strip * kStrip, end = std::min(width, begin + kStrip);
      for (uint32_t y = 0; y < height; ++y) fill(begin, end, y, y, y ? y - 1 : y, texels, &above_);
      for (uint32_t y = height; y-- > 0;)
        fill(begin, end, y, height - 1 - y, std::min(y + 1, height - 1), texels, &below_);
    });
  }

  uint32_t above(uint32_t x, uint32_t y) const { return above_[size_t{y} * width_ + x]; }
  uint32_t below(uint32_t x, uint32_t y) const { return below_[size_t{y} * width_ + x]; }

 private:
  static constexpr uint32_t kStrip = 256;

  /// Distances of a part of a row from those of the row `before`; the first row has none.
  void fill(uint32_t begin, uint32_t end, uint32_t y, uint32_t rows_done, uint32_t before, const uint8_t* texels,
            core::Array<uint32_t>* out) const {
    for (uint32_t x = begin; x < end; ++x) {
      const uint32_t last = rows_done ? (*out)[size_t{before} * width_ + x] : kNoTexel;
      const uint32_t next = last == kNoTexel ? kNoTexel : last + 1;
      (*out)[size_t{y} * width_ + x] = texels[size_t{y} * width_ + x] ? 0 : next;
    }
  }

  const uint32_t width_;
  core::Array<uint32_t> above_, below_;
};

/// The nearest filled texel found so far. Candidates may come in any order.
struct Nearest {
  uint64_t distance;
  uint32_t texel = kNoTexel;

  void offer(uint64_t squared, uint32_t candidate) {
    if (squared > distance || (squared == distance && candidate >= texel)) return;
    distance = squared;
    texel = candidate;
  }
};

uint32_t nearest_texel(const Columns& columns, uint32_t width, uint32_t x, uint32_t y, uint32_t radius) {
  Nearest nearest = {uint64_t{radius} * radius};
  for (uint32_t step = 0; step <= radius && uint64_t{step} * step <= nearest.distance; ++step) {
    for (int side = 0; side < (step ? 2 : 1); ++side) {
      if (side == 0 ? x < step : width - x <= step) continue;
      const uint32_t column = side == 0 ? x - step : x + step;
      const uint32_t up = columns.above(column, y), down = columns.below(column, y);
      const uint64_t across = uint64_t{step} * step;
      if (up <= radius) nearest.offer(across + uint64_t{up} * up, (y - up) * width + column);
      if (down <= radius) nearest.offer(across + uint64_t{down} * down, (y + down) * width + column);
    }
  }
  return nearest.texel;
}

/// Copies all planes of one texel to another; positions count elements.
void copy_texel(size_t from, size_t to, Framebuffer* framebuffer) {
  for (core::Array<float>& plane : framebuffer->plane) {
    if (plane.size()) plane[to] = plane[from];
  }
  for (core::Array<uint32_t>& plane : framebuffer->u32_plane) {
    if (plane.size()) plane[to] = plane[from];
  }
  if (framebuffer->pixels.size() == 0) return;
  const size_t size = shd_format_size(framebuffer->color_format);
  std::memcpy(framebuffer->pixels.data() + to * size, framebuffer->pixels.data() + from * size, size);
}

}  // namespace

core::Array<uint32_t> nearest_texels(const core::Context& context, uint32_t width, uint32_t height, uint32_t radius,
                                     const uint8_t* texels) {
  core::Array<uint32_t> result(context.allocator, size_t{width} * height);
  const Columns columns(context, width, height, texels);
  core::parallel_for(context, height, [&](uint32_t y, uint32_t) {
    for (uint32_t x = 0; x < width; ++x) {
      const size_t at = size_t{y} * width + x;
      result[at] = texels[at] ? kNoTexel : nearest_texel(columns, width, x, y, radius);
    }
  });
  return result;
}

void dilate(const core::Context& context, uint32_t radius, uint8_t* texels, Framebuffer* framebuffer) {
  if (radius == 0) return;
  const uint32_t width = framebuffer->width, height = framebuffer->height;
  const core::Array<uint32_t> nearest = nearest_texels(context, width, height, radius, texels);
  core::parallel_for(context, height, [&](uint32_t y, uint32_t) {
    for (uint32_t x = 0; x < width; ++x) {
      const uint32_t from = nearest[size_t{y} * width + x];
      if (from == kNoTexel) continue;
      copy_texel(from / width * framebuffer->stride + from % width, y * framebuffer->stride + x, framebuffer);
      texels[size_t{y} * width + x] = kTexelDilated;
    }
  });
}

}  // namespace shd::film
