// SPDX-License-Identifier: MIT
// Irradiance and radiance of an environment at one direction per lane.

#if defined(SHD_ENVIRONMENT_LOOK_UP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_ENVIRONMENT_LOOK_UP_INL_H_
#undef SHD_ENVIRONMENT_LOOK_UP_INL_H_
#else
#define SHD_ENVIRONMENT_LOOK_UP_INL_H_
#endif

#include <hwy/highway.h>

#include "environment/environment.h"
#include "environment/harmonics-inl.h"
#include "environment/lobe_table.h"
#include "projection/octahedral-inl.h"
#include "simd/finite-inl.h"
#include "simd/gather-inl.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::environment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using simd::HWY_NAMESPACE::GatherPairs;
using simd::HWY_NAMESPACE::Vec3V;

/// log2 of x >= 2^-126, linear between powers of two. A mean of the maps of two powers, weighted by the fraction, has
/// the peak of a lobe of precision x.
template <class D, class V>
HWY_INLINE V PrecisionLog2(D d, V x) {
  const hn::RebindToSigned<D> di;
  return hn::ConvertTo(d, hn::BitCast(di, x) - hn::Set(di, 0x3f800000)) * hn::Set(d, 0x1p-23f);
}

/// A point of the octahedral square, -1..1.
template <class V>
struct SquareV {
  V p, q;
};

/// The point of a direction. A direction that is not finite, or shorter than 2^-126, counts as +Z.
template <class D, class V>
HWY_INLINE SquareV<V> SquarePoint(D d, const Vec3V<V>& n) {
  const V one = hn::Set(d, 1.0f), sum = hn::Abs(n.x) + hn::Abs(n.y) + hn::Abs(n.z);
  const auto usable = hn::And(hn::Gt(sum, hn::Set(d, 0x1p-126f)), hn::Lt(sum, hn::Inf(d)));
  const Vec3V<V> safe = Select(usable, n, Vec3V<V>{hn::Zero(d), hn::Zero(d), hn::Zero(d)});
  const projection::HWY_NAMESPACE::Octahedral<D> at(d, safe, one / hn::IfThenElse(usable, sum, one));
  return {at.a, at.b};
}

template <class V>
struct ColorV {
  V channel[3];
};

/// Bilinear lookup of a map. Its size and its first texel may differ between lanes.
template <class D, class V, class VI>
HWY_INLINE ColorV<V> LookUpMap(D d, const PackedTexel* texels, VI size, VI first, const SquareV<V>& at) {
  const hn::RebindToSigned<D> di;
  const V half = hn::ConvertTo(d, size) * hn::Set(d, 0.5f), centre = half + hn::Set(d, 0.5f);
  const V u = centre + at.p * half, v = centre - at.q * half;
  const VI column = hn::Min(hn::ConvertTo(di, u), size), row = hn::Min(hn::ConvertTo(di, v), size);
  const V fu = u - hn::ConvertTo(d, column), fv = v - hn::ConvertTo(d, row);
  const VI stride = size + hn::Set(di, 2), two = hn::Set(di, 2), low = hn::Set(di, 0xffff);
  const VI top = first + row * stride + column, above = top + top, below = above + (stride + stride);
  const VI corner[4] = {above, above + two, below, below + two};
  const V w3 = fv * fu, w2 = fv - w3, w1 = fu - w3, w0 = (hn::Set(d, 1.0f) - fv) - w1;
  const V weight[4] = {w0, w1, w2, w3};
  const auto* words = reinterpret_cast<const int32_t*>(texels);
  ColorV<V> sum = {{hn::Zero(d), hn::Zero(d), hn::Zero(d)}};
  for (int k = 0; k < 4; ++k) {
    VI rg, be;
    GatherPairs(di, words, corner[k], &rg, &be);
    const V scale = weight[k] * hn::BitCast(d, hn::ShiftLeft<23>(hn::ShiftRight<16>(be)));
    const auto number = [&](VI bits) HWY_ATTR { return hn::ConvertTo(d, hn::And(bits, low)); };
    sum.channel[0] = sum.channel[0] + scale * number(rg);
    sum.channel[1] = sum.channel[1] + scale * number(hn::ShiftRight<16>(rg));
    sum.channel[2] = sum.channel[2] + scale * number(be);
  }
  return sum;
}

/// Mean radiance around a direction over a lobe whose precision has the logarithm t (PrecisionLog2).
template <class D, class V>
HWY_NOINLINE ColorV<V> LookUpChain(D d, const PackedTexel* texels, const Chain& chain, const SquareV<V>& at, V t) {
  const hn::RebindToSigned<D> di;
  using VI = hn::Vec<decltype(di)>;
  const V zero = hn::Zero(d), knee = hn::Set(d, chain.knee), last = hn::Set(d, static_cast<float>(chain.count - 1));
  V place = hn::Min(t, knee) + hn::Max(t - knee, zero) * hn::Set(d, 0.5f) - hn::Set(d, chain.offset);
  place = hn::IfThenElseZero(hn::Gt(place, zero), hn::Min(place, last));  // NaN gives 0
  const auto low = hn::ConvertTo(di, place);
  const V part = place - hn::ConvertTo(d, low);
  const int32_t only = hn::GetLane(low);
  const auto is_only = hn::AllTrue(di, hn::Eq(low, hn::Set(di, only)));
  const auto look_up = [&](int32_t step) HWY_ATTR {
    if (is_only) {  // most vectors: one roughness
      const Level& level = chain.level[only + step];
      return LookUpMap<D, V, VI>(d, texels, hn::Set(di, static_cast<int32_t>(level.size)),
                                 hn::Set(di, static_cast<int32_t>(level.first)), at);
    }
    const VI next = hn::Min(low + hn::Set(di, step), hn::Set(di, static_cast<int32_t>(chain.count - 1)));
    VI size, first;
    GatherPairs(di, reinterpret_cast<const int32_t*>(chain.level), next + next, &size, &first);
    return LookUpMap<D, V, VI>(d, texels, size, first, at);
  };
  ColorV<V> color = look_up(0);
  if (hn::AllTrue(d, hn::Eq(part, zero))) return color;
  const ColorV<V> next = look_up(1);
  for (int c = 0; c < 3; ++c) color.channel[c] = color.channel[c] + part * (next.channel[c] - color.channel[c]);
  return color;
}

/// Irradiance of a surface with the unit normal n; 0 where n is not finite.
template <class D, class V>
HWY_NOINLINE ColorV<V> Irradiance(D d, const Environment& environment, const Vec3V<V>& n) {
  const hn::RebindToSigned<D> di;
  if (environment.irradiance.size) {
    const Level& level = environment.irradiance;
    return LookUpMap<D, V>(d, environment.texels.data(), hn::Set(di, static_cast<int32_t>(level.size)),
                           hn::Set(di, static_cast<int32_t>(level.first)), SquarePoint(d, n));
  }
  const HarmonicBasis<V> basis(d, n);
  ColorV<V> color;
  for (int c = 0; c < 3; ++c) {
    V sum = hn::Set(d, environment.harmonics[c][0]);
    for (int k = 1; k < kHarmonics; ++k) sum = sum + hn::Set(d, environment.harmonics[c][k]) * basis.value[k];
    color.channel[c] = hn::IfThenElseZero(hn::Gt(sum, hn::Zero(d)), sum);
  }
  return color;
}

/// Elements column and column + 1 of a row of a table, 0 <= column <= kLobeColumns - 2. On AVX-512 a row is two
/// vectors, and permutations replace gathers: frames in the light of an environment take 0.9 of the time.
template <class D, class V, class VI>
HWY_INLINE void GatherInRow(D d, const float* row, VI column, V* left, V* right) {
#if HWY_TARGET == HWY_AVX3
  static_assert(kLobeColumns == 32, "two vectors");
  if constexpr (hn::MaxLanes(D()) == 16) {
    const V low = hn::LoadU(d, row), high = hn::LoadU(d, row + 16);
    const VI next = column + hn::Set(hn::RebindToSigned<D>(), 1);
    left->raw = _mm512_permutex2var_ps(low.raw, column.raw, high.raw);
    right->raw = _mm512_permutex2var_ps(low.raw, next.raw, high.raw);
    return;
  }
#endif
  GatherPairs(d, row, column, left, right);
}

/// Place in tables of `rows` rows: a row, and a column in 0..kLobeColumns - 1.
template <class D>
struct TablePoint {
  using V = hn::Vec<D>;
  using VI = hn::Vec<hn::RebindToSigned<D>>;
  VI index, column;
  V down, right;
  size_t row;     // row of the first lane
  bool only_row;  // all lanes read `row`: most vectors have one roughness

  HWY_INLINE TablePoint(D d, uint32_t rows, V place, V across) {
    const hn::RebindToSigned<D> di;
    place = hn::Min(place, hn::Set(d, static_cast<float>(rows - 1)));
    const VI first = hn::Min(hn::ConvertTo(di, place), hn::Set(di, static_cast<int32_t>(rows - 2)));
    column = hn::Min(hn::ConvertTo(di, across), hn::Set(di, kLobeColumns - 2));
    down = place - hn::ConvertTo(d, first);
    right = across - hn::ConvertTo(d, column);
    index = hn::ShiftLeft<5>(first) + column;
    row = static_cast<size_t>(hn::GetLane(first));
    only_row = hn::AllTrue(di, hn::Eq(first, hn::Set(di, hn::GetLane(first))));
  }

  template <class Sum>
  HWY_INLINE V LookUp(D d, const Sum& table) const {
    static_assert(kLobeColumns == 32, "the shift of the index");
    const float* const first = table.at[0];
    V a, b, c, e;
    if (kHasWideRows && only_row) {
      GatherInRow(d, first + row * kLobeColumns, column, &a, &b);
      GatherInRow(d, first + (row + 1) * kLobeColumns, column, &c, &e);
    } else {
      GatherPairs(d, first, index, &a, &b);
      GatherPairs(d, first + kLobeColumns, index, &c, &e);
    }
    const V above = a + right * (b - a), below = c + right * (e - c);
    return above + down * (below - above);
  }

  /// A table of one row.
  HWY_INLINE V LookUpRow(D d, const float* table) const {
    V a, b;
    GatherInRow(d, table, column, &a, &b);
    return a + right * (b - a);
  }

 private:
  static constexpr bool kHasWideRows = HWY_TARGET == HWY_AVX3 && hn::MaxLanes(D()) == 16;
};

/// n.v clamped to `least`..1; `least` for NaN.
template <class D, class V>
HWY_INLINE V ClampCosine(D d, V n_dot_v, float least) {
  const V low = hn::Set(d, least);
  return hn::IfThenElse(hn::Gt(n_dot_v, low), hn::Min(n_dot_v, hn::Set(d, 1.0f)), low);
}

/// Place in the tables of GGX lobes, of the precision 1 / alpha^2.
template <class D, class V>
HWY_INLINE TablePoint<D> GgxPoint(D d, V precision, V n_dot_v) {
  const V root = hn::Sqrt(hn::Sqrt(hn::Sqrt(ClampCosine(d, n_dot_v, kGgxLeastCosine))));
  const V across = (root - hn::Set(d, kGgxLeastRoot)) * hn::Set(d, (kLobeColumns - 1) / (1.0f - kGgxLeastRoot));
  const V row = PrecisionLog2(d, precision) * hn::Set(d, static_cast<float>(kGgxRowsPerOctave));
  return {d, kGgxRows, row, across};
}

/// Row in the tables of the other lobes, of the inverse of a precision.
template <class D, class V>
HWY_INLINE V PhongRow(D d, V inverse) {
  return hn::Sqrt(inverse) * hn::Set(d, kPhongRows - 1.0f);
}

template <class D, class V>
HWY_INLINE TablePoint<D> PhongPoint(D d, V inverse, V n_dot_v) {
  const V one = hn::Set(d, 1.0f), columns = hn::Set(d, kLobeColumns - 1.0f);
  return {d, kPhongRows, PhongRow(d, inverse), (one - hn::Sqrt(one - ClampCosine(d, n_dot_v, 0.0f))) * columns};
}

template <class D, class V>
HWY_INLINE TablePoint<D> BlinnPhongPoint(D d, V inverse, V n_dot_v) {
  const V columns = hn::Set(d, kLobeColumns - 1.0f);
  return {d, kPhongRows, PhongRow(d, inverse), hn::Sqrt(ClampCosine(d, n_dot_v, 0.0f)) * columns};
}

}  // namespace shd::environment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_ENVIRONMENT_LOOK_UP_INL_H_
