// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "command/failure.h"
#include "tool/show.h"

namespace {

/// The ellipse of a pixel in texture space: the image of the circle of radius 1/2 under the derivatives of texels by
/// pixels (Heckbert, "Fundamentals of Texture Mapping and Image Warping", 1989).
struct Footprint {
  float dudx, dvdx, dudy, dvdy;  // [texels]
  float major, minor;            // diameters [texels]
};

/// The diameters are the singular values of the derivatives.
void set_axes(Footprint& f) {
  const float sum = std::hypot(f.dudx + f.dvdy, f.dvdx - f.dudy),
              difference = std::hypot(f.dudx - f.dvdy, f.dvdx + f.dudy);
  f.major = 0.5f * (sum + difference);
  f.minor = 0.5f * std::fabs(sum - difference);
}

float anisotropy_of(const Footprint& f) {
  return f.major / std::max(f.minor, 1e-6f * f.major);
}

/// Derivatives of all pixels, at their centres.
struct Derivatives {
  std::vector<uint32_t> draw;
  std::vector<float> dudx, dvdx, dudy, dvdy;
};

Derivatives draw_derivatives(const Stage& stage, const Frame& frame) {
  shd_framebuffer_desc planes = shd_framebuffer_desc_default();
  planes.width = stage.options.width;
  planes.height = stage.options.height;
  planes.aovs = SHD_AOV_DRAW | SHD_AOV_DERIVATIVES;
  Framebuffer framebuffer;
  check(shd_framebuffer_create(stage.context, &planes, framebuffer.out()), "framebuffer");
  shd_render_desc desc = shd_render_desc_default();
  desc.framebuffer = framebuffer.get();
  desc.view = frame.camera.view;
  desc.draws = frame.draws.draws.data();
  desc.draw_count = frame.draws.draws.size();
  desc.visibility = stage.options.visibility;
  check(shd_render(stage.context, &desc), "--show footprint");
  const shd_framebuffer* const from = framebuffer.get();
  return {read_numbers(from, SHD_PLANE_DRAW), read_floats(from, SHD_PLANE_DUDX), read_floats(from, SHD_PLANE_DVDX),
          read_floats(from, SHD_PLANE_DUDY), read_floats(from, SHD_PLANE_DVDY)};
}

/// The footprint of a pixel in the texture of a slot.
Footprint footprint_of(const Derivatives& d, size_t pixel, const shd_slot& slot) {
  shd_texture_info info = shd_texture_info_default();
  check(shd_texture_get_info(slot.texture, &info), "--show footprint");
  const float *t = slot.uv_transform, width = static_cast<float>(info.width), height = static_cast<float>(info.height);
  Footprint f = {};
  f.dudx = width * (t[0] * d.dudx[pixel] + t[1] * d.dvdx[pixel]);
  f.dudy = width * (t[0] * d.dudy[pixel] + t[1] * d.dvdy[pixel]);
  f.dvdx = height * (t[3] * d.dudx[pixel] + t[4] * d.dvdx[pixel]);
  f.dvdy = height * (t[3] * d.dudy[pixel] + t[4] * d.dvdy[pixel]);
  set_axes(f);
  return f;
}

/// A footprint and where it is drawn.
struct PlacedFootprint {
  PicturePoint center;
  Footprint footprint;
};

struct FootprintRange {
  float low = HUGE_VALF, high = -HUGE_VALF;
  void add(float value) { low = std::min(low, value), high = std::max(high, value); }
};

/// Larger footprints are drawn larger, by the logarithm of their major diameters.
void paint_footprint(const PlacedFootprint& at, const FootprintRange& majors, float step, Picture& picture) {
  const Footprint& f = at.footprint;
  const float octaves = std::max(std::log2(majors.high / majors.low), 2.0f);
  const float part = 1.0f - std::log2(majors.high / f.major) / octaves;
  const float scale = step * (0.16f + 0.3f * part) / f.major;
  std::vector<PicturePoint> points;
  for (int i = 0; i <= 48; ++i) {
    const float angle = 6.2831853f * static_cast<float>(i) / 48.0f, c = std::cos(angle), s = std::sin(angle);
    points.push_back(
        {at.center.x + scale * (f.dudx * c + f.dudy * s), at.center.y + scale * (f.dvdx * c + f.dvdy * s)});
  }
  paint_stroke(picture, points, 4.0f, {0.0f, 0.0f, 0.0f});
  paint_stroke(picture, points, 2.0f, ramp_color(0.4f + 0.15f * std::log2(anisotropy_of(f))));
}

}  // namespace

Picture show_footprints(const Stage& stage, const Frame& frame) {
  Picture picture = shade_frame(stage, frame);
  const Derivatives derivatives = draw_derivatives(stage, frame);
  std::vector<PlacedFootprint> footprints;
  FootprintRange majors, minors, anisotropies;
  float distance = 0.0f;
  visit_grid(stage.options, [&](uint32_t x, uint32_t y, float step) {
    const size_t pixel = size_t{y} * stage.options.width + x;
    distance = step;
    if (derivatives.draw[pixel] >= frame.draws.solid_count) return;  // nothing, or a line
    const Instance& instance = stage.model.instances[frame.draws.instance[derivatives.draw[pixel]]];
    const shd_slot& slot = stage.paint.diffuse[instance.surface];
    if (!slot.texture || slot.uv_set != 0 || slot.coordinates != SHD_SLOT_COORDINATES_UV) return;
    const Footprint f = footprint_of(derivatives, pixel, slot);
    if (!(f.major > 0.0f) || !std::isfinite(f.major)) return;
    footprints.push_back({{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f}, f});
    majors.add(f.major);
    minors.add(f.minor);
    anisotropies.add(anisotropy_of(f));
  });
  if (footprints.empty())
    throw Failure(kExitInput, "--show footprint: no place of the grid shows a texture (--texture, --show-step)");
  for (const PlacedFootprint& at : footprints) paint_footprint(at, majors, distance, picture);
  std::fprintf(
      stderr,
      "shd-render: %zu footprints: major diameters %.4g to %.4g texels, minor ones %.4g to %.4g, ratios %.4g to "
      "%.4g\n",
      footprints.size(), majors.low, majors.high, minors.low, minors.high, anisotropies.low, anisotropies.high);
  return picture;
}
