// SPDX-License-Identifier: MIT
#include "texture/sample.h"

#include "core/simd_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/sample_trilinear.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/batch-inl.h"
#include "texture/filter-inl.h"
#include "texture/record-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Writes the clamped level of detail of each lookup to the first column.
struct LevelOfDetail {
  const Texture& texture;
  const Sampler& sampler;
  LodRange range;
  bool lod_given;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    const auto width = static_cast<float>(texture.width), height = static_cast<float>(texture.height);
    const auto lambda = lod_given ? p.lod : LambdaOf(d, p.derivatives, width, height);
    hn::StoreU(ClampLod(d, lambda, sampler.lod_bias, range), d, out.channel[0] + i);
  }
};

/// Bilinear on the levels floor(lod) and the next, blended by the fraction (Williams, "Pyramidal Parametrics", 1983).
/// The short cuts for lanes that share a level or blend nothing give the bits of the general path.
template <class F, bool kBorder>
struct Trilinear {
  const Texture& texture;
  const Sampler& sampler;

  template <class D>
  HWY_INLINE void operator()(D d, const Points<D>& p, const Texels& out, size_t i) const {
    const hn::RebindToSigned<D> di;
    const auto u = ReduceCoordinate(d, sampler.wrap_u, p.u);
    const auto v = ReduceCoordinate(d, sampler.wrap_v, p.v);
    const auto floor = hn::Floor(p.lod);
    const auto fraction = hn::Sub(p.lod, floor);
    const float first = hn::GetLane(floor);
    const bool same = hn::AllTrue(d, hn::Eq(floor, hn::Set(d, first)));
    const auto level = hn::ConvertTo(di, floor);
    const Quad<F, D> high = FetchQuad<F>(d, texture, sampler,
                                         same ? SameLevel(d, texture, p.first_texel, static_cast<uint32_t>(first))
                                              : LevelPerLane(d, texture, p.first_texel, level),
                                         u, v);
    if (hn::AllTrue(d, hn::Eq(fraction, hn::Zero(d)))) return StoreQuad<F, kBorder>(d, high, sampler, out, i);

    const auto last = static_cast<int32_t>(texture.level_count - 1);
    const auto next = hn::Min(hn::Add(level, hn::Set(di, 1)), hn::Set(di, last));
    const Quad<F, D> low =
        FetchQuad<F>(d, texture, sampler,
                     same ? SameLevel(d, texture, p.first_texel, static_cast<uint32_t>(hn::GetLane(next)))
                          : LevelPerLane(d, texture, p.first_texel, next),
                     u, v);
    StoreChannels<F, kBorder>(d, Pair<D>{high, low, fraction, sampler}, out, i);
  }

  template <class D>
  struct Pair {
    const Quad<F, D>&high, &low;
    hn::Vec<D> fraction;
    const Sampler& sampler;

    template <size_t C>
    HWY_INLINE auto of() const {
      const auto first = BlendQuad<F, kBorder, C>(D(), high, sampler);
      const auto second = BlendQuad<F, kBorder, C>(D(), low, sampler);
      return Blend<F, kBorder>::blend(D(), first, second, fraction);
    }
  };
};

/// The lookups of a batch whose levels of detail are found before any of them is filtered: the two chains of dependent
/// operations then overlap with those of other lookups.
constexpr size_t kBlock = 256;

template <class T>
const T* Skip(const T* column, size_t rows) {
  return column ? column + rows : nullptr;
}

template <class F>
size_t TrilinearOfFormat(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  const LevelOfDetail level_of_detail = {texture, sampler, lod_range(texture, sampler), in.lod != nullptr};
  alignas(64) float lod[kBlock];
  size_t nonfinite = 0;
  for (size_t first = 0; first < in.count; first += kBlock) {
    const size_t count = in.count - first < kBlock ? in.count - first : kBlock;
    const Lookups given = {count,
                           in.u + first,
                           in.v + first,
                           Skip(in.dudx, first),
                           Skip(in.dvdx, first),
                           Skip(in.dudy, first),
                           Skip(in.dvdy, first),
                           Skip(in.lod, first),
                           Skip(in.layer, first),
                           Skip(in.random, first)};
    nonfinite += ForEachVector(texture, level_of_detail, given, {{lod, nullptr, nullptr, nullptr}});
    const Lookups block = {count, given.u, given.v, nullptr, nullptr, nullptr, nullptr, lod, given.layer, nullptr};
    Texels to;
    for (size_t c = 0; c < 4; ++c) to.channel[c] = out.channel[c] ? out.channel[c] + first : nullptr;
    if (has_border(sampler)) {
      ForEachVector<typename TagOf<F>::Type>(texture, Trilinear<F, true>{texture, sampler}, block, to);
    } else {
      ForEachVector<typename TagOf<F>::Type>(texture, Trilinear<F, false>{texture, sampler}, block, to);
    }
  }
  return nonfinite;
}

size_t LodBatch(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  return ForEachVector(texture, LevelOfDetail{texture, sampler, lod_range(texture, sampler), in.lod != nullptr}, in,
                       out);
}

struct TrilinearOfTexture {
  const Texture& texture;
  const Sampler& sampler;
  const Lookups& in;
  const Texels& out;

  template <class F>
  size_t run() const {
    return TrilinearOfFormat<F>(texture, sampler, in, out);
  }
};

size_t TrilinearBatch(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  return ForFormat(texture, TrilinearOfTexture{texture, sampler, in, out});
}

#if HWY_TARGET == HWY_STATIC_TARGET
void RecordTrilinear(const Texture& texture, const Sampler& sampler, const Lookups& in, const Texels& out) {
  TrilinearOfFormat<Recorded>(texture, sampler, in, out);
}
#endif

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(TrilinearBatch);
HWY_EXPORT(LodBatch);
}  // namespace

size_t sample_trilinear(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd,
                        const Lookups& lookups, const Texels& out) {
  return SHD_DISPATCH(TrilinearBatch, simd)(texture, sampler, lookups, out);
}

size_t sample_lod(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookups,
                  float* out) {
  return SHD_DISPATCH(LodBatch, simd)(texture, sampler, lookups, {{out}});
}

void record_trilinear(const Texture& texture, const Sampler& sampler, const Lookups& lookups) {
  float unused[1];
  HWY_STATIC_DISPATCH(RecordTrilinear)(texture, sampler, lookups, {{unused}});
}

}  // namespace shd::texture
#endif
