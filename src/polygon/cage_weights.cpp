// SPDX-License-Identifier: MIT
#include "polygon/cage_weights.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "polygon/cage_weights.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/double-inl.h"
#include "simd/kernel_part.h"

HWY_BEFORE_NAMESPACE();
namespace shd::polygon::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

using D = hn::CappedTag<double, kBlock>;
using V = hn::Vec<D>;

/// Points closer to an edge or a triangle than this part of the distance to its farthest vertex lie on it.
constexpr double kOn = 0x1p-26;
/// Distances to planes of convex cages are at least this, so that weights are finite.
constexpr double kLeastHeight = 0x1p-60;

/// Columns of a vertex and of an edge in the working memory, each of one vector.
enum VertexColumn { kX, kY, kZ, kSquare, kInverse, kVertexColumns };
enum EdgeColumn { kNormalX, kNormalY, kNormalZ, kFactor, kEdgeColumns };

struct Vector3 {
  V x, y, z;
};
HWY_INLINE V DotOf(const Vector3& a, const Vector3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
HWY_INLINE Vector3 SetVector(D d, const double* from) {
  return {hn::Set(d, from[0]), hn::Set(d, from[1]), hn::Set(d, from[2])};
}
HWY_INLINE Vector3 LoadVector(D d, const double* from) {
  const size_t lanes = hn::Lanes(d);
  return {hn::Load(d, from), hn::Load(d, from + lanes), hn::Load(d, from + 2 * lanes)};
}

/// angle / sin(angle) / cos(angle / 2) of half an angle whose cosine is h, 0 < h <= 1, is angle / sin(angle) of the
/// whole angle. The first quotient is a polynomial of h - 1/2 through its values at Chebyshev nodes: relative error
/// 4e-17 before rounding.
HWY_INLINE V AngleBySine(D d, V h) {
  constexpr double kCoefficients[] = {0.00012117305831116538,  -0.00018609092229782463, 0.00012708400889953493,
                                      -0.00019625532058336834, 0.00039306909718902606,  -0.00060800516043310229,
                                      0.00091421022126976236,  -0.0014207449636114548,  0.0022193303562364495,
                                      -0.0034690259433040753,  0.005441843341071648,    -0.0085755268197732986,
                                      0.013586867141375918,    -0.021671674846850369,   0.034865535274291133,
                                      -0.056733710715744772,   0.093786063598660549,    -0.1586971753802888,
                                      0.27893276820819266,     -0.52720028256256834,    1.2091995761561452};
  const V y = h - hn::Set(d, 0.5);
  V p = hn::Set(d, kCoefficients[0]);
  for (size_t i = 1; i < sizeof kCoefficients / sizeof kCoefficients[0]; ++i) p = p * y + hn::Set(d, kCoefficients[i]);
  return p / h;
}

/// Working memory, and the result so far.
struct MeanValue {
  const Cage& cage;
  double* vertex;   // [vertex][kVertexColumns][lanes]
  double* edge;     // [edge][kEdgeColumns][lanes]
  double* weights;  // [vertex][kBlock], from the first lane on
  V triangle;       // that the point lies on, or -1
};

/// Vectors from the points to the vertices, and their lengths.
HWY_INLINE void FindVertices(D d, const MeanValue& m, const Vector3& point) {
  const size_t lanes = hn::Lanes(d);
  for (uint32_t i = 0; i < m.cage.vertex_count; ++i) {
    const Vector3 at = SetVector(d, m.cage.position.data() + 3 * size_t{i});
    const Vector3 s = {at.x - point.x, at.y - point.y, at.z - point.z};
    const V square = DotOf(s, s);
    double* to = m.vertex + size_t{i} * kVertexColumns * lanes;
    hn::Store(s.x, d, to + kX * lanes);
    hn::Store(s.y, d, to + kY * lanes);
    hn::Store(s.z, d, to + kZ * lanes);
    hn::Store(square, d, to + kSquare * lanes);
    hn::Store(hn::Set(d, 1.0) / hn::Sqrt(hn::Max(square, hn::Set(d, 0x1p-200))), d, to + kInverse * lanes);
    hn::Store(hn::Zero(d), d, m.weights + size_t{i} * kBlock);
  }
}

/// Normals s_a x s_b of the planes of the edges and the points, and angle(s_a, s_b) / |s_a x s_b|. Their product is
/// twice the part of an edge in the integral over a spherical triangle.
HWY_INLINE void FindEdges(D d, MeanValue* m) {
  const size_t lanes = hn::Lanes(d);
  const V one = hn::Set(d, 1.0), half = hn::Set(d, 0.5), on = hn::Set(d, kOn * kOn), zero = hn::Zero(d);
  for (uint32_t e = 0; e < m->cage.edge_count; ++e) {
    const double* a = m->vertex + size_t{m->cage.edge[e].from} * kVertexColumns * lanes;
    const double* b = m->vertex + size_t{m->cage.edge[e].to} * kVertexColumns * lanes;
    const Vector3 s = LoadVector(d, a), t = LoadVector(d, b);
    const Vector3 along = SetVector(d, m->cage.along.data() + 3 * size_t{e});
    const Vector3 normal = {s.y * along.z - s.z * along.y, s.z * along.x - s.x * along.z,
                            s.x * along.y - s.y * along.x};
    const V product = DotOf(s, t), crossed = DotOf(normal, normal);
    const V a_square = hn::Load(d, a + kSquare * lanes), b_square = hn::Load(d, b + kSquare * lanes);
    const V inverse = hn::Load(d, a + kInverse * lanes) * hn::Load(d, b + kInverse * lanes);
    const V cosine = product * inverse;
    // 1 + cosine without cancellation at obtuse angles.
    const V sum = hn::IfThenElse(hn::Lt(cosine, zero), crossed * (inverse * inverse) / (one - cosine), one + cosine);
    const V h = hn::Sqrt(hn::Max(sum * half, hn::Set(d, 0x1p-200)));
    double* to = m->edge + size_t{e} * kEdgeColumns * lanes;
    hn::Store(normal.x, d, to + kNormalX * lanes);
    hn::Store(normal.y, d, to + kNormalY * lanes);
    hn::Store(normal.z, d, to + kNormalZ * lanes);
    hn::Store(AngleBySine(d, h) * inverse, d, to + kFactor * lanes);

    const V far = hn::Max(a_square, b_square), near = hn::Min(a_square, b_square);
    const V squared_length = DotOf(along, along);
    const auto beside = hn::And(hn::Le(product, zero), hn::Le(crossed, on * squared_length * far));
    const auto hit = hn::Or(beside, hn::Le(near, on * far));
    if (HWY_UNLIKELY(!hn::AllFalse(d, hit))) {
      m->triangle = hn::IfThenElse(hit, hn::Set(d, static_cast<double>(m->cage.edge[e].triangle)), m->triangle);
    }
  }
}

/// Twice the integral of the normal over the part of the unit sphere that a triangle covers.
HWY_INLINE Vector3 Integral(D d, const CageTriangle& triangle, const Vector3 (&normal)[3],
                            const double* const (&edge)[3]) {
  const size_t lanes = hn::Lanes(d);
  const V f = hn::Load(d, edge[0] + kFactor * lanes) * hn::Set(d, triangle.sign[0]);
  const V g = hn::Load(d, edge[1] + kFactor * lanes) * hn::Set(d, triangle.sign[1]);
  const V h = hn::Load(d, edge[2] + kFactor * lanes) * hn::Set(d, triangle.sign[2]);
  return {f * normal[0].x + g * normal[1].x + h * normal[2].x, f * normal[0].y + g * normal[1].y + h * normal[2].y,
          f * normal[0].z + g * normal[1].z + h * normal[2].z};
}

/// Adds the weights of the vertices of a triangle.
HWY_INLINE void AddTriangle(D d, MeanValue* m, uint32_t t) {
  const size_t lanes = hn::Lanes(d);
  const CageTriangle& triangle = m->cage.triangle[t];
  const double *edge[3], *vertex[3];
  Vector3 normal[3];
  for (size_t i = 0; i < 3; ++i) {
    edge[i] = m->edge + size_t{triangle.edge[i]} * kEdgeColumns * lanes;
    vertex[i] = m->vertex + size_t{triangle.vertex[i]} * kVertexColumns * lanes;
    normal[i] = LoadVector(d, edge[i]);
  }
  const Vector3 integral = Integral(d, triangle, normal, edge);
  const double* plane = m->cage.normal.data() + 4 * size_t{t};
  const Vector3 face = SetVector(d, plane);
  const V height = DotOf(face, LoadVector(d, vertex[0]));
  V scale = hn::Set(d, plane[3]) / height;

  // Beside the plane, rounding would decide. A point of the triangle is noted; otherwise the weights are nearly 0.
  const V square = height * height;
  const V far = hn::Max(hn::Max(hn::Load(d, vertex[0] + kSquare * lanes), hn::Load(d, vertex[1] + kSquare * lanes)),
                        hn::Load(d, vertex[2] + kSquare * lanes));
  const auto beside = hn::Le(square, hn::Set(d, kOn * kOn) * far);
  if (HWY_UNLIKELY(!hn::AllFalse(d, beside))) {
    auto hit = beside;
    for (size_t i = 0; i < 3; ++i) {
      hit = hn::And(hit, hn::Gt(DotOf(face, normal[i]) * hn::Set(d, triangle.sign[i]), hn::Zero(d)));
    }
    m->triangle = hn::IfThenElse(hit, hn::Set(d, static_cast<double>(t)), m->triangle);
    scale = hn::IfThenElse(beside, hn::Zero(d), scale);
  }
  const Vector3 scaled = {integral.x * scale, integral.y * scale, integral.z * scale};
  for (size_t i = 0; i < 3; ++i) {
    double* to = m->weights + size_t{triangle.vertex[i]} * kBlock;
    hn::Store(hn::Load(d, to) + DotOf(normal[i], scaled) * hn::Set(d, triangle.sign[i]), d, to);
  }
}

/// Divides the weights by their sum. Returns the sum.
HWY_INLINE V Normalise(D d, uint32_t count, double* weights) {
  V sum = hn::Zero(d);
  for (uint32_t i = 0; i < count; ++i) sum = sum + hn::Load(d, weights + size_t{i} * kBlock);
  const V inverse = hn::Set(d, 1.0) / sum;
  for (uint32_t i = 0; i < count; ++i) {
    double* to = weights + size_t{i} * kBlock;
    hn::Store(hn::Load(d, to) * inverse, d, to);
  }
  return sum;
}

}  // namespace

void MeanValueBlock(const Cage& cage, double* scratch, CagePoints* points, double* weights) {
  const D d;
  const size_t lanes = hn::Lanes(d);
  for (size_t i = 0; i < kBlock; i += lanes) {
    MeanValue m = {cage, scratch, scratch + size_t{cage.vertex_count} * kVertexColumns * lanes, weights + i,
                   hn::Set(d, -1.0)};
    FindVertices(d, m, {hn::Load(d, points->x + i), hn::Load(d, points->y + i), hn::Load(d, points->z + i)});
    FindEdges(d, &m);
    for (uint32_t t = 0; t < cage.triangle_count; ++t) AddTriangle(d, &m, t);
    hn::Store(Normalise(d, cage.vertex_count, m.weights), d, points->depth + i);
    hn::Store(m.triangle, d, points->triangle + i);
  }
}

void WachspressBlock(const Cage& cage, double* scratch, CagePoints* points, double* weights) {
  const D d;
  const size_t lanes = hn::Lanes(d);
  for (size_t i = 0; i < kBlock; i += lanes) {
    const Vector3 point = {hn::Load(d, points->x + i), hn::Load(d, points->y + i), hn::Load(d, points->z + i)};
    V least = hn::Set(d, 8.0);
    for (uint32_t p = 0; p < cage.plane_count; ++p) {
      const double* plane = cage.plane.data() + 4 * size_t{p};
      const V height = hn::Set(d, plane[3]) - DotOf(SetVector(d, plane), point);
      least = hn::Min(least, height);
      hn::Store(hn::Set(d, 1.0) / hn::Max(height, hn::Set(d, kLeastHeight)), d, scratch + p * lanes);
    }
    hn::Store(least, d, points->depth + i);
    for (uint32_t v = 0; v < cage.vertex_count; ++v) {
      const uint32_t first = cage.fan_start[v], end = cage.fan_start[v + 1];
      V sum = hn::Zero(d);
      for (uint32_t j = first + 1; j + 1 < end; ++j) {
        const V own = hn::Load(d, scratch + cage.fan_plane[j] * lanes);
        const V next = hn::Load(d, scratch + cage.fan_plane[j + 1] * lanes);
        sum = sum + hn::Set(d, cage.fan_volume[j]) * (own * next);
      }
      hn::Store(sum * hn::Load(d, scratch + cage.fan_plane[first] * lanes), d, weights + size_t{v} * kBlock + i);
    }
    Normalise(d, cage.vertex_count, weights + i);
  }
}

void BlendBlock(const Cage& cage, const double* weights, const double* values, size_t value_count, double* out) {
  const D d;
  for (size_t i = 0; i < kBlock; i += hn::Lanes(d)) {
    for (size_t k = 0; k < value_count; ++k) {
      const double* value = values + k * cage.vertex_count;
      V sum = hn::Zero(d);
      for (uint32_t v = 0; v < cage.vertex_count; ++v) {
        sum = sum + hn::Load(d, weights + size_t{v} * kBlock + i) * hn::Set(d, value[v]);
      }
      hn::Store(sum, d, out + k * kBlock + i);
    }
  }
}

}  // namespace shd::polygon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::polygon {

HWY_EXPORT(MeanValueBlock);
HWY_EXPORT(WachspressBlock);
HWY_EXPORT(BlendBlock);

size_t scratch_size(const Cage& cage, shd_barycentric kind) {
  if (kind == SHD_BARYCENTRIC_WACHSPRESS) return size_t{cage.plane_count} * kBlock;
  constexpr size_t kVertexDoubles = 5 * kBlock, kEdgeDoubles = 4 * kBlock;
  return cage.vertex_count * kVertexDoubles + cage.edge_count * kEdgeDoubles;
}

void mean_value_weights(const Cage& cage, const core::SimdTarget& simd, double* scratch, CagePoints* points,
                        double* weights) {
  SHD_DISPATCH(MeanValueBlock, simd)(cage, scratch, points, weights);
}

void wachspress_weights(const Cage& cage, const core::SimdTarget& simd, double* scratch, CagePoints* points,
                        double* weights) {
  SHD_DISPATCH(WachspressBlock, simd)(cage, scratch, points, weights);
}

void blend_values(const Cage& cage, const core::SimdTarget& simd, const double* weights, const double* values,
                  size_t value_count, double* out) {
  SHD_DISPATCH(BlendBlock, simd)(cage, weights, values, value_count, out);
}

}  // namespace shd::polygon
#endif
