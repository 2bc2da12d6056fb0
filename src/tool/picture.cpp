// SPDX-License-Identifier: MIT
#include "tool/picture.h"

#include <algorithm>
#include <cmath>

#include "command/failure.h"

namespace {

/// Distance of a place from the line between two others.
float distance_to(const PicturePoint& p, const PicturePoint& a, const PicturePoint& b) {
  const float dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
  const float along = length > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length, 0.0f, 1.0f) : 0.0f;
  return std::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy);
}

float distance_to(const PicturePoint& p, const std::vector<PicturePoint>& points) {
  float distance = distance_to(p, points.front(), points.front());
  for (size_t i = 1; i < points.size(); ++i) distance = std::min(distance, distance_to(p, points[i - 1], points[i]));
  return distance;
}

/// The fragment program that gives the colours of a picture.
void copy_pixels(const shd_fragments* in, shd_radiance* out, void* user_data) {
  const auto& picture = *static_cast<const Picture*>(user_data);
  for (size_t i = 0; i < in->count; ++i) {
    const float* const from = pixel_of(picture, static_cast<uint32_t>(in->x[i]), static_cast<uint32_t>(in->y[i]));
    out->r[i] = from[0];
    out->g[i] = from[1];
    out->b[i] = from[2];
    out->a[i] = from[3];
  }
}

/// A triangle that is larger than the picture.
Mesh make_cover(shd_context* context) {
  const float corners[3][3] = {{-1, -1, 0.5f}, {3, -1, 0.5f}, {-1, 3, 0.5f}};
  shd_mesh_desc desc = shd_mesh_desc_default();
  desc.vertex_count = 3;
  for (size_t c = 0; c < 3; ++c) desc.position[c] = {&corners[0][c], sizeof corners[0]};
  Mesh mesh;
  check(shd_mesh_create(context, &desc, mesh.out()), "picture");
  return mesh;
}

}  // namespace

Picture blank_picture(uint32_t width, uint32_t height, const std::array<float, 4>& color) {
  Picture picture = {width, height, std::vector<float>(size_t{4} * width * height)};
  for (size_t i = 0; i < picture.rgba.size(); ++i) picture.rgba[i] = color[i % 4];
  return picture;
}

Picture read_picture(const shd_framebuffer* framebuffer) {
  shd_framebuffer_info info = shd_framebuffer_info_default();
  check(shd_framebuffer_get_info(framebuffer, &info), "picture");
  Picture picture = blank_picture(info.width, info.height, {});
  for (uint32_t c = 0; c < 4; ++c) {
    const shd_f32_out out = {picture.rgba.data() + c, 4 * sizeof(float)};
    check(shd_framebuffer_read_plane(framebuffer, static_cast<shd_plane>(SHD_PLANE_R + c), &out), "picture");
  }
  return picture;
}

Framebuffer write_picture(shd_context* context, const Picture& picture) {
  shd_framebuffer_desc planes = shd_framebuffer_desc_default();
  planes.width = picture.width;
  planes.height = picture.height;
  Framebuffer framebuffer;
  check(shd_framebuffer_create(context, &planes, framebuffer.out()), "framebuffer");
  Picture source = picture;
  shd_material_desc program = shd_material_desc_default();
  program.model = SHD_MODEL_PROGRAM;
  program.program = {copy_pixels, nullptr, &source};
  Material material;
  check(shd_material_create(context, &program, material.out()), "picture");
  const Mesh cover = make_cover(context);
  shd_draw draw = shd_draw_default();
  draw.mesh = cover.get();
  draw.material = material.get();
  draw.flags = SHD_DRAW_KEEP_DEPTH;
  shd_render_desc desc = shd_render_desc_default();
  desc.framebuffer = framebuffer.get();
  desc.draws = &draw;
  desc.draw_count = 1;
  check(shd_render(context, &desc), "picture");
  return framebuffer;
}

void paint_stroke(Picture& picture, const std::vector<PicturePoint>& points, float width, const Rgb& color) {
  float left = HUGE_VALF, right = -HUGE_VALF, top = HUGE_VALF, bottom = -HUGE_VALF;
  for (const PicturePoint& p : points) {
    left = std::min(left, p.x), right = std::max(right, p.x);
    top = std::min(top, p.y), bottom = std::max(bottom, p.y);
  }
  const float around = 0.5f * width + 1.0f;
  const auto pixel = [](float at, uint32_t size) {
    return static_cast<uint32_t>(std::clamp(at, 0.0f, static_cast<float>(size)));
  };
  const uint32_t x0 = pixel(left - around, picture.width), x1 = pixel(right + around + 1.0f, picture.width);
  const uint32_t y0 = pixel(top - around, picture.height), y1 = pixel(bottom + around + 1.0f, picture.height);
  for (uint32_t y = y0; y < y1; ++y) {
    for (uint32_t x = x0; x < x1; ++x) {
      const PicturePoint center = {static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
      const float cover = std::clamp(0.5f * width + 0.5f - distance_to(center, points), 0.0f, 1.0f);
      float* const to = pixel_of(picture, x, y);
      for (size_t c = 0; c < 4; ++c) to[c] += cover * ((c < 3 ? color[c] : 1.0f) - to[c]);
    }
  }
}

Picture reduce_picture(const Picture& picture, uint32_t n) {
  Picture out = blank_picture(picture.width / n, picture.height / n, {});
  const float share = 1.0f / static_cast<float>(n * n);
  for (uint32_t y = 0; y < picture.height; ++y) {
    for (uint32_t x = 0; x < picture.width; ++x) {
      for (size_t c = 0; c < 4; ++c) pixel_of(out, x / n, y / n)[c] += share * pixel_of(picture, x, y)[c];
    }
  }
  return out;
}

Picture join_pictures(const std::vector<Picture>& pictures) {
  uint32_t width = 0;
  for (const Picture& picture : pictures) width += picture.width + kDivider;
  Picture out = blank_picture(width - kDivider, pictures[0].height, {0.2f, 0.2f, 0.2f, 1});
  uint32_t left = 0;
  for (const Picture& picture : pictures) {
    for (uint32_t y = 0; y < picture.height; ++y) {
      std::copy_n(pixel_of(picture, 0, y), size_t{4} * picture.width, pixel_of(out, left, y));
    }
    left += picture.width + kDivider;
  }
  return out;
}

Rgb ramp_color(float part) {
  constexpr Rgb kColors[] = {{0.02f, 0.06f, 0.5f}, {0.0f, 0.45f, 0.75f}, {0.05f, 0.6f, 0.1f},
                             {0.95f, 0.8f, 0.05f}, {0.95f, 0.3f, 0.02f}, {0.7f, 0.01f, 0.01f}};
  constexpr int kSteps = std::size(kColors) - 1;
  const float at = std::clamp(part, 0.0f, 1.0f) * kSteps;
  const auto low = static_cast<size_t>(std::min(static_cast<int>(at), kSteps - 1));
  Rgb out;
  for (size_t c = 0; c < 3; ++c) {
    out[c] = kColors[low][c] + (at - static_cast<float>(low)) * (kColors[low + 1][c] - kColors[low][c]);
  }
  return out;
}
