// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "command/failure.h"
#include "tool/show.h"

namespace {

using Vector = std::array<float, 3>;

/// Target 1 gets the tangent and its handedness, target 2 the normal.
void give_frames(const shd_fragments* in, shd_radiance* out, void*) {
  const float* const tangent[4] = {in->tx, in->ty, in->tz, in->tw};
  const float* const normal[3] = {in->nx, in->ny, in->nz};
  for (size_t c = 0; c < 4; ++c) std::copy_n(tangent[c], in->count, out->target[0][c]);
  for (size_t c = 0; c < 3; ++c) std::copy_n(normal[c], in->count, out->target[1][c]);
}

/// Planes of the frames of all pixels, at their centres.
struct TangentFrames {
  std::vector<uint32_t> draw;
  std::vector<float> position[3], tangent[4], normal[3];
};

TangentFrames draw_frames(const Stage& stage, const Frame& frame) {
  shd_framebuffer_desc planes = shd_framebuffer_desc_default();
  planes.width = stage.options.width;
  planes.height = stage.options.height;
  planes.aovs = SHD_AOV_DRAW | SHD_AOV_POSITION | SHD_AOV_TARGET1 | SHD_AOV_TARGET2;
  Framebuffer framebuffer;
  check(shd_framebuffer_create(stage.context, &planes, framebuffer.out()), "framebuffer");
  shd_material_desc program = shd_material_desc_default();
  program.model = SHD_MODEL_PROGRAM;
  program.program.fragment = give_frames;
  Material material;
  check(shd_material_create(stage.context, &program, material.out()), "--show tangents");
  std::vector<shd_draw> draws = frame.draws.draws;
  for (shd_draw& draw : draws) draw.material = material.get(), draw.frequency = SHD_FREQUENCY_PHONG;
  shd_render_desc desc = shd_render_desc_default();
  desc.framebuffer = framebuffer.get();
  desc.view = frame.camera.view;
  desc.draws = draws.data();
  desc.draw_count = draws.size();
  desc.visibility = stage.options.visibility;
  check(shd_render(stage.context, &desc), "--show tangents");
  TangentFrames out;
  out.draw = read_numbers(framebuffer.get(), SHD_PLANE_DRAW);
  const auto read = [&](std::vector<float>& to, int first, int c) {
    to = read_floats(framebuffer.get(), static_cast<shd_plane>(first + c));
  };
  for (int c = 0; c < 3; ++c) read(out.position[c], SHD_PLANE_PX, c);
  for (int c = 0; c < 4; ++c) read(out.tangent[c], SHD_PLANE_TARGET1_R, c);
  for (int c = 0; c < 3; ++c) read(out.normal[c], SHD_PLANE_TARGET2_R, c);
  return out;
}

/// A vector of length 1, or 0.
Vector unit(const Vector& v) {
  const float length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return length > 0.0f ? Vector{v[0] / length, v[1] / length, v[2] / length} : Vector{};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Where a world-space point is in the picture, and its w.
PicturePoint project(const Stage& stage, const shd_view& view, const Vector& world, float& w) {
  float eye[4], clip[4];
  for (int row = 0; row < 4; ++row) {
    const float* const m = view.world_to_view + row;
    eye[row] = m[0] * world[0] + m[4] * world[1] + m[8] * world[2] + m[12];
  }
  for (int row = 0; row < 4; ++row) {
    const float* const m = view.view_to_clip + row;
    clip[row] = m[0] * eye[0] + m[4] * eye[1] + m[8] * eye[2] + m[12] * eye[3];
  }
  w = clip[3];
  return {0.5f * (1.0f + clip[0] / w) * static_cast<float>(stage.options.width),
          0.5f * (1.0f - clip[1] / w) * static_cast<float>(stage.options.height)};
}

void paint_axes(const Stage& stage, const shd_view& view, const Vector& at, const Vector axes[3], float pixels,
                Picture& picture) {
  constexpr Rgb kAxes[3] = {{0.9f, 0.02f, 0.02f}, {0.02f, 0.7f, 0.05f}, {0.05f, 0.15f, 1.0f}};
  float w = 0, end_w = 0;
  const PicturePoint from = project(stage, view, at, w);
  const float length = pixels * w / (0.5f * static_cast<float>(stage.options.height) * std::fabs(view.view_to_clip[5]));
  for (const bool is_edge : {true, false}) {
    for (int axis = 0; axis < 3; ++axis) {
      Vector end = at;
      for (size_t c = 0; c < 3; ++c) end[c] += length * axes[axis][c];
      const PicturePoint to = project(stage, view, end, end_w);
      if (!(end_w > 0.0f)) continue;
      paint_stroke(picture, {from, to}, is_edge ? 4.0f : 2.0f, is_edge ? Rgb{0.0f, 0.0f, 0.0f} : kAxes[axis]);
    }
  }
}

}  // namespace

Picture show_tangents(const Stage& stage, const Frame& frame) {
  Picture picture = shade_frame(stage, frame);
  const TangentFrames frames = draw_frames(stage, frame);
  visit_grid(stage.options, [&](uint32_t x, uint32_t y, float step) {
    const size_t i = size_t{y} * stage.options.width + x;
    if (frames.draw[i] == kNothing) return;
    const auto vector = [i](const std::vector<float>* from) { return Vector{from[0][i], from[1][i], from[2][i]}; };
    const Vector n = unit(vector(frames.normal)), t = unit(vector(frames.tangent));
    Vector b = unit(cross(n, t));
    for (float& c : b) c *= frames.tangent[3][i];
    const Vector axes[3] = {t, b, n};
    paint_axes(stage, frame.camera.view, vector(frames.position), axes, 0.45f * step, picture);
  });
  return picture;
}
