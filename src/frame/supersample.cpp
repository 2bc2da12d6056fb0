// SPDX-License-Identifier: MIT
#include "frame/supersample.h"

#include <algorithm>
#include <cstring>

#include "core/executor.h"
#include "film/expanded_color.h"
#include "frame/present.h"
#include "frame/scene.h"
#include "frame/stats.h"

namespace shd::frame {
namespace {

constexpr uint32_t kMinFactor = 2;

/// A rectangle of pixels of the framebuffer.
struct Block {
  uint32_t left, top, width, height;
};

/// Calls body(plane, from, to) for every plane of two framebuffers with the same planes.
template <class Body>
void for_each_plane(film::Framebuffer& from, film::Framebuffer& to, const Body& body) {
  for (uint32_t p = 0; p < film::kPlaneCount; ++p) {
    if (!film::wants_plane(to.aovs, p)) continue;
    if (film::kPlanes[p].is_integer) {
      body(p, from.u32_plane[p].data(), to.u32_plane[p].data());
    } else {
      body(p, from.plane[p].data(), to.plane[p].data());
    }
  }
}

/// Reports the progress of a block as progress of the frame.
struct BlockProgress {
  const shd_progress& host;
  double before, size, total;  // pixels

  static shd_result report(float fraction, void* user_data) {
    const auto& self = *static_cast<BlockProgress*>(user_data);
    const double done = (self.before + self.size * static_cast<double>(fraction)) / self.total;
    return self.host.report(static_cast<float>(done), self.host.user_data);
  }
};

/// Renders a frame from blocks of the large picture.
class Supersampler {
 public:
  Supersampler(const core::Context& context, const Frame& frame)
      : context_(context),
        frame_(frame),
        n_(frame.supersampling),
        draws_(context.allocator, frame.draw_count),
        large_() {
    for (size_t i = 0; i < frame.draw_count; ++i) {
      draws_[i] = frame.draws[i];
      draws_[i].outline.reach *= static_cast<int32_t>(n_);
    }
    const geometry::PixelBox box = geometry::intersection(window_box(frame), frame.scissor);
    area_ = {static_cast<uint32_t>(box.min_x - frame.window.left), static_cast<uint32_t>(box.min_y - frame.window.top),
             static_cast<uint32_t>(box.max_x - box.min_x + 1), static_cast<uint32_t>(box.max_y - box.min_y + 1)};
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    desc.width = n_ * std::min(area_.width, edge());
    desc.height = n_ * std::min(area_.height, edge());
    desc.sample_count = frame.framebuffer->samples;
    desc.aovs = frame.framebuffer->aovs;
    build(context, desc, &large_);
  }

  void render(shd_render_stats* stats) {
    for (uint32_t y = 0; y < area_.height; y += edge()) {
      for (uint32_t x = 0; x < area_.width; x += edge()) {
        render_block(
            {area_.left + x, area_.top + y, std::min(area_.width - x, edge()), std::min(area_.height - y, edge())},
            stats);
      }
    }
  }

 private:
  /// Largest edge of a block, in pixels of the frame.
  uint32_t edge() const { return kBlockEdge / n_; }

  void render_block(const Block& block, shd_render_stats* stats) {
    large_.width = n_ * block.width;
    large_.height = n_ * block.height;
    BlockProgress progress = {frame_.progress, done_, static_cast<double>(block.width) * block.height,
                              static_cast<double>(area_.width) * area_.height};
    Frame large = large_frame(block);
    if (large.progress.report) large.progress = {BlockProgress::report, &progress};
    if (frame_.load) for_each_row(block, [&](uint32_t y) { spread_row(block, y); });
    shd_render_stats counts = {};
    frame::render(context_, large, &counts);
    add(counts, stats);
    for_each_row(block, [&](uint32_t y) { average_row(block, y); });
    done_ += progress.size;
  }

  Frame large_frame(const Block& block) {
    Frame large = frame_;
    const auto n = static_cast<int32_t>(n_);
    large.supersampling = 1;
    large.present = {};
    large.framebuffer = &large_;
    large.draws = draws_.data();
    large.window = {n * (frame_.window.left + static_cast<int32_t>(block.left)),
                    n * (frame_.window.top + static_cast<int32_t>(block.top))};
    const geometry::Viewport& v = frame_.viewport;
    large.viewport = {n_ * v.x, n_ * v.y, n_ * v.width, n_ * v.height};
    const geometry::PixelBox& s = frame_.scissor;
    large.scissor = {n * s.min_x, n * s.min_y, n * (s.max_x + 1) - 1, n * (s.max_y + 1) - 1};
    return large;
  }

  /// Runs body(row) for the rows of the block on the executor.
  template <class Body>
  void for_each_row(const Block& block, const Body& body) const {
    core::parallel_for(context_, block.height, [&](uint32_t y, uint32_t) { body(y); });
  }

  /// Position of the first pixel of a row of the block: in the planes of the frame, and in the large planes.
  size_t start_of(const Block& block, uint32_t y) const {
    return (block.top + size_t{y}) * frame_.framebuffer->stride + block.left;
  }
  size_t large_start_of(uint32_t y) const { return size_t{y} * n_ * large_.stride; }

  /// Copies each pixel of a row to its large pixels.
  void spread_row(const Block& block, uint32_t y) {
    for_each_plane(*frame_.framebuffer, large_, [&](uint32_t, const auto* plane, auto* large) {
      const auto* from = plane + start_of(block, y);
      auto* const first = large + large_start_of(y);
      for (uint32_t x = 0; x < block.width; ++x) std::fill_n(first + size_t{x} * n_, n_, from[x]);
      for (uint32_t row = 1; row < n_; ++row) {
        std::memcpy(first + row * large_.stride, first, sizeof *first * n_ * block.width);
      }
    });
  }

  void average_row(const Block& block, uint32_t y) {
    for_each_plane(large_, *frame_.framebuffer, [&](uint32_t p, const auto* large, auto* plane) {
      const auto* from = large + large_start_of(y);
      auto* to = plane + start_of(block, y);
      if (p >= SHD_PLANE_DEPTH && p < SHD_PLANE_TARGET1_R) {
        for (uint32_t x = 0; x < block.width; ++x) to[x] = from[size_t{x} * n_];
        return;
      }
      double sum[kBlockEdge / kMinFactor];
      std::fill_n(sum, block.width, -0.0);  // -0 + x is x, including its sign
      for (uint32_t row = 0; row < n_; ++row, from += large_.stride) {
        for (uint32_t x = 0; x < block.width; ++x) {
          for (uint32_t i = 0; i < n_; ++i) sum[x] += static_cast<double>(from[size_t{x} * n_ + i]);
        }
      }
      const double count = static_cast<double>(n_) * n_;
      using Value = std::remove_reference_t<decltype(*to)>;
      for (uint32_t x = 0; x < block.width; ++x) to[x] = static_cast<Value>(sum[x] / count);
    });
  }

  const core::Context& context_;
  const Frame& frame_;
  const uint32_t n_;
  core::Array<Draw> draws_;  // lines and points are n times as wide
  Block area_;               // part of the framebuffer inside the scissor
  film::Framebuffer large_;  // holds one block
  double done_ = 0.0;        // pixels of finished blocks
};

}  // namespace

void render_supersampled(const core::Context& context, const Frame& frame, shd_render_stats* stats) {
  if (geometry::is_empty(geometry::intersection(window_box(frame), frame.scissor))) {
    return render(context, frame, stats);
  }
  const film::ExpandedColor expanded(context, frame.framebuffer);
  Supersampler(context, frame).render(stats);
  if (frame.present.tile) present_planes(context, frame);
}

}  // namespace shd::frame
