// SPDX-License-Identifier: MIT
// Kernels of 8-bit unorm formats in fixed point.
#include "texture/format/fixed.h"

#include "image/format.h"
#include "texture/stream.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/format/fixed.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/tail-inl.h"
#include "texture/format/fixed_sums-inl.h"
#include "texture/format/formats-inl.h"
#include "texture/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

/// Sums unorm texels of kSize bytes.
template <size_t kSize>
HWY_INLINE void SumUnormsOf(const TexelSource& source, FixedVector* vectors, size_t count) {
  for (FixedVector* vector = vectors; vector != vectors + count; ++vector) {
    if (vector->two_sums) {
      SumQuads<kSize, true>(source, vector);
    } else {
      SumQuads<kSize, false>(source, vector);
    }
  }
}

void SumUnorms(const TexelSource& source, FixedVector* vectors, size_t count) {
  switch (source.channels) {
    case 1: return SumUnormsOf<1>(source, vectors, count);
    case 2: return SumUnormsOf<2>(source, vectors, count);
    default: return SumUnormsOf<4>(source, vectors, count);
  }
}

/// 1 / (probes one) as the sum of two factors. The product of a sum of equal codes and `high` is exact, so that equal
/// codes give the correctly rounded quotient (test_fixed.cpp tries them all).
template <class D>
struct Quotient {
  hn::Vec<D> high, low;

  HWY_INLINE Quotient(D d, hn::Vec<D> probes, float one) {
    const hn::RebindToSigned<D> di;
    const auto divisor = probes * hn::Set(d, one);
    const auto reciprocal = hn::Set(d, 1.0f) / divisor;
    high = hn::BitCast(d, hn::BitCast(di, reciprocal) & hn::Set(di, -(1 << 14)));  // 10 bits
    low = (hn::Set(d, 1.0f) - high * divisor) * reciprocal;
  }
  HWY_INLINE hn::Vec<D> of(hn::Vec<D> sum) const { return sum * high + sum * low; }
};

/// Writes the channels of one vector of lookups, whose sums are divided by a quotient.
template <bool kTwoSums, class D>
HWY_INLINE void StoreQuotients(D d, const FixedVector& vector, const Quotient<D>& quotient, size_t end,
                               const Texels& out) {
  Ints<D> first[4], second[4];
  LoadSums(d, vector.sum[0], first);
  LoadSums(d, vector.sum[kTwoSums ? 1 : 0], second);
  for (size_t c = 0; c < 4; ++c) {
    if (!out.channel[c]) continue;
    auto value = hn::ConvertTo(d, first[c]);
    if (kTwoSums) value = value + hn::Load(d, vector.fraction) * (hn::ConvertTo(d, second[c]) - value);
    simd::HWY_NAMESPACE::StoreFirst(d, quotient.of(value), end - vector.at, out.channel[c] + vector.at);
  }
}

void StoreUnorms(const FixedVector* vectors, size_t count, size_t end, const Texels& out) {
  const BatchTag d;
  const Quotient<BatchTag> of_one(d, hn::Set(d, 1.0f), 255.0f * kWeightOne);
  for (const FixedVector* vector = vectors; vector != vectors + count; ++vector) {
    Quotient<BatchTag> quotient = of_one;
    if (!vector->one_quad) quotient = Quotient<BatchTag>(d, hn::Load(d, vector->probes), 255.0f * kWeightOne);
    if (vector->two_sums) {
      StoreQuotients<true>(d, *vector, quotient, end, out);
    } else {
      StoreQuotients<false>(d, *vector, quotient, end, out);
    }
  }
}

}  // namespace

FixedKernels FixedOf(image::Component component) {
  // Rejected: sRGB, with texels decoded to 15 bits by a table. It had 0.5 (AVX-512) to 0.9 (AVX2, SSE4) of the speed of
  // floats, because every texel takes three loads from the table.
  if (component == image::Component::kUnorm8) return {SumUnorms, StoreUnorms};
  return {nullptr, nullptr};
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
