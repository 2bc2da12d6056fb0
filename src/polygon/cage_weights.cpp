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

/// Points closer to an edge or a triangle than this part of the distance to its farthest vertex lie on it.
constexpr double kOn = 0x1p-26;
/// Distances to planes of convex cages are at least this, so that weights are finite.
constexpr double kLeastHeight = 0x1p-60;
/// Floats are not precise enough for points closer to the plane of a triangle, or in whose view an edge has a cosine
/// below this, or whose weights reproduce the point with a larger error.
constexpr float kDoubtfulHeight = 0x1p-9f, kDoubtfulCosine = -0.97f;
constexpr double kDoubtfulError = 0x1p-22;

/// Columns of a vertex and of an edge in the working memory, each of one vector.
enum VertexColumn { kX, kY, kZ, kSquare, kInverse, kVertexColumns };
enum EdgeColumn { kNormalX, kNormalY, kNormalZ, kFactor, kEdgeColumns };

template <class V>
struct Vector3 {
  V x, y, z;
};
template <class V>
HWY_INLINE V DotOf(const Vector3<V>& a, const Vector3<V>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class D, class V = hn::Vec<D>>
HWY_INLINE Vector3<V> SetVector(D d, const hn::TFromD<D>* from) {
  return {hn::Set(d, from[0]), hn::Set(d, from[1]), hn::Set(d, from[2])};
}
template <class D, class V = hn::Vec<D>>
HWY_INLINE Vector3<V> LoadVector(D d, const hn::TFromD<D>* from) {
  const size_t lanes = hn::Lanes(d);
  return {hn::Load(d, from), hn::Load(d, from + lanes), hn::Load(d, from + 2 * lanes)};
}

/// The sum of c[i] y^i for i = 0..2, in the order that the compiler may interleave with other terms.
template <class D, class V>
HWY_INLINE V Quadratic(D d, V y, V square, hn::TFromD<D> a, hn::TFromD<D> b, hn::TFromD<D> c) {
  return (hn::Set(d, a) + hn::Set(d, b) * y) + hn::Set(d, c) * square;
}

/// angle / sin(angle) of an angle in 0..pi / 2 by its cosine: a polynomial of cosine - 1/2 through its values at
/// Chebyshev nodes. Relative error before rounding: 4e-17 in doubles, 1.3e-8 in floats.
template <class D, class V>
HWY_INLINE V AngleBySine(D d, V cosine) {
  const V y = cosine - hn::Set(d, hn::TFromD<D>(0.5)), y2 = y * y, y3 = y2 * y;
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(float)) {
    const V p = hn::Set(d, 0.017641020f) + hn::Set(d, -0.011162824f) * y;
    const V high = Quadratic(d, y, y2, -0.056788334f, 0.033929990f, -0.021074422f) + p * y3;
    const V middle = Quadratic(d, y, y2, 0.27893007f, -0.15869545f, 0.093871614f) + high * y3;
    return (hn::Set(d, 1.2091996f) + hn::Set(d, -0.52720029f) * y) + middle * y2;
  } else {
    V p = Quadratic(d, y, y2, -0.00019625532058336834, 0.00012708400889953493, -0.00018609092229782463) +
          hn::Set(d, 0.00012117305831116538) * y3;
    p = Quadratic(d, y, y2, 0.00091421022126976236, -0.00060800516043310229, 0.00039306909718902606) + p * y3;
    p = Quadratic(d, y, y2, -0.0034690259433040753, 0.0022193303562364495, -0.0014207449636114548) + p * y3;
    p = Quadratic(d, y, y2, 0.013586867141375918, -0.0085755268197732986, 0.005441843341071648) + p * y3;
    p = Quadratic(d, y, y2, -0.056733710715744772, 0.034865535274291133, -0.021671674846850369) + p * y3;
    p = Quadratic(d, y, y2, 0.27893276820819266, -0.1586971753802888, 0.093786063598660549) + p * y3;
    return (hn::Set(d, 1.2091995761561452) + hn::Set(d, -0.52720028256256834) * y) + p * y2;
  }
}

/// Working memory, and the result so far, of one vector of points.
template <class D>
struct MeanValue {
  using T = hn::TFromD<D>;
  using V = hn::Vec<D>;

  const Cage& cage;
  const CageTables<T>& tables;
  T* vertex;   // [vertex][kVertexColumns][lanes]
  T* edge;     // [edge][kEdgeColumns][lanes]
  T* weights;  // [vertex][kBlock], from the first lane on
  V triangle;  // doubles: that the point lies on, or -1
  V reach;     // square of the distance to the farthest vertex
  V nearest;   // square of the distance to the nearest vertex
  V height;    // floats: least distance to the plane of a triangle; 0 if the angle of an edge is doubtful
};

/// Vectors from the points to the vertices, and their lengths.
template <class D, class V>
HWY_INLINE void FindVertices(D d, MeanValue<D>* m, const Vector3<V>& point) {
  using T = hn::TFromD<D>;
  const size_t lanes = hn::Lanes(d);
  for (uint32_t i = 0; i < m->cage.vertex_count; ++i) {
    const Vector3<V> at = SetVector(d, m->tables.position.data() + 3 * size_t{i});
    const Vector3<V> s = {at.x - point.x, at.y - point.y, at.z - point.z};
    const V square = DotOf(s, s);
    T* to = m->vertex + size_t{i} * kVertexColumns * lanes;
    hn::Store(s.x, d, to + kX * lanes);
    hn::Store(s.y, d, to + kY * lanes);
    hn::Store(s.z, d, to + kZ * lanes);
    if constexpr (sizeof(T) == sizeof(double)) hn::Store(square, d, to + kSquare * lanes);
    const V length = hn::Sqrt(hn::Max(square, hn::Set(d, T(0x1p-100))));
    hn::Store(hn::Set(d, T(1)) / length, d, to + kInverse * lanes);
    hn::Store(hn::Zero(d), d, m->weights + size_t{i} * kBlock);
    m->reach = hn::Max(m->reach, square);
    m->nearest = hn::Min(m->nearest, square);
  }
}

/// angle / sin(angle) of obtuse angles, from the angle of half the size.
template <class D, class V>
HWY_INLINE V ObtuseBySine(D d, V cosine, V crossed, V inverse) {
  using T = hn::TFromD<D>;
  const V one = hn::Set(d, T(1));
  // 1 + cosine without cancellation.
  const V sum = crossed * (inverse * inverse) / (one - cosine);
  const V h = hn::Sqrt(hn::Min(hn::Max(sum * hn::Set(d, T(0.5)), hn::Set(d, T(0x1p-100))), one));
  return AngleBySine(d, h) / h;
}

/// Notes the points that lie on an edge.
template <class D, class V>
HWY_INLINE void FindPointsOnEdge(D d, MeanValue<D>* m, uint32_t e, V product, V crossed) {
  const size_t lanes = hn::Lanes(d);
  const CageEdge& edge = m->cage.edge[e];
  const V on = hn::Set(d, kOn * kOn);
  const V a = hn::Load(d, m->vertex + (size_t{edge.from} * kVertexColumns + kSquare) * lanes);
  const V b = hn::Load(d, m->vertex + (size_t{edge.to} * kVertexColumns + kSquare) * lanes);
  const Vector3<V> along = SetVector(d, m->tables.along.data() + 3 * size_t{e});
  const V far = hn::Max(a, b), near = hn::Min(a, b);
  const auto beside = hn::And(hn::Le(product, hn::Zero(d)), hn::Le(crossed, on * DotOf(along, along) * far));
  const auto hit = hn::Or(beside, hn::Le(near, on * far));
  m->triangle = hn::IfThenElse(hit, hn::Set(d, static_cast<double>(edge.triangle)), m->triangle);
}

/// Normal s_a x s_b of the plane of an edge and the points, and angle(s_a, s_b) / |s_a x s_b|. Their product is twice
/// the part of the edge in the integral over a spherical triangle.
template <class V>
struct EdgePart {
  Vector3<V> normal;
  V factor;
};

/// Computes the part of an edge in its first triangle, and stores the one in its second triangle.
/// @param is_near_vertex  points may lie on the edge near one of its ends, from where they see it at any angle
template <class D>
HWY_INLINE EdgePart<hn::Vec<D>> FindEdge(D d, MeanValue<D>* m, uint32_t e, bool is_near_vertex) {
  using T = hn::TFromD<D>;
  using V = hn::Vec<D>;
  const size_t lanes = hn::Lanes(d);
  const T* a = m->vertex + size_t{m->cage.edge[e].from} * kVertexColumns * lanes;
  const T* b = m->vertex + size_t{m->cage.edge[e].to} * kVertexColumns * lanes;
  const Vector3<V> s = LoadVector(d, a), t = LoadVector(d, b);
  const Vector3<V> along = SetVector(d, m->tables.along.data() + 3 * size_t{e});
  const Vector3<V> normal = {s.y * along.z - s.z * along.y, s.z * along.x - s.x * along.z,
                             s.x * along.y - s.y * along.x};
  const V product = DotOf(s, t);
  const V inverse = hn::Load(d, a + kInverse * lanes) * hn::Load(d, b + kInverse * lanes);
  const V cosine = product * inverse;
  V quotient = AngleBySine(d, cosine);
  const auto obtuse = hn::Lt(cosine, hn::Zero(d));
  if (HWY_UNLIKELY(is_near_vertex || !hn::AllFalse(d, obtuse))) {
    const V crossed = DotOf(normal, normal);
    quotient = hn::IfThenElse(obtuse, ObtuseBySine(d, cosine, crossed, inverse), quotient);
    if constexpr (sizeof(T) == sizeof(double)) {
      FindPointsOnEdge(d, m, e, product, crossed);
    } else {
      m->height = hn::IfThenZeroElse(hn::Lt(cosine, hn::Set(d, kDoubtfulCosine)), m->height);
    }
  }
  T* to = m->edge + size_t{e} * kEdgeColumns * lanes;
  const V factor = quotient * inverse;
  hn::Store(hn::Neg(normal.x), d, to + kNormalX * lanes);
  hn::Store(hn::Neg(normal.y), d, to + kNormalY * lanes);
  hn::Store(hn::Neg(normal.z), d, to + kNormalZ * lanes);
  hn::Store(factor, d, to + kFactor * lanes);
  return {normal, factor};
}

/// The part of an edge in a triangle.
template <bool kIsNew, class D>
HWY_INLINE EdgePart<hn::Vec<D>> EdgeOf(D d, MeanValue<D>* m, uint32_t e, bool is_near_vertex) {
  if constexpr (kIsNew) return FindEdge(d, m, e, is_near_vertex);
  const hn::TFromD<D>* from = m->edge + size_t{e} * kEdgeColumns * hn::Lanes(d);
  return {LoadVector(d, from), hn::Load(d, from + kFactor * hn::Lanes(d))};
}

/// Square of the distance to an edge.
template <class D, class V>
HWY_INLINE V SquareToEdge(D d, const MeanValue<D>& m, uint32_t e, const Vector3<V>& normal) {
  const size_t lanes = hn::Lanes(d);
  const hn::TFromD<D>* a = m.vertex + size_t{m.cage.edge[e].from} * kVertexColumns * lanes;
  const hn::TFromD<D>* b = m.vertex + size_t{m.cage.edge[e].to} * kVertexColumns * lanes;
  const Vector3<V> along = SetVector(d, m.tables.along.data() + 3 * size_t{e});
  const V product = DotOf(LoadVector(d, a), LoadVector(d, b));
  const V to_ends = hn::Min(hn::Load(d, a + kSquare * lanes), hn::Load(d, b + kSquare * lanes));
  return hn::IfThenElse(hn::Le(product, to_ends), DotOf(normal, normal) / DotOf(along, along), to_ends);
}

/// Much closer to the plane of a triangle than to its edges, rounding would decide. A point of the triangle is noted.
/// Weights of other points are nearly 0, and become 0. Returns the corrected scale of the weights.
template <class D, class V>
HWY_INLINE V CorrectBesidePlane(D d, MeanValue<D>* m, uint32_t t, const EdgePart<V> (&part)[3], V height, V scale) {
  const CageTriangle& triangle = m->cage.triangle[t];
  const Vector3<V> face = SetVector(d, m->tables.normal.data() + 4 * size_t{t});
  V nearest = m->reach;
  for (size_t i = 0; i < 3; ++i) nearest = hn::Min(nearest, SquareToEdge(d, *m, triangle.edge[i], part[i].normal));
  const auto beside = hn::Le(height * height, hn::Set(d, kOn * kOn) * nearest);
  auto hit = beside;
  for (size_t i = 0; i < 3; ++i) {
    hit = hn::And(hit, hn::Gt(DotOf(face, part[i].normal), hn::Zero(d)));
  }
  m->triangle = hn::IfThenElse(hit, hn::Set(d, static_cast<double>(t)), m->triangle);
  return hn::IfThenZeroElse(beside, scale);
}

/// Adds the weights of the vertices of a triangle whose first kNew edges are new.
template <size_t kNew, class D>
HWY_INLINE void AddTriangle(D d, MeanValue<D>* m, uint32_t t, bool is_near_vertex, hn::Vec<D> beside) {
  using T = hn::TFromD<D>;
  using V = hn::Vec<D>;
  const CageTriangle& triangle = m->cage.triangle[t];
  const EdgePart<V> part[3] = {EdgeOf<(kNew > 0)>(d, m, triangle.edge[0], is_near_vertex),
                               EdgeOf<(kNew > 1)>(d, m, triangle.edge[1], is_near_vertex),
                               EdgeOf<(kNew > 2)>(d, m, triangle.edge[2], is_near_vertex)};
  const Vector3<V>&a = part[0].normal, &b = part[1].normal, &c = part[2].normal;
  const V f = part[0].factor, g = part[1].factor, h = part[2].factor;
  // Twice the integral of the normal over the part of the unit sphere that the triangle covers.
  const Vector3<V> integral = {f * a.x + g * b.x + h * c.x, f * a.y + g * b.y + h * c.y, f * a.z + g * b.z + h * c.z};
  const T* plane = m->tables.normal.data() + 4 * size_t{t};
  const T* corner = m->vertex + size_t{triangle.vertex[0]} * kVertexColumns * hn::Lanes(d);
  const V height = DotOf(SetVector(d, plane), LoadVector(d, corner));
  V scale = hn::Set(d, plane[3]) / height;
  if constexpr (sizeof(T) == sizeof(double)) {
    if (HWY_UNLIKELY(!hn::AllFalse(d, hn::Le(height * height, beside)))) {
      scale = CorrectBesidePlane(d, m, t, part, height, scale);
    }
  } else {
    m->height = hn::Min(m->height, hn::Abs(height));
  }
  const Vector3<V> scaled = {integral.x * scale, integral.y * scale, integral.z * scale};
  const auto add = [&](size_t i) {
    T* to = m->weights + size_t{triangle.vertex[i]} * kBlock;
    hn::Store(hn::Load(d, to) + DotOf(part[i].normal, scaled), d, to);
  };
  add(0), add(1), add(2);
}

/// Computes weights before the division by their sum. Returns what else is known of the points.
template <class D>
HWY_INLINE MeanValue<D> AddTriangles(D d, const Cage& cage, const CageTables<hn::TFromD<D>>& tables,
                                     hn::TFromD<D>* scratch, const Vector3<hn::Vec<D>>& point, hn::TFromD<D>* weights) {
  using T = hn::TFromD<D>;
  const auto zero = hn::Zero(d), far = hn::Set(d, T(0x1p60));
  MeanValue<D> m = {cage,    tables,
                    scratch, scratch + size_t{cage.vertex_count} * kVertexColumns * hn::Lanes(d),
                    weights, hn::Set(d, T(-1)),
                    zero,    far,
                    far};
  FindVertices(d, &m, point);
  const auto beside = m.reach * hn::Set(d, T(kOn * kOn));
  const bool is_near_vertex = sizeof(T) == sizeof(double) && !hn::AllFalse(d, hn::Le(m.nearest, beside));
  for (uint32_t t = 0; t < cage.triangle_count; ++t) {
    switch (cage.triangle[t].new_edges) {
      case 0: AddTriangle<0>(d, &m, t, is_near_vertex, beside); break;
      case 1: AddTriangle<1>(d, &m, t, is_near_vertex, beside); break;
      case 2: AddTriangle<2>(d, &m, t, is_near_vertex, beside); break;
      default: AddTriangle<3>(d, &m, t, is_near_vertex, beside); break;
    }
  }
  return m;
}

using Doubles = hn::CappedTag<double, kVectorDoubles>;
using Floats = hn::CappedTag<float, kBlock>;

/// Stores the sum of the weights, and its inverse.
HWY_INLINE void StoreSum(Doubles d, uint32_t count, const double* weights, size_t lane, CagePoints* points) {
  auto sum = hn::Zero(d);
  for (uint32_t i = 0; i < count; ++i) sum = sum + hn::Load(d, weights + size_t{i} * kBlock + lane);
  hn::Store(sum, d, points->depth + lane);
  hn::Store(hn::Set(d, 1.0) / sum, d, points->inverse + lane);
}

}  // namespace

void MeanValueBlock(const Cage& cage, double* scratch, CagePoints* points, double* weights) {
  const Doubles d;
  for (size_t i = 0; i < points->count; i += hn::Lanes(d)) {
    const Vector3<hn::Vec<Doubles>> point = {hn::Load(d, points->x + i), hn::Load(d, points->y + i),
                                             hn::Load(d, points->z + i)};
    const auto m = AddTriangles(d, cage, cage.doubles, scratch, point, weights + i);
    StoreSum(d, cage.vertex_count, weights, i, points);
    hn::Store(m.triangle, d, points->triangle + i);
  }
}

void FastMeanValueBlock(const Cage& cage, double* scratch, CagePoints* points, double* weights) {
  const Floats d;
  const Doubles dd;
  const hn::Rebind<float, Doubles> half;
  float* const small = reinterpret_cast<float*>(scratch);
  float* const sums =
      small + (cage.vertex_count * size_t{kVertexColumns} + cage.edge_count * size_t{kEdgeColumns}) * kBlock;
  alignas(64) float at[3][kBlock], height[kBlock];
  for (size_t i = 0; i < kBlock; ++i) {
    at[0][i] = static_cast<float>(points->x[i]);
    at[1][i] = static_cast<float>(points->y[i]);
    at[2][i] = static_cast<float>(points->z[i]);
  }
  for (size_t i = 0; i < kBlock; i += hn::Lanes(d)) {
    const Vector3<hn::Vec<Floats>> point = {hn::Load(d, at[0] + i), hn::Load(d, at[1] + i), hn::Load(d, at[2] + i)};
    hn::Store(AddTriangles(d, cage, cage.floats, small, point, sums + i).height, d, height + i);
  }
  // The rest in doubles: the sum, and the error of the point that the weights reproduce.
  for (size_t i = 0; i < kBlock; i += hn::Lanes(dd)) {
    auto sum = hn::Zero(dd), at_x = sum, at_y = sum, at_z = sum;
    for (uint32_t v = 0; v < cage.vertex_count; ++v) {
      const double* position = cage.doubles.position.data() + 3 * size_t{v};
      const auto weight = hn::PromoteTo(dd, hn::Load(half, sums + size_t{v} * kBlock + i));
      hn::Store(weight, dd, weights + size_t{v} * kBlock + i);
      sum = sum + weight;
      at_x = at_x + weight * hn::Set(dd, position[0]);
      at_y = at_y + weight * hn::Set(dd, position[1]);
      at_z = at_z + weight * hn::Set(dd, position[2]);
    }
    const auto error = hn::Max(
        hn::Abs(at_x - sum * hn::Load(dd, points->x + i)),
        hn::Max(hn::Abs(at_y - sum * hn::Load(dd, points->y + i)), hn::Abs(at_z - sum * hn::Load(dd, points->z + i))));
    const auto tall = hn::Gt(hn::PromoteTo(dd, hn::Load(half, height + i)), hn::Set(dd, double{kDoubtfulHeight}));
    const auto good = hn::And(tall, hn::Le(error, sum * hn::Set(dd, kDoubtfulError)));
    hn::Store(hn::IfThenElse(good, sum, hn::Set(dd, -1.0)), dd, points->depth + i);
    hn::Store(hn::Set(dd, 1.0) / sum, dd, points->inverse + i);
  }
}

void WachspressBlock(const Cage& cage, double* scratch, CagePoints* points, double* weights) {
  const Doubles d;
  const size_t lanes = hn::Lanes(d);
  for (size_t i = 0; i < kBlock; i += lanes) {
    const Vector3<hn::Vec<Doubles>> point = {hn::Load(d, points->x + i), hn::Load(d, points->y + i),
                                             hn::Load(d, points->z + i)};
    auto least = hn::Set(d, 8.0);
    for (uint32_t p = 0; p < cage.plane_count; ++p) {
      const double* plane = cage.plane.data() + 4 * size_t{p};
      const auto height = hn::Set(d, plane[3]) - DotOf(SetVector(d, plane), point);
      least = hn::Min(least, height);
      hn::Store(hn::Set(d, 1.0) / hn::Max(height, hn::Set(d, kLeastHeight)), d, scratch + p * lanes);
    }
    for (uint32_t v = 0; v < cage.vertex_count; ++v) {
      const uint32_t first = cage.fan_start[v], end = cage.fan_start[v + 1];
      auto sum = hn::Zero(d);
      for (uint32_t j = first + 1; j + 1 < end; ++j) {
        const auto own = hn::Load(d, scratch + cage.fan_plane[j] * lanes);
        const auto next = hn::Load(d, scratch + cage.fan_plane[j + 1] * lanes);
        sum = sum + hn::Set(d, cage.fan_volume[j]) * (own * next);
      }
      hn::Store(sum * hn::Load(d, scratch + cage.fan_plane[first] * lanes), d, weights + size_t{v} * kBlock + i);
    }
    StoreSum(d, cage.vertex_count, weights, i, points);
    hn::Store(least, d, points->depth + i);
  }
}

void BlendBlock(const Cage& cage, const double* weights, const double* values, size_t value_count, double* out) {
  const Doubles d;
  for (size_t i = 0; i < kBlock; i += hn::Lanes(d)) {
    const double* from = weights + i;
    const auto weight = [&](uint32_t v) { return hn::Load(d, from + size_t{v} * kBlock); };
    for (size_t k = 0; k < value_count; ++k) {
      const double* value = values + k * cage.vertex_count;
      const auto term = [&](uint32_t v) { return weight(v) * hn::Set(d, value[v]); };
      // Four sums hide the latency of additions. There are at least four vertices.
      auto a = term(0), b = term(1), c = term(2), e = term(3);
      uint32_t v = 4;
      for (; v + 3 < cage.vertex_count; v += 4) {
        a = a + term(v);
        b = b + term(v + 1);
        c = c + term(v + 2);
        e = e + term(v + 3);
      }
      for (; v < cage.vertex_count; ++v) a = a + term(v);
      hn::Store((a + b) + (c + e), d, out + k * kBlock + i);
    }
  }
}

}  // namespace shd::polygon::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::polygon {

HWY_EXPORT(MeanValueBlock);
HWY_EXPORT(FastMeanValueBlock);
HWY_EXPORT(WachspressBlock);
HWY_EXPORT(BlendBlock);

size_t scratch_size(const Cage& cage, shd_barycentric kind) {
  if (kind == SHD_BARYCENTRIC_WACHSPRESS) return size_t{cage.plane_count} * kBlock;
  // Columns of vertices and edges, and the sums of floats.
  return (cage.vertex_count * size_t{6} + cage.edge_count * size_t{4}) * kVectorDoubles;
}

void mean_value_weights(const Cage& cage, const core::SimdTarget& simd, double* scratch, CagePoints* points,
                        double* weights) {
  SHD_DISPATCH(MeanValueBlock, simd)(cage, scratch, points, weights);
}

void fast_mean_value_weights(const Cage& cage, const core::SimdTarget& simd, double* scratch, CagePoints* points,
                             double* weights) {
  SHD_DISPATCH(FastMeanValueBlock, simd)(cage, scratch, points, weights);
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
