// SPDX-License-Identifier: MIT
#include "frame/shadow_map.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/executor.h"
#include "light/shadow_fit.h"

namespace shd::frame {
namespace {

constexpr uint32_t kBlock = 2048;  // [texels] edge length of the blocks that are drawn one by one
constexpr uint32_t kPassTriangles = 1u << 21;

/// Whether the depths of a draw depend on its material: it drops fragments, or a program moves its vertices.
bool needs_material(const material::Material& material) {
  return !material::is_unordered(material) && (material::drops_fragments(material) || material.program.vertex);
}

/// The caller's draws that cast shadows, with only depth drawn where possible.
core::Buffer<Draw> casters(const core::Context& context, const ShadowFrame& frame, const light::ShadowOptions& options,
                           bool falls) {
  core::Buffer<Draw> draws(context.allocator);
  for (size_t i = 0; i < frame.draw_count; ++i) {
    Draw draw = frame.draws[i];
    if (!draw.depth.writes) continue;
    if (draw.material && !needs_material(*draw.material)) draw.material = nullptr;
    draw.cull = options.caster_cull;
    draw.depth = {falls ? SHD_COMPARE_GREATER : SHD_COMPARE_LESS, true, 0.0f, 0.0f};
    draw.depth_falls = falls;
    draw.sample_shading = draw.affine = false;
    draws.push_back(draw);
  }
  return draws;
}

/// Corners of the bounds of a draw. Returns false if its mesh has no bounds.
bool find_corners(const Draw& draw, double (&corners)[8][3]) {
  const shd_mesh_info& info = draw.mesh->info;
  if (info.nonfinite_count == info.vertex_count || draw.begin == draw.end) return false;
  for (int i = 0; i < 8; ++i) {
    for (int row = 0; row < 3; ++row) {
      double sum = static_cast<double>(draw.object_to_world[12 + row]);
      for (int k = 0; k < 3; ++k) {
        const float corner = i >> k & 1 ? info.bounds_max[k] : info.bounds_min[k];
        sum += static_cast<double>(draw.object_to_world[4 * k + row]) * static_cast<double>(corner);
      }
      corners[i][row] = sum;
    }
  }
  return true;
}

light::ShadowPlacement fit(const ShadowFrame& frame, const light::ShadowOptions& options) {
  light::ShadowFit fit(*frame.light);
  if (frame.has_bounds) fit.limit(frame.bounds_min, frame.bounds_max);
  if (frame.has_planes) fit.set_planes(frame.near, frame.far);
  for (size_t i = 0; i < frame.draw_count; ++i) {
    double corners[8][3];
    if (frame.draws[i].depth.writes && find_corners(frame.draws[i], corners)) fit.add(corners);
  }
  return fit.place(options);
}

/// View of a face, with z in 0..1. Orthographic z increases from near to far. Perspective z decreases, near (far - z) /
/// ((far - near) z), which distributes the precision of floats over all distances.
shd_view view_of(const light::ShadowPlacement& placement, uint32_t face, uint32_t size) {
  const bool is_cube = placement.projection == light::ShadowProjection::kCube;
  const light::ShadowAxes axes = is_cube ? light::cube_axes(face) : placement.axes;
  shd_view view = {};
  const float* const rows[3] = {axes.right, axes.down, axes.forward};
  for (int r = 0; r < 3; ++r) {
    const double sign = r == 0 ? 1.0 : -1.0;
    double shift = 0.0;
    for (int c = 0; c < 3; ++c) {
      view.world_to_view[4 * c + r] = static_cast<float>(sign * static_cast<double>(rows[r][c]));
      shift += static_cast<double>(rows[r][c]) * static_cast<double>(placement.origin[c]);
    }
    view.world_to_view[12 + r] = static_cast<float>(0.0 - sign * shift);
    view.eye[r] = placement.origin[r];
  }
  view.world_to_view[15] = 1.0f;
  const double near = static_cast<double>(placement.near), far = static_cast<double>(placement.far);
  view.view_to_clip[0] = view.view_to_clip[5] = static_cast<float>(2.0 * static_cast<double>(placement.scale) / size);
  if (placement.projection == light::ShadowProjection::kOrthographic) {
    view.view_to_clip[10] = static_cast<float>(-1.0 / (far - near));
    view.view_to_clip[14] = static_cast<float>(-near / (far - near));
    view.view_to_clip[15] = 1.0f;
  } else {
    view.view_to_clip[10] = static_cast<float>(near / (far - near));
    view.view_to_clip[14] = static_cast<float>(near * far / (far - near));
    view.view_to_clip[11] = -1.0f;
  }
  return view;
}

/// Converts depths of a framebuffer to world lengths.
struct Linear {
  bool is_perspective;
  double near, range, product;

  explicit Linear(const light::ShadowPlacement& placement)
      : is_perspective(placement.projection != light::ShadowProjection::kOrthographic),
        near(static_cast<double>(placement.near)),
        range(static_cast<double>(placement.far) - near),
        product(near * static_cast<double>(placement.far)) {}
  float empty() const { return is_perspective ? 0.0f : 1.0f; }
  float operator()(float depth) const {
    if (depth == empty()) return std::numeric_limits<float>::infinity();
    const double z = static_cast<double>(depth);
    return static_cast<float>(is_perspective ? product / (range * z + near) : near + range * z);
  }
};

class Drawing {
 public:
  Drawing(const core::Context& context, const ShadowFrame& frame, const light::ShadowOptions& options,
          light::ShadowMap* map)
      : context_(context),
        map_(map),
        linear_(map->placement),
        draws_(casters(context, frame, options, linear_.is_perspective)) {
    shd_framebuffer_desc desc = shd_framebuffer_desc_default();
    desc.width = desc.height = std::min(map->size, kBlock);
    build(context, desc, &framebuffer_);
  }

  void draw_face(uint32_t face) {
    const shd_view view = view_of(map_->placement, face, map_->size);
    for (uint32_t top = 0; top < map_->size; top += kBlock) {
      for (uint32_t left = 0; left < map_->size; left += kBlock) draw_block(face, view, left, top);
    }
  }

 private:
  void draw_block(uint32_t face, const shd_view& view, uint32_t left, uint32_t top) {
    Frame frame = {};
    frame.framebuffer = &framebuffer_;
    frame.window = {static_cast<int32_t>(left), static_cast<int32_t>(top)};
    frame.viewport = {0, 0, map_->size, map_->size};
    frame.scissor = geometry::pixel_rectangle(0, 0, map_->size, map_->size);
    frame.view = view;
    frame.clear_depth = linear_.empty();
    frame.draws = draws_.data();
    frame.draw_count = draws_.size();
    frame.pass_triangles = kPassTriangles;
    shd_render_stats stats = {};
    render(context_, frame, &stats);
    const uint32_t width = std::min(kBlock, map_->size - left), height = std::min(kBlock, map_->size - top);
    core::parallel_for(context_, height, [&](uint32_t y, uint32_t) {
      const float* from = framebuffer_.plane[SHD_PLANE_DEPTH].data() + y * framebuffer_.stride;
      float* to = map_->depth.data() + face * map_->face_stride + (size_t{top} + y + map_->pad) * map_->pitch +
                  map_->pad + left;
      for (uint32_t x = 0; x < width; ++x) to[x] = linear_(from[x]);
    });
  }

  const core::Context& context_;
  light::ShadowMap* map_;
  const Linear linear_;
  const core::Buffer<Draw> draws_;
  film::Framebuffer framebuffer_{};
};

}  // namespace

void render_shadow(const core::Context& context, const core::Context& owner, const ShadowFrame& frame,
                   light::Shadow* shadow) {
  const light::ShadowOptions& options = shadow->options;
  light::ShadowMap map = {};
  allocate(owner.allocator, options, fit(frame, options), &map);
  {
    Drawing drawing(context, frame, options, &map);
    for (uint32_t face = 0; face < map.placement.face_count; ++face) drawing.draw_face(face);
  }
  build_tables(context, owner.allocator, options, &map);
  shadow->map = std::move(map);
  shadow->is_rendered = true;
}

}  // namespace shd::frame
