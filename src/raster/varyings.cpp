// SPDX-License-Identifier: MIT
#include "raster/varyings.h"

#include "data/data.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/varyings.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/attribute-inl.h"
#include "raster/spans-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::raster::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Rows of the vertices of a triangle.
struct Triangle {
  size_t vertex[3];

  /// Component c of vertex k, of rows of `stride`.
  template <class D>
  HWY_INLINE hn::Vec<D> Get(D d, const float* rows, size_t stride, int k, size_t c) const {
    return hn::Set(d, rows[stride * vertex[k] + c]);
  }
};

template <class V>
struct Weights {
  V b1, b2;  // weights of vertices 1 and 2
};

/// Screen-space barycentrics of raster position (px, py); `perspective` where they do not exist, and where the vertices
/// have one w, so that both are equal.
template <class D, class V = hn::Vec<D>>
HWY_INLINE Weights<V> ScreenWeights(D d, const float* raster, const Triangle& triangle, V px, V py,
                                    const Weights<V>& perspective) {
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  auto usable = hn::Eq(zero, zero);
  V x[3], y[3], e[3];
  const V w0 = triangle.Get(d, raster, 4, 0, 3);
  auto one_w = usable;
  for (int k = 0; k < 3; ++k) {
    const V rx = triangle.Get(d, raster, 4, k, 0), ry = triangle.Get(d, raster, 4, k, 1);
    const V w = triangle.Get(d, raster, 4, k, 3), reach = w * hn::Set(d, 0x1p60f);
    one_w = hn::And(one_w, hn::Eq(w, w0));
    usable = hn::And(usable, hn::Ge(w, hn::Set(d, geometry::kMinW)));
    usable = hn::And(usable, hn::And(hn::Le(hn::Abs(rx), reach), hn::Le(hn::Abs(ry), reach)));
    // Subtracting the pixel before the division keeps the remainder small.
    x[k] = (rx - px * w) / w;
    y[k] = (ry - py * w) / w;
  }
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    e[k] = x[i] * y[j] - x[j] * y[i];
  }
  const V sum = e[0] + e[1] + e[2];
  const V size = hn::Abs(e[0]) + hn::Abs(e[1]) + hn::Abs(e[2]);
  usable = hn::And(usable, hn::Lt(size, hn::Inf(d)));
  usable = hn::AndNot(one_w, hn::And(usable, hn::Ge(hn::Abs(sum), hn::Set(d, 0x1p-126f))));
  const V inverse = one / hn::IfThenElse(usable, sum, one);
  const V raw1 = hn::IfThenElse(usable, e[1] * inverse, perspective.b1);
  const V raw2 = hn::IfThenElse(usable, e[2] * inverse, perspective.b2);
  const V b1 = hn::Min(hn::Max(raw1, zero), one);
  return {b1, hn::Min(hn::Max(raw2, zero), one - b1)};
}

/// Interpolates rows begin..end - 1, which belong to one triangle. The last vector may write past them.
void InterpolateTriangle(const geometry::Vertices& vertices, const Triangle& triangle, const shd_interpolation* modes,
                         size_t begin, size_t end, const Fragments& f, float* const* out) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  const size_t count = vertices.varying_count;
  const float* rows = vertices.varying.data();
  bool any_affine = false;
  for (size_t c = 0; c < count; ++c) any_affine |= modes[c] == SHD_INTERPOLATION_AFFINE;
  for (size_t at = begin; at < end; at += hn::Lanes(d)) {
    const Weights<V> perspective = {hn::LoadU(d, f.bary[1] + at), hn::LoadU(d, f.bary[2] + at)};
    Weights<V> affine = perspective;
    if (any_affine) {
      affine = ScreenWeights(d, vertices.raster.data(), triangle, hn::LoadU(d, f.x + at), hn::LoadU(d, f.y + at),
                             perspective);
    }
    for (size_t c = 0; c < count; ++c) {
      CornerValues<V> value;
      for (int k = 0; k < 3; ++k) value.a[k] = triangle.Get(d, rows, count, k, c);
      const Weights<V>& b = modes[c] == SHD_INTERPOLATION_AFFINE ? affine : perspective;
      const bool flat = modes[c] == SHD_INTERPOLATION_FLAT;
      hn::StoreU(flat ? value.a[0] : Blend(d, value, b.b1, b.b2), d, out[c] + at);
    }
  }
}

void InterpolateVaryings(const geometry::Vertices& vertices, const shd_interpolation* modes, const Fragments& f,
                         float* const* out) {
  const hn::ScalableTag<float> d;
  const size_t count = (f.count + hn::Lanes(d) - 1) / hn::Lanes(d) * hn::Lanes(d);
  for (size_t begin = 0, end; begin < count; begin = end) {
    end = EndOfTriangle(f.triangle, begin, count);
    Triangle triangle;
    for (size_t k = 0; k < 3; ++k) triangle.vertex[k] = geometry::row_of(vertices, f.triangle[begin], k);
    InterpolateTriangle(vertices, triangle, modes, begin, end, f, out);
  }
}

}  // namespace shd::raster::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::raster {

HWY_EXPORT(InterpolateVaryings);

void allocate(const core::Allocator& allocator, uint32_t count, Varyings* out) {
  out->block = core::Array<float>(allocator, count * kColumn);
  out->block.fill_zero();
  for (uint32_t c = 0; c < count; ++c) out->column[c] = out->block.data() + c * kColumn;
}

void interpolate_varyings(const core::SimdTarget& simd, const geometry::Vertices& vertices,
                          const shd_interpolation* modes, const Fragments& fragments, Varyings* out) {
  SHD_DISPATCH(InterpolateVaryings, simd)(vertices, modes, fragments, out->column);
}

}  // namespace shd::raster
#endif  // HWY_ONCE
