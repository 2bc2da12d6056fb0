// SPDX-License-Identifier: MIT
#include "geometry/vertex.h"

#include <algorithm>

#include "data/data.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/vertex.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::geometry::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::Normalize;
using simd::HWY_NAMESPACE::Vec3V;

/// Row `row` of a column-major 4x4 matrix times (p, 1).
template <class D, class V>
HWY_INLINE V TransformRow(D d, const float* m, int row, const Vec3V<V>& p) {
  const V xy = hn::Add(hn::Mul(hn::Set(d, m[row]), p.x), hn::Mul(hn::Set(d, m[4 + row]), p.y));
  return hn::Add(hn::Add(xy, hn::Mul(hn::Set(d, m[8 + row]), p.z)), hn::Set(d, m[12 + row]));
}

/// Row `row` of a column-major 3x3 matrix times n.
template <class D, class V>
HWY_INLINE V TransformNormalRow(D d, const float* m, int row, const Vec3V<V>& n) {
  const V xy = hn::Add(hn::Mul(hn::Set(d, m[row]), n.x), hn::Mul(hn::Set(d, m[3 + row]), n.y));
  return hn::Add(xy, hn::Mul(hn::Set(d, m[6 + row]), n.z));
}

template <class DI, class M>
HWY_INLINE hn::Vec<DI> Bit(DI di, M mask, uint32_t bit) {
  const hn::RebindToFloat<DI> d;
  return hn::BitCast(di, hn::IfThenElseZero(mask, hn::BitCast(d, hn::Set(di, static_cast<int32_t>(bit)))));
}

/// Outcodes of (X, Y, Z, W); `finite` says which lanes are.
template <class D, class V>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> Outcodes(D d, const Transform& transform, V x, V y, V z, V w,
                                                   hn::Mask<D> finite) {
  const hn::RebindToSigned<D> di;
  const V zero = hn::Zero(d);
  const V guard = hn::Mul(w, hn::Set(d, kGuardBand));
  auto code = Bit(di, hn::Lt(x, hn::Mul(w, hn::Set(d, transform.left))), kOutLeft);
  code = hn::Or(code, Bit(di, hn::Gt(x, hn::Mul(w, hn::Set(d, transform.right))), kOutRight));
  code = hn::Or(code, Bit(di, hn::Lt(y, hn::Mul(w, hn::Set(d, transform.top))), kOutTop));
  code = hn::Or(code, Bit(di, hn::Gt(y, hn::Mul(w, hn::Set(d, transform.bottom))), kOutBottom));
  code = hn::Or(code, Bit(di, hn::Lt(z, zero), kOutNear));
  code = hn::Or(code, Bit(di, hn::Gt(z, w), kOutFar));
  code = hn::Or(code, Bit(di, hn::Lt(w, hn::Set(d, kMinW)), kOutBehind));
  code = hn::Or(code, Bit(di, hn::Or(hn::Gt(hn::Abs(x), guard), hn::Gt(hn::Abs(y), guard)), kOutGuard));
  return hn::Or(code, Bit(di, hn::Not(finite), kOutNonfinite));
}

/// Raster coordinate X / W in fixed point, rounded to nearest; 0 in lanes that are not `usable`.
template <class D, class V>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> Snap(D d, V numerator, V w, hn::Mask<D> usable) {
  const V pixels = hn::IfThenElseZero(usable, hn::Div(numerator, w));
  return hn::NearestInt(hn::Mul(pixels, hn::Set(d, static_cast<float>(kSubpixels))));
}

void TransformVertices(const Mesh& mesh, const Transform& transform, size_t begin, size_t end, Vertices& out) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  using V = hn::Vec<decltype(d)>;
  for (size_t i = begin; i < end; i += hn::Lanes(d)) {
    const Vec3V<V> p = {hn::Load(d, &mesh.px[i]), hn::Load(d, &mesh.py[i]), hn::Load(d, &mesh.pz[i])};
    const Vec3V<V> n = {hn::Load(d, &mesh.nx[i]), hn::Load(d, &mesh.ny[i]), hn::Load(d, &mesh.nz[i])};
    const V x = TransformRow(d, transform.raster, 0, p), y = TransformRow(d, transform.raster, 1, p);
    const V z = TransformRow(d, transform.raster, 2, p), w = TransformRow(d, transform.raster, 3, p);
    const Vec3V<V> world = {TransformRow(d, transform.world, 0, p), TransformRow(d, transform.world, 1, p),
                            TransformRow(d, transform.world, 2, p)};
    const Vec3V<V> normal = Normalize(
        d, Vec3V<V>{TransformNormalRow(d, transform.normal, 0, n), TransformNormalRow(d, transform.normal, 1, n),
                    TransformNormalRow(d, transform.normal, 2, n)});

    // A sum is finite only if its terms are; eighths keep finite terms from overflowing together.
    const V eighth = hn::Set(d, 0.125f);
    const V clip_sum = hn::Add(hn::Add(hn::Mul(hn::Abs(x), eighth), hn::Mul(hn::Abs(y), eighth)),
                               hn::Add(hn::Mul(hn::Abs(z), eighth), hn::Mul(hn::Abs(w), eighth)));
    const V world_sum = hn::Add(hn::Add(hn::Mul(hn::Abs(world.x), eighth), hn::Mul(hn::Abs(world.y), eighth)),
                                hn::Mul(hn::Abs(world.z), eighth));
    const auto finite =
        hn::Lt(hn::Add(hn::Mul(clip_sum, eighth), hn::Mul(world_sum, eighth)), hn::Set(d, __builtin_inff()));
    const auto code = Outcodes(d, transform, x, y, z, w, finite);
    const auto usable = hn::RebindMask(
        d, hn::Eq(hn::And(code, hn::Set(di, static_cast<int32_t>(kMustClip | kOutNonfinite))), hn::Zero(di)));

    hn::StoreInterleaved4(x, y, z, w, d, &out.raster[4 * i]);
    hn::StoreInterleaved4(world.x, world.y, world.z, hn::Load(d, &mesh.u[i]), d, &out.world[4 * i]);
    hn::StoreInterleaved4(normal.x, normal.y, normal.z, hn::Load(d, &mesh.v[i]), d, &out.normal[4 * i]);
    const V depth = hn::IfThenElseZero(usable, hn::Div(z, w));
    hn::StoreInterleaved4(Snap(d, x, w, usable), Snap(d, y, w, usable), hn::BitCast(di, depth), code, di,
                          &out.screen[i].x);
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
  const auto multiply = [](const double* a, const double* b, double* product) {
    for (int c = 0; c < 4; ++c) {
      for (int r = 0; r < 4; ++r) {
        double sum = 0.0;
        for (int k = 0; k < 4; ++k) sum += a[4 * k + r] * b[4 * c + k];
        product[4 * c + r] = sum;
      }
    }
  };
  double world[16], to_view[16], to_clip[16], object_to_view[16], clip[16];
  for (int i = 0; i < 16; ++i) {
    world[i] = static_cast<double>(object_to_world[i]);
    to_view[i] = static_cast<double>(view.world_to_view[i]);
    to_clip[i] = static_cast<double>(view.view_to_clip[i]);
  }
  multiply(to_view, world, object_to_view);
  multiply(to_clip, object_to_view, clip);

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
  // A pixel of margin where samples lie on the edge itself, so that the rounding of X and W drops none of them.
  transform.left = static_cast<float>(std::max(visible.min_x - 1, 0));
  transform.top = static_cast<float>(std::max(visible.min_y - 1, 0));
  transform.right = static_cast<float>(visible.max_x + 1);
  transform.bottom = static_cast<float>(visible.max_y + 1);
  return transform;
}

void allocate(const core::Allocator& allocator, const Mesh& mesh, Vertices* out) {
  const size_t rows = data::padded(mesh.vertex_count);
  out->screen = core::Array<ScreenVertex>(allocator, rows);
  out->raster = core::Array<float>(allocator, core::checked_mul(rows, 4));
  out->world = core::Array<float>(allocator, core::checked_mul(rows, 4));
  out->normal = core::Array<float>(allocator, core::checked_mul(rows, 4));
}

void transform_vertices(const core::SimdTarget& simd, const Mesh& mesh, const Transform& transform, size_t begin,
                        size_t end, Vertices* out) {
  SHD_DISPATCH(TransformVertices, simd)(mesh, transform, begin, end, *out);
}

}  // namespace shd::geometry
#endif  // HWY_ONCE
