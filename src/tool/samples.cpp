// SPDX-License-Identifier: MIT
#include "tool/samples.h"

#include <algorithm>
#include <unordered_map>

#include "command/failure.h"

namespace {

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

shd_view window_view(const Options& options, const shd_view& view, double left, double top, double width,
                     double height) {
  shd_view out = view;
  const auto scale_x = static_cast<float>(options.width / width), scale_y = static_cast<float>(options.height / height);
  const auto right = static_cast<float>((2.0 * left + width - options.width) / options.width);
  const auto down = static_cast<float>((2.0 * top + height - options.height) / options.height);
  for (size_t c = 0; c < 4; ++c) {
    float* const column = &out.view_to_clip[4 * c];
    column[0] = scale_x * (column[0] - right * column[3]);
    column[1] = scale_y * (column[1] + down * column[3]);
  }
  return out;
}

std::vector<PicturePoint> sample_places(const Options& options) {
  std::vector<PicturePoint> places;
  const uint32_t n = options.supersampling;
  const auto parts = static_cast<float>(n);
  for (uint32_t part = 0; part < n * n; ++part) {
    for (uint32_t i = 0; i < options.samples; ++i) {
      PicturePoint place;
      check(shd_sample_position(options.samples, i, &place.x, &place.y), "samples");
      place.x = (static_cast<float>(part % n) + place.x) / parts;
      place.y = (static_cast<float>(part / n) + place.y) / parts;
      places.push_back(place);
    }
  }
  return places;
}

void visit_samples(shd_context* context, const Options& options, const shd_view& view, const Draws& draws,
                   shd_aov_flags aovs, const std::function<void(size_t, const shd_framebuffer*)>& visit) {
  shd_framebuffer_desc planes = shd_framebuffer_desc_default();
  planes.width = options.width;
  planes.height = options.height;
  planes.aovs = aovs;
  Framebuffer framebuffer;
  check(shd_framebuffer_create(context, &planes, framebuffer.out()), "framebuffer");
  shd_render_desc desc = shd_render_desc_default();
  desc.framebuffer = framebuffer.get();
  desc.draws = draws.draws.data();
  desc.draw_count = draws.draws.size();
  desc.visibility = options.visibility;
  const std::vector<PicturePoint> places = sample_places(options);
  for (size_t i = 0; i < places.size(); ++i) {
    desc.view = window_view(options, view, places[i].x - 0.5, places[i].y - 0.5, options.width, options.height);
    check(shd_render(context, &desc), "samples");
    visit(i, framebuffer.get());
  }
}

Samples draw_samples(shd_context* context, const Options& options, const shd_view& view, const Draws& draws) {
  Samples samples;
  samples.per_pixel = options.samples * options.supersampling * options.supersampling;
  Counts others;
  visit_samples(context, options, view, draws, SHD_AOV_DRAW,
                [&](size_t, const shd_framebuffer* framebuffer) { add(framebuffer, options, samples, others); });
  for (const auto& [key, count] : others) {
    samples.others.push_back({static_cast<uint32_t>(key >> 32), static_cast<uint32_t>(key), count});
  }
  std::sort(samples.others.begin(), samples.others.end(), [](const Samples::Other& a, const Samples::Other& b) {
    return a.pixel != b.pixel ? a.pixel < b.pixel : a.draw < b.draw;
  });
  return samples;
}
