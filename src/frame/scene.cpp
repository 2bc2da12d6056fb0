// SPDX-License-Identifier: MIT
#include "frame/scene.h"

#include <algorithm>

#include "core/executor.h"
#include "frame/bake.h"
#include "frame/stats.h"
#include "frame/stopwatch.h"
#include "frame/visibility.h"
#include "geometry/assemble.h"
#include "geometry/attributes.h"
#include "geometry/unwrap.h"
#include "geometry/vertex_program.h"
#include "geometry/vertex_window.h"
#include "raster/nearest.h"
#include "shade/needs.h"

namespace shd::frame {
namespace {

struct Range {
  size_t begin, end;
};

/// A part of the vertex rows or of the triangles of a draw.
struct Part {
  uint32_t draw;
  size_t begin, end;
};

constexpr size_t kVerticesPerPart = 8192;  // a multiple of data::kRowPad
constexpr size_t kTrianglesPerPart = 16384;
constexpr size_t kMaxGroups = 256;  // bounds the bin table, whose size is tiles x groups

/// Divides the items range_of(draw) of each draw into parts of at most `size`. Throws std::bad_alloc.
template <class RangeOf>
core::Buffer<Part> make_parts(const core::Context& context, const Frame& frame, size_t size, RangeOf range_of) {
  core::Buffer<Part> parts(context.allocator);
  for (size_t draw = 0; draw < frame.draw_count; ++draw) {
    const Range range = range_of(draw);
    for (size_t begin = range.begin; begin < range.end; begin += size) {
      parts.push_back({static_cast<uint32_t>(draw), begin, std::min(range.end, begin + size)});
    }
  }
  return parts;
}

geometry::VertexProgram vertex_program(const Frame& frame, const Draw& draw) {
  const shd_material_program& program = draw.material->program;
  return {program.vertex,       program.user_data, draw.uniforms, &frame.view,
          draw.object_to_world, draw.index,        draw.instance, draw.material->varying_count};
}

/// Transforms the vertices of a mesh from `begin` on to the rows of a part, with the program of the draw if it has one.
void transform(const core::Context& context, const Frame& frame, const Part& part, const geometry::NumberedMesh& mesh,
               size_t begin, Scene* scene, geometry::VertexColumns* scratch) {
  const Draw& draw = frame.draws[part.draw];
  const geometry::Transform& matrices = scene->transforms[part.draw];
  geometry::Vertices* out = &scene->vertices[part.draw];
  const geometry::VertexRange range = {begin, begin + (part.end - part.begin), part.begin};
  geometry::transform_attributes(mesh.mesh, matrices, range, out);
  if (!draw.material || !draw.material->program.vertex) {
    return geometry::transform_vertices(context.simd, mesh.mesh, matrices, range, out);
  }
  if (scratch->block.size() == 0) geometry::allocate(context.allocator, scratch);
  geometry::run_vertex_program(context.simd, mesh, matrices, vertex_program(frame, draw), range, scratch, out);
}

/// Where the triangles of a bake lie.
geometry::Atlas atlas_of(const Frame& frame) {
  return {frame.bake->uv_set, frame.framebuffer->width, frame.framebuffer->height};
}

/// Transforms the vertices of one part.
void transform_part(const core::Context& context, const Frame& frame, const Part& part, Scene* scene,
                    geometry::VertexColumns* scratch) {
  const geometry::Mesh& mesh = *frame.draws[part.draw].mesh;
  const geometry::Vertices& rows = scene->vertices[part.draw];
  if (geometry::is_scattered(rows)) {
    const geometry::Mesh corners = geometry::gather_corners(context.allocator, mesh, rows, part.begin, part.end);
    transform(context, frame, part, {corners, rows.corners + part.begin}, 0, scene, scratch);
  } else {
    transform(context, frame, part, {mesh, nullptr}, rows.first_index + part.begin, scene, scratch);
  }
  if (!frame.bake) return;
  geometry::unwrap(atlas_of(frame), scene->transforms[part.draw], part.begin, part.end, &scene->vertices[part.draw]);
}

void transform_all(const core::Context& context, const Frame& frame, Scene* scene) {
  const geometry::PixelBox visible = visible_box(frame);
  for (size_t i = 0; i < frame.draw_count; ++i) {
    const Draw& draw = frame.draws[i];
    geometry::allocate_window(context.allocator, *draw.mesh, draw.begin, draw.end,
                              draw.material ? draw.material->varying_count : 0, &scene->vertices[i]);
    scene->vertices[i].affine = draw.affine;
    if (draw.material) {
      uint32_t extras = shade::needed_extras(*draw.material);
      if (frame.bake && frame.bake->uv_set == 1) extras |= geometry::kExtraTexture1;
      geometry::allocate_attributes(context.allocator, *draw.mesh, extras, &scene->vertices[i]);
    }
    scene->transforms[i] = geometry::make_transform(frame.view, draw.object_to_world, frame.viewport, visible);
  }
  const auto rows = [&](size_t draw) { return Range{0, geometry::row_count(scene->vertices[draw])}; };
  const core::Buffer<Part> parts = make_parts(context, frame, kVerticesPerPart, rows);
  core::Objects<geometry::VertexColumns> scratch(context.allocator, context.executor.worker_count);
  core::parallel_for(context, static_cast<uint32_t>(parts.size()), [&](uint32_t i, uint32_t worker) {
    transform_part(context, frame, parts[i], scene, &scratch[worker]);
  });
}

/// Positions in a pixel that a triangle must pass to be drawn.
geometry::SampleExtent sample_extent(const Frame& frame) {
  return frame.bake ? raster::kTouchExtent : raster::sample_pattern(frame.framebuffer->samples).extent;
}

geometry::Assembly make_assembly(const Frame& frame, uint32_t index, const geometry::Vertices& vertices) {
  const Draw& draw = frame.draws[index];
  geometry::Assembly assembly = {&vertices,
                                 index,
                                 draw.cull,
                                 visible_box(frame),
                                 sample_extent(frame),
                                 draw.outline,
                                 draw.mesh,
                                 {draw.outline.edges, static_cast<double>(draw.outline.crease_cosine), {}}};
  if (draw.outline.fill == SHD_FILL_LINES) {
    geometry::centre_of_projection(frame.view, draw.object_to_world, assembly.query.eye);
  }
  return assembly;
}

/// Assembles parts into groups; if there are many parts, consecutive parts share a group.
void assemble_all(const core::Context& context, const Frame& frame, const core::Buffer<Part>& parts, Scene* scene,
                  shd_render_stats* stats) {
  const size_t groups = scene->groups.size();
  core::Array<shd_render_stats> group_stats(context.allocator, groups);
  group_stats.fill_zero();
  core::parallel_for(context, static_cast<uint32_t>(groups), [&](uint32_t g, uint32_t) {
    raster::TriangleGroup& group = scene->groups[g];
    group.attach(context.allocator);
    for (size_t i = parts.size() * g / groups; i < parts.size() * (g + 1) / groups; ++i) {
      const Part& part = parts[i];
      const geometry::Assembly assembly = make_assembly(frame, part.draw, scene->vertices[part.draw]);
      geometry::assemble(assembly, part.begin, part.end, &group, &group_stats[g]);
    }
  });
  for (size_t g = 0; g < groups; ++g) add(group_stats[g], stats);
}

/// Counts the triangles of a bake that reach beyond the texture.
void count_outside(const Frame& frame, const Scene& scene) {
  const geometry::Atlas atlas = atlas_of(frame);
  const auto width = static_cast<float>(atlas.width), height = static_cast<float>(atlas.height);
  for (size_t i = 0; i < frame.draw_count; ++i) {
    const geometry::Vertices& vertices = scene.vertices[i];
    for (size_t t = frame.draws[i].begin; t < frame.draws[i].end; ++t) {
      bool is_inside = true;
      for (size_t k = 0; k < 3; ++k) {
        const float* at = &vertices.raster[4 * size_t{geometry::row_of(vertices, t, k)}];
        is_inside &= at[0] >= 0.0f && at[0] <= width && at[1] >= 0.0f && at[1] <= height;
      }
      frame.bake->outside_triangles += !is_inside;
    }
  }
}

/// One group for each part of a draw's triangles, up to kMaxGroups.
size_t group_count(const Frame& frame) {
  size_t parts = 0;
  for (size_t draw = 0; draw < frame.draw_count; ++draw) {
    const size_t triangles = frame.draws[draw].end - frame.draws[draw].begin;
    parts += (triangles + kTrianglesPerPart - 1) / kTrianglesPerPart;
  }
  return std::min(parts, kMaxGroups);
}

}  // namespace

geometry::PixelBox window_box(const Frame& frame) {
  return geometry::pixel_rectangle(frame.window.left, frame.window.top, frame.framebuffer->width,
                                   frame.framebuffer->height);
}

geometry::PixelBox visible_box(const Frame& frame) {
  const geometry::Viewport& v = frame.viewport;
  const geometry::PixelBox viewport =
      geometry::pixel_rectangle(static_cast<int32_t>(v.x), static_cast<int32_t>(v.y), v.width, v.height);
  return geometry::intersection(geometry::intersection(window_box(frame), viewport), frame.scissor);
}

Scene::Scene(const core::Allocator& allocator, const Frame& frame)
    : vertices(allocator, frame.draw_count),
      transforms(allocator, frame.draw_count),
      groups(allocator, group_count(frame)),
      bins() {}

void prepare(const core::Context& context, const Frame& frame, Scene* scene, shd_render_stats* stats) {
  const auto triangles = [&](size_t draw) { return Range{frame.draws[draw].begin, frame.draws[draw].end}; };
  Stopwatch watch;
  transform_all(context, frame, scene);
  if (frame.bake) count_outside(frame, *scene);
  stats->vertex_seconds += watch.lap();
  assemble_all(context, frame, make_parts(context, frame, kTrianglesPerPart, triangles), scene, stats);
  stats->assembly_seconds += watch.lap();
  order_triangles(context, frame, scene, stats);
  raster::bin_triangles(context, scene->groups.data(), static_cast<uint32_t>(scene->groups.size()), window_box(frame),
                        visible_box(frame), sample_extent(frame), &scene->bins);
  stats->binning_seconds += watch.lap();
}

}  // namespace shd::frame
