// SPDX-License-Identifier: MIT
#include "geometry/vertex.h"

#include <algorithm>

#include "data/data.h"
#include "data/matrix.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/vertex.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "geometry/vertex-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::geometry::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::Vec3V;

void TransformVertices(const Mesh& mesh, const Transform& transform, const VertexRange& range, Vertices& out) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  for (size_t i = range.begin; i < range.end; i += hn::Lanes(d)) {
    const size_t to = range.row + (i - range.begin);
    const Vec3V<V> p = {hn::Load(d, &mesh.px[i]), hn::Load(d, &mesh.py[i]), hn::Load(d, &mesh.pz[i])};
    const Vec3V<V> n = {hn::Load(d, &mesh.nx[i]), hn::Load(d, &mesh.ny[i]), hn::Load(d, &mesh.nz[i])};
    const Homogeneous<V> h = {TransformRow(d, transform.raster, 0, p), TransformRow(d, transform.raster, 1, p),
                              TransformRow(d, transform.raster, 2, p), TransformRow(d, transform.raster, 3, p)};
    const Vec3V<V> world = WorldPosition(d, transform, p), normal = WorldNormal(d, transform, n);

    // A sum is finite only if all its terms are finite; the factor 1/8 keeps sums of finite terms from overflowing.
    const V eighth = hn::Set(d, 0.125f);
    const V clip_sum = hn::Abs(h.x) * eighth + hn::Abs(h.y) * eighth + (hn::Abs(h.z) * eighth + hn::Abs(h.w) * eighth);
    const V world_sum = hn::Abs(world.x) * eighth + hn::Abs(world.y) * eighth + hn::Abs(world.z) * eighth;
    const auto finite = hn::Lt(clip_sum * eighth + world_sum * eighth, hn::Inf(d));
    StorePositions(d, world, hn::Load(d, &mesh.u[i]), to, out);
    StoreNormals(d, normal, hn::Load(d, &mesh.v[i]), to, out);
    StoreRaster(d, transform, h, finite, to, out);
  }
}

}  // namespace shd::geometry::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::geometry {

HWY_EXPORT(TransformVertices);

static_assert(sizeof(ScreenVertex) == 16, "stored as rows of four 32-bit lanes");

Transform make_transform(const shd_view& view, const float object_to_world[16], const Viewport& viewport,
                         const PixelBox& visible) {
  double world[16], to_view[16], to_clip[16], object_to_view[16], clip[16];
  for (int i = 0; i < 16; ++i) {
    world[i] = static_cast<double>(object_to_world[i]);
    to_view[i] = static_cast<double>(view.world_to_view[i]);
    to_clip[i] = static_cast<double>(view.view_to_clip[i]);
  }
  data::multiply(to_view, world, object_to_view);
  data::multiply(to_clip, object_to_view, clip);

  Transform transform;
  const double half_width = 0.5 * viewport.width, half_height = 0.5 * viewport.height;
  const double left = viewport.x, top = viewport.y;
  for (int c = 0; c < 4; ++c) {
    const double* column = clip + 4 * c;
    transform.raster[4 * c + 0] = static_cast<float>(half_width * (column[3] + column[0]) + left * column[3]);
    transform.raster[4 * c + 1] = static_cast<float>(half_height * (column[3] - column[1]) + top * column[3]);
    transform.raster[4 * c + 2] = static_cast<float>(column[2]);
    transform.raster[4 * c + 3] = static_cast<float>(column[3]);
  }
  for (int i = 0; i < 16; ++i) transform.world[i] = object_to_world[i];
  for (int i = 0; i < 16; ++i) transform.clip[i] = static_cast<float>(clip[i]);
  transform.half[0] = static_cast<float>(half_width);
  transform.half[1] = static_cast<float>(half_height);
  transform.centre[0] = static_cast<float>(left + half_width);
  transform.centre[1] = static_cast<float>(top + half_height);

  // Column c of the cofactor matrix is the cross product of the other two columns.
  double cofactor[9], largest = 0.0;
  for (int c = 0; c < 3; ++c) {
    const double *a = world + 4 * ((c + 1) % 3), *b = world + 4 * ((c + 2) % 3);
    for (int r = 0; r < 3; ++r) {
      cofactor[3 * c + r] = a[(r + 1) % 3] * b[(r + 2) % 3] - a[(r + 2) % 3] * b[(r + 1) % 3];
      largest = cofactor[3 * c + r] > largest ? cofactor[3 * c + r] : largest;
      largest = -cofactor[3 * c + r] > largest ? -cofactor[3 * c + r] : largest;
    }
  }
  const double determinant = world[0] * cofactor[0] + world[1] * cofactor[1] + world[2] * cofactor[2];
  transform.orientation = determinant < 0.0 ? -1.0f : 1.0f;
  const double scale = largest > 0.0 ? static_cast<double>(transform.orientation) / largest : 0.0;
  for (int i = 0; i < 9; ++i) transform.normal[i] = static_cast<float>(cofactor[i] * scale);
  // One pixel of margin for samples on the edge itself, so that the rounding of X and W drops none of them.
  transform.left = static_cast<float>(std::max(visible.min_x - 1, 0));
  transform.top = static_cast<float>(std::max(visible.min_y - 1, 0));
  transform.right = static_cast<float>(visible.max_x + 1);
  transform.bottom = static_cast<float>(visible.max_y + 1);
  return transform;
}

void allocate_rows(const core::Allocator& allocator, size_t rows, uint32_t varying_count, Vertices* out) {
  out->screen = core::Array<ScreenVertex>(allocator, rows);
  out->raster = core::Array<float>(allocator, core::checked_mul(rows, 4));
  out->world = core::Array<float>(allocator, core::checked_mul(rows, 4));
  out->normal = core::Array<float>(allocator, core::checked_mul(rows, 4));
  out->varying = core::Array<float>(allocator, core::checked_mul(rows, varying_count));
  out->varying_count = varying_count;
}

void allocate(const core::Allocator& allocator, const Mesh& mesh, uint32_t varying_count, Vertices* out) {
  allocate_rows(allocator, data::padded(mesh.vertex_count), varying_count, out);
  out->indices = mesh.indices.data();
}

void transform_vertices(const core::SimdTarget& simd, const Mesh& mesh, const Transform& transform,
                        const VertexRange& range, Vertices* out) {
  SHD_DISPATCH(TransformVertices, simd)(mesh, transform, range, *out);
}

}  // namespace shd::geometry
#endif  // HWY_ONCE
