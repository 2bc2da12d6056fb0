// SPDX-License-Identifier: MIT
#include "procedural/solid.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "procedural/perlin_table.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "procedural/lattice-inl.h"
#include "procedural/octaves-inl.h"
#include "simd/gather-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::procedural::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// One octave of the classic noise: gradients G(phi(i + phi(j + phi(k)))) of a table.
struct TablePerlin {
  const GradientTable& table;
  shd_solid_fade fade;

  /// Elements of a table at the two ends of an axis, from the index of the nearer end.
  template <class D, class T, class VI>
  static HWY_INLINE void Pair(D d, const T* from, VI index, hn::Vec<D>* ends) {
    simd::HWY_NAMESPACE::GatherPairs(d, from, index & hn::Set(hn::RebindToSigned<D>(), kTableSize - 1), ends, ends + 1);
  }

  template <bool kGradient, class D, class V>
  HWY_INLINE Sample<V> At(D d, V x, V y, V z, uint32_t) const {
    const hn::RebindToSigned<D> di;
    using VI = hn::Vec<decltype(di)>;
    const Axis<D> ax = SplitAxis(d, x), ay = SplitAxis(d, y), az = SplitAxis(d, z);
    const VI ix = hn::BitCast(di, ax.cell), iy = hn::BitCast(di, ay.cell), iz = hn::BitCast(di, az.cell);
    const V one = hn::Set(d, 1.0f);
    const V px[2] = {ax.at, ax.at - one}, py[2] = {ay.at, ay.at - one}, pz[2] = {az.at, az.at - one};
    VI of_k[2], of_j[2][2];
    Pair(di, table.permutation, iz, of_k);
    for (int k = 0; k < 2; ++k) Pair(di, table.permutation, iy + of_k[k], of_j[k]);
    V gx[2], gy[2], gz[2];  // gradients at the two corners of a row
    const auto corner = [&](int i, int j, int k) {
      if (i == 0) {
        Pair(d, table.x, ix + of_j[k][j], gx);
        Pair(d, table.y, ix + of_j[k][j], gy);
        Pair(d, table.z, ix + of_j[k][j], gz);
      }
      return Sample<V>{gx[i] * px[i] + gy[i] * py[j] + gz[i] * pz[k], gx[i], gy[i], gz[i]};
    };
    return Interpolate<kGradient, true>(FadeAt(d, fade, ax.at), FadeAt(d, fade, ay.at), FadeAt(d, fade, az.at), corner);
  }
};

size_t PerlinTable(const Solid& solid, const Places& places, const Values& out) {
  return EvaluateSum(solid, TablePerlin{solid.table, solid.fade}, places, out);
}

}  // namespace shd::procedural::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::procedural {

HWY_EXPORT(PerlinTable);

size_t evaluate_perlin_table(const Solid& solid, const core::SimdTarget& simd, const Places& places,
                             const Values& out) {
  return SHD_DISPATCH(PerlinTable, simd)(solid, places, out);
}

}  // namespace shd::procedural
#endif  // HWY_ONCE
