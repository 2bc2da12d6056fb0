// SPDX-License-Identifier: MIT
#include <shd/mesh.h>
#include <shd/shapes.h>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "geometry/mesh.h"
#include "shapes/shapes.h"

namespace {

using namespace shd;
using namespace shd::abi;

/// Parts in one direction: the default for 0, and the range.
struct Segments {
  uint32_t usual, low, high;
};
constexpr Segments kUnused = {0, 0, 0};
constexpr Segments kSide = {1, 1, SHD_MAX_SHAPE_SEGMENTS};

/// Parameters and functions of each shd_shape.
struct Shape {
  Segments segments[3];
  bool has_radius, has_tube, has_size[3];
  shapes::Counts (*count)(const shd_shape_desc& desc);
  void (*fill)(const shd_shape_desc& desc, shapes::Sink& out);
};
constexpr Shape kShapes[] = {
    {{{32, 3, SHD_MAX_SHAPE_SEGMENTS}, {16, 2, SHD_MAX_SHAPE_SEGMENTS}, kUnused},
     true,
     false,
     {false, false, false},
     shapes::count_sphere,
     shapes::fill_sphere},
    {{kSide, kSide, kSide}, false, false, {true, true, true}, shapes::count_box, shapes::fill_box},
    {{kSide, kUnused, kSide}, false, false, {true, false, true}, shapes::count_plane, shapes::fill_plane},
    {{{48, 3, SHD_MAX_SHAPE_SEGMENTS}, {24, 3, SHD_MAX_SHAPE_SEGMENTS}, kUnused},
     true,
     true,
     {false, false, false},
     shapes::count_torus,
     shapes::fill_torus},
    {{{8, 2, SHD_MAX_TEAPOT_SEGMENTS}, kUnused, kUnused},
     false,
     false,
     {false, false, false},
     shapes::count_teapot,
     shapes::fill_teapot},
};
static_assert(sizeof kShapes / sizeof kShapes[0] == SHD_SHAPE_TEAPOT + 1);

shd_result check_length(const char* field, float value) {
  return check_range(field, static_cast<double>(value), 1e-30, 1e30);
}

shd_result check_lengths(const Shape& shape, const shd_shape_desc& desc) {
  if (shape.has_radius) SHD_TRY(check_length("shape.radius", desc.radius));
  if (shape.has_tube) {
    SHD_TRY(check_length("shape.tube_radius", desc.tube_radius));
    if (!(desc.tube_radius < desc.radius)) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT, "shape.tube_radius: %g is not below radius %g",
                        static_cast<double>(desc.tube_radius), static_cast<double>(desc.radius));
    }
  }
  constexpr const char* kSizes[3] = {"shape.size[0]", "shape.size[1]", "shape.size[2]"};
  for (int axis = 0; axis < 3; ++axis) {
    if (shape.has_size[axis]) SHD_TRY(check_length(kSizes[axis], desc.size[axis]));
  }
  return SHD_OK;
}

/// Checks a desc and puts the usual numbers of segments in the place of zeros.
shd_result read_shape(const shd_shape_desc* in, shd_shape_desc* desc, const Shape** shape) {
  constexpr const char* kSegments[3] = {"shape.segments[0]", "shape.segments[1]", "shape.segments[2]"};
  *desc = shd_shape_desc_default();
  SHD_TRY(read_desc("shape", in, true, desc));
  SHD_TRY(check_enum("shape.kind", desc->kind, 0, SHD_SHAPE_TEAPOT));
  *shape = &kShapes[desc->kind];
  SHD_TRY(check_lengths(**shape, *desc));
  for (int i = 0; i < 3; ++i) {
    const Segments& segments = (*shape)->segments[i];
    if (segments.high == 0) continue;
    if (desc->segments[i] == 0) desc->segments[i] = segments.usual;
    SHD_TRY(check_count(kSegments[i], desc->segments[i], segments.low, segments.high));
  }
  return SHD_OK;
}

shd_result check_columns(const shd_shape_columns& columns, const shapes::Counts& counts) {
  constexpr const char* kPositions[3] = {"columns.position[0]", "columns.position[1]", "columns.position[2]"};
  constexpr const char* kNormals[3] = {"columns.normal[0]", "columns.normal[1]", "columns.normal[2]"};
  constexpr const char* kUv[2] = {"columns.uv[0]", "columns.uv[1]"};
  bool has_vertices = false;
  for (int i = 0; i < 3; ++i) {
    SHD_TRY(check_column(kPositions[i], columns.position[i], counts.vertices));
    SHD_TRY(check_column(kNormals[i], columns.normal[i], counts.vertices));
    has_vertices = has_vertices || columns.position[i].data || columns.normal[i].data;
  }
  for (int i = 0; i < 2; ++i) {
    SHD_TRY(check_column(kUv[i], columns.uv[i], counts.vertices));
    has_vertices = has_vertices || columns.uv[i].data;
  }
  SHD_TRY(check_column("columns.indices", columns.indices, 3 * counts.triangles));
  if (has_vertices) SHD_TRY(check_count("columns.vertex_count", columns.vertex_count, counts.vertices, UINT32_MAX));
  if (!columns.indices.data) return SHD_OK;
  return check_count("columns.index_count", columns.index_count, 3 * counts.triangles, SIZE_MAX);
}

/// Builds the mesh of a shape from columns that live as long as the call.
geometry::Mesh build_mesh(core::Context& owner, const Shape& shape, const shd_shape_desc& desc, shd_mesh_flags flags) {
  constexpr size_t kColumns = 8;  // position, normal, uv
  const shapes::Counts counts = shape.count(desc);
  const auto vertices = static_cast<size_t>(counts.vertices);
  core::Array<float> values(owner.allocator, kColumns * vertices);
  core::Array<uint32_t> indices(owner.allocator, static_cast<size_t>(3 * counts.triangles));
  shapes::Sink sink = {};
  shd_mesh_desc made = shd_mesh_desc_default();
  for (size_t c = 0; c < kColumns; ++c) {
    float* const column = values.data() + c * vertices;
    (c < 3 ? sink.position[c] : c < 6 ? sink.normal[c - 3] : sink.uv[c - 6]).data = column;
    (c < 3 ? made.position[c] : c < 6 ? made.normal[c - 3] : made.uv[c - 6]).data = column;
  }
  sink.indices.data = indices.data();
  shape.fill(desc, sink);
  made.flags = flags;
  made.vertex_count = static_cast<uint32_t>(vertices);
  made.indices.data = indices.data();
  made.index_count = indices.size();
  geometry::Mesh mesh{};
  geometry::build(owner, made, &mesh);
  return mesh;
}

}  // namespace

extern "C" {

shd_result shd_shape_count(const shd_shape_desc* desc, size_t* out_vertex_count, size_t* out_index_count) {
  if (out_vertex_count) *out_vertex_count = 0;
  if (out_index_count) *out_index_count = 0;
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_vertex_count", out_vertex_count));
    SHD_TRY(check_not_null("out_index_count", out_index_count));
    shd_shape_desc read;
    const Shape* shape = nullptr;
    SHD_TRY(read_shape(desc, &read, &shape));
    const shapes::Counts counts = shape->count(read);
    *out_vertex_count = static_cast<uint32_t>(counts.vertices);
    *out_index_count = static_cast<size_t>(3 * counts.triangles);
    return SHD_OK;
  });
}

shd_result shd_shape_fill(const shd_shape_desc* desc, const shd_shape_columns* columns) {
  return guard([&]() -> shd_result {
    shd_shape_desc read;
    const Shape* shape = nullptr;
    SHD_TRY(read_shape(desc, &read, &shape));
    shd_shape_columns out = shd_shape_columns_default();
    SHD_TRY(read_desc("columns", columns, false, &out));
    SHD_TRY(check_columns(out, shape->count(read)));
    shapes::Sink sink = {};
    for (int i = 0; i < 3; ++i) sink.position[i] = out.position[i], sink.normal[i] = out.normal[i];
    for (int i = 0; i < 2; ++i) sink.uv[i] = out.uv[i];
    sink.indices = out.indices;
    shape->fill(read, sink);
    return SHD_OK;
  });
}

shd_result shd_mesh_create_shape(shd_context* context, const shd_shape_desc* desc, shd_mesh_flags flags,
                                 shd_mesh** out_mesh) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_mesh", out_mesh));
    *out_mesh = nullptr;
    SHD_TRY(check_context(context));
    shd_shape_desc read;
    const Shape* shape = nullptr;
    SHD_TRY(read_shape(desc, &read, &shape));
    SHD_TRY(check_flags("flags", flags, SHD_MESH_KEEP_NONFINITE | SHD_MESH_TANGENTS | SHD_MESH_ADJACENCY));
    core::Context& owner = context_of(context);
    auto* mesh = core::create<geometry::Mesh>(owner.allocator, build_mesh(owner, *shape, read, flags));
    make_handle(owner, core::ObjectType::kMesh, mesh, out_mesh);
    return SHD_OK;
  });
}

}  // extern "C"
