// SPDX-License-Identifier: MIT
#include "frame/visibility.h"

#include "raster/newell.h"
#include "raster/painter.h"

namespace shd::frame {
namespace {

core::Array<raster::PaintRule> make_rules(const core::Context& context, const Frame& frame) {
  core::Array<raster::PaintRule> rules(context.allocator, frame.draw_count);
  for (size_t i = 0; i < frame.draw_count; ++i) {
    const Draw& draw = frame.draws[i];
    const bool unordered = draw.material && material::is_unordered(*draw.material);
    rules[i] = {!unordered, draw.depth_falls, draw.depth.bias, draw.depth.slope_bias};
  }
  return rules;
}

/// Distributes the painted triangles to the groups, followed by the triangles that are not painted.
void distribute_painted(const core::Context& context, const raster::Painting& painting, size_t painted, Scene* scene) {
  core::Buffer<geometry::ScreenTriangle> rest(context.allocator);
  size_t seen = 0;
  for (size_t g = 0; g < scene->groups.size(); ++g) {
    const raster::TriangleGroup& group = scene->groups[g];
    for (size_t i = 0; i < group.size(); ++i, ++seen) {
      if (seen >= painted) rest.push_back(group[i]);
    }
  }
  const size_t sorted = painting.order.size();
  const auto at = [&](size_t i) {
    return i < sorted ? painting.triangles[painting.order[i]].triangle : rest[i - sorted];
  };
  raster::distribute(context, sorted + rest.size(), at, &scene->groups);
}

/// Makes sort triangles of the first `painted` triangles of the scene.
void make_sort_triangles(const Scene& scene, const raster::PaintRule* rules, size_t painted, raster::Painting* out) {
  out->triangles.reserve(painted);
  out->order.reserve(painted);
  for (size_t g = 0; g < scene.groups.size(); ++g) {
    const raster::TriangleGroup& group = scene.groups[g];
    for (size_t i = 0; i < group.size() && out->triangles.size() < painted; ++i) {
      out->order.push_back(static_cast<uint32_t>(out->triangles.size()));
      out->triangles.push_back(raster::make_sort_triangle(group[i], rules[group[i].draw]));
    }
  }
}

}  // namespace

void order_triangles(const core::Context& context, const Frame& frame, Scene* scene, shd_render_stats* stats) {
  if (frame.visibility == SHD_VISIBILITY_DEPTH || scene->groups.size() == 0) return;
  const core::Array<raster::PaintRule> rules = make_rules(context, frame);
  const size_t painted = raster::sort_far_to_near(context, rules.data(), &scene->groups);
  if (painted == 0 || (frame.visibility == SHD_VISIBILITY_PAINTER && !frame.counts_conflicts)) return;
  raster::Painting painting;
  painting.triangles.attach(context.allocator);
  painting.order.attach(context.allocator);
  make_sort_triangles(*scene, rules.data(), painted, &painting);
  const raster::PaintArea area = {visible_box(frame), raster::sample_pattern(frame.framebuffer->samples).extent};
  if (frame.visibility == SHD_VISIBILITY_NEWELL) {
    raster::newell(context, area, &painting);
    distribute_painted(context, painting, painted, scene);
    stats->split_count = painting.cuts;
  }
  if (!frame.counts_conflicts || painting.order.size() == 0) return;
  raster::SortGrid grid;
  raster::make_grid(context.allocator, area.pixels, painting.triangles.data(), painting.order.data(),
                    painting.order.size(), &grid);
  stats->order_conflict_count = raster::count_conflicts(context, painting.triangles.data(), grid);
}

}  // namespace shd::frame
