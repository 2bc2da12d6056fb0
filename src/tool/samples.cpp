// SPDX-License-Identifier: MIT
#include "tool/samples.h"

#include <algorithm>
#include <unordered_map>

#include "command/failure.h"

namespace {

/// The view with a place of the pixel, in pixels from its upper left corner, in the middle of it.
shd_view shift(const Options& options, const shd_view& view, float x, float y) {
  shd_view out = view;
  const float right = 2.0f * (x - 0.5f) / static_cast<float>(options.width);
  const float down = 2.0f * (y - 0.5f) / static_cast<float>(options.height);
  for (size_t c = 0; c < 4; ++c) {
    out.view_to_clip[4 * c] -= right * view.view_to_clip[4 * c + 3];
    out.view_to_clip[4 * c + 1] += down * view.view_to_clip[4 * c + 3];
  }
  return out;
}

using Counts = std::unordered_map<uint64_t, uint32_t>;  // by pixel << 32 | draw

/// Adds the draws of one sample of all pixels.
void add(const shd_framebuffer* framebuffer, const Options& options, Samples& samples, Counts& others) {
  shd_plane_view plane = shd_plane_view_default();
  check(shd_framebuffer_view_plane(framebuffer, SHD_PLANE_DRAW, &plane), "--cryptomatte");
  const bool is_first = samples.count.empty();
  const size_t pixels = size_t{options.width} * options.height;
  if (is_first) samples.count.assign(pixels, 1), samples.draw.resize(pixels);
  for (uint32_t y = 0, pixel = 0; y < options.height; ++y) {
    const auto* const row =
        reinterpret_cast<const uint32_t*>(reinterpret_cast<const char*>(plane.u32) + y * plane.row_stride);
    for (uint32_t x = 0; x < options.width; ++x, ++pixel) {
      if (is_first) {
        samples.draw[pixel] = row[x];
      } else if (samples.draw[pixel] == row[x]) {
        ++samples.count[pixel];
      } else {
        ++others[uint64_t{pixel} << 32 | row[x]];
      }
    }
  }
}

}  // namespace

Samples draw_samples(shd_context* context, const Options& options, const shd_view& view, const Draws& draws) {
  shd_framebuffer_desc planes = shd_framebuffer_desc_default();
  planes.width = options.width;
  planes.height = options.height;
  planes.aovs = SHD_AOV_DRAW;
  Framebuffer framebuffer;
  check(shd_framebuffer_create(context, &planes, framebuffer.out()), "framebuffer");
  shd_render_desc desc = shd_render_desc_default();
  desc.framebuffer = framebuffer.get();
  desc.draws = draws.draws.data();
  desc.draw_count = draws.draws.size();
  desc.visibility = options.visibility;
  Samples samples;
  samples.per_pixel = options.samples * options.supersampling * options.supersampling;
  Counts others;
  const auto parts = static_cast<float>(options.supersampling);
  for (uint32_t i = 0; i < samples.per_pixel; ++i) {
    const uint32_t part = i / options.samples;
    float x = 0, y = 0;
    check(shd_sample_position(options.samples, i % options.samples, &x, &y), "samples");
    x = (static_cast<float>(part % options.supersampling) + x) / parts;
    y = (static_cast<float>(part / options.supersampling) + y) / parts;
    desc.view = shift(options, view, x, y);
    check(shd_render(context, &desc), "--cryptomatte");
    add(framebuffer.get(), options, samples, others);
  }
  for (const auto& [key, count] : others) {
    samples.others.push_back({static_cast<uint32_t>(key >> 32), static_cast<uint32_t>(key), count});
  }
  std::sort(samples.others.begin(), samples.others.end(), [](const Samples::Other& a, const Samples::Other& b) {
    return a.pixel != b.pixel ? a.pixel < b.pixel : a.draw < b.draw;
  });
  return samples;
}
