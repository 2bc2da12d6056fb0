// SPDX-License-Identifier: MIT
// Loads of texels with one index per lane. The cost of a gather is proportional to its elements, so neighbours are
// loaded together if the target has the instructions: a vector of points along a row by loads and permutations, the two
// texels of a row by one element of 8 bytes. Only the loads differ; the bits are those of plain gathers.

#if defined(SHD_TEXTURE_GATHER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SHD_TEXTURE_GATHER_INL_H_
#undef SHD_TEXTURE_GATHER_INL_H_
#else
#define SHD_TEXTURE_GATHER_INL_H_
#endif

#include <cstring>

#include <hwy/highway.h>

#include "simd/gather-inl.h"
#include "texture/lanes-inl.h"
#include "texture/stream.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
HWY_INLINE Ints<D> GatherWords(D, const uint8_t* texels, Ints<D> index) {
  const hn::RebindToSigned<D> di;
  return hn::GatherIndex(di, reinterpret_cast<const int32_t*>(texels), index);
}

/// Gathers words at byte offsets of any alignment. Reads up to 3 bytes after a texel.
template <class D>
HWY_INLINE Ints<D> GatherBytes(D, const uint8_t* texels, Ints<D> offset) {
  const hn::RebindToSigned<D> di;
  return hn::GatherOffset(di, reinterpret_cast<const int32_t*>(texels), offset);
}

/// Returns the base address of the texels at the indices, or null if some of them are borrowed and others are not.
template <class D>
HWY_INLINE const uint8_t* TexelsOf(D, const TexelSource& source, Ints<D> index) {
  if (HWY_LIKELY(!source.borrowed)) return source.origin;
  const hn::RebindToSigned<D> di;
  const auto borrowed = hn::Lt(index, hn::Set(di, static_cast<int32_t>(source.borrowed_texels)));
  if (hn::AllTrue(di, borrowed)) return source.borrowed;
  return hn::AllFalse(di, borrowed) ? source.origin : nullptr;
}

/// Loads the words `byte` bytes after the start of texels that are not all in one block. This is rare: a vector must
/// have lanes on a borrowed level 0 and on other levels.
template <class D>
HWY_NOINLINE Ints<D> GatherApart(D, const TexelSource& source, Ints<D> index, size_t byte) {
  const hn::RebindToSigned<D> di;
  alignas(64) int32_t word[hn::MaxLanes(di)];
  hn::Store(index, di, word);
  for (size_t k = 0; k < hn::Lanes(di); ++k) {
    std::memcpy(&word[k], source.texel(static_cast<uint32_t>(word[k])) + byte, sizeof word[k]);
  }
  return hn::Load(di, word);
}

/// Loads two consecutive words from each index, which counts units of `kStride` bytes; lanes may be far apart. The
/// indices are read from memory, because it is expensive to extract the elements of a vector.
template <size_t kStride, class D>
HWY_INLINE void LoadApart(D, const uint8_t* texels, const int32_t* index, Ints<D>* left, Ints<D>* right) {
  const auto at = [&](size_t lane) {
    return reinterpret_cast<const int32_t*>(texels + kStride * static_cast<uint32_t>(index[lane]));
  };
  simd::HWY_NAMESPACE::LoadPairs(hn::RebindToSigned<D>(), at, left, right);
}

#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
/// Returns the words at first + index, for indices in 0..2 * lanes - 1. `low` and `high` are the two vectors of words
/// that begin at `first`.
template <class D>
HWY_INLINE Ints<D> LookUpRow(D, Ints<D> low, Ints<D> high, Ints<D> index) {
#if HWY_TARGET == HWY_AVX3
  if constexpr (hn::MaxLanes(D()) == 16) return Ints<D>{_mm512_permutex2var_epi32(low.raw, index.raw, high.raw)};
#elif HWY_TARGET == HWY_AVX2
  if constexpr (hn::MaxLanes(D()) == 8) {  // permutations ignore the upper bits of the index
    const __m256 in_low = _mm256_castsi256_ps(_mm256_permutevar8x32_epi32(low.raw, index.raw));
    const __m256 in_high = _mm256_castsi256_ps(_mm256_permutevar8x32_epi32(high.raw, index.raw));
    const __m256 beyond = _mm256_castsi256_ps(_mm256_slli_epi32(index.raw, 28));
    return Ints<D>{_mm256_castps_si256(_mm256_blendv_ps(in_low, in_high, beyond))};
  }
#endif
  const hn::RebindToSigned<D> di;
  const auto lanes = hn::Set(di, static_cast<int32_t>(hn::Lanes(di)));
  const auto in_low = hn::Lt(index, lanes);
  const auto indices = hn::IndicesFromVec(di, hn::IfThenElse(in_low, index, index - lanes));
  return hn::IfThenElse(in_low, hn::TableLookupLanes(low, indices), hn::TableLookupLanes(high, indices));
}

/// A window of two vectors of words along a row that may contain the words at index and index + 1 of every lane.
template <class D>
struct RowWindow {
  Ints<D> left, right;  // index - first, index - first + 1
  int32_t first;        // first word of the window
  bool fits;            // the window contains both words of every lane
};

/// Returns the window of indices.
template <class D>
HWY_INLINE RowWindow<D> WindowOf(D, const int32_t* index) {
  const hn::RebindToSigned<D> di;
  const hn::RebindToUnsigned<D> du;
  const auto lanes = static_cast<int32_t>(hn::Lanes(di));
  const int32_t begin = index[0], end = index[lanes - 1], span = begin < end ? end - begin : begin - end;
  RowWindow<D> window;
  window.first = begin < end ? begin : end;
  const int32_t last = 2 * lanes - 2;
  window.fits = span <= last;
  if (!window.fits) return window;
  window.left = hn::Load(di, index) - hn::Set(di, window.first);
  window.right = window.left + hn::Set(di, 1);
  const auto left = hn::BitCast(du, window.left);  // unsigned, so that words before the window are beyond it
  window.fits = hn::AllTrue(du, hn::Eq(hn::Min(left, hn::Set(du, static_cast<uint32_t>(last))), left));
  return window;
}

/// Loads the words at index and index + 1 from a window that fits, moved so that it begins at `first`.
template <class D>
HWY_INLINE void LoadWindow(D d, const uint8_t* texels, const RowWindow<D>& window, int32_t first, Ints<D>* left,
                           Ints<D>* right) {
  const hn::RebindToSigned<D> di;
  const int32_t* words = reinterpret_cast<const int32_t*>(texels) + first;
  const auto low = hn::LoadU(di, words), high = hn::LoadU(di, words + hn::Lanes(di));
  *left = LookUpRow(d, low, high, window.left);
  *right = LookUpRow(d, low, high, window.right);
}

/// Loads two consecutive words from each index, which counts units of `kStride` bytes.
template <size_t kStride, class D>
HWY_INLINE void LoadWordPairs(D d, const uint8_t* texels, const int32_t* index, Ints<D>* left, Ints<D>* right) {
  if constexpr (kStride == 4) {
    const RowWindow<D> window = WindowOf(d, index);
    if (window.fits) return LoadWindow(d, texels, window, window.first, left, right);
  }
  LoadApart<kStride>(d, texels, index, left, right);
}

#if HWY_TARGET == HWY_AVX2
/// Loads quads of words if each half of the vector lies in eight words of a row. Returns whether it does. A half takes
/// one permutation for each texel; a window of two vectors takes two, and a slow blend.
template <class D>
HWY_INLINE bool LoadHalfWindows(D, const uint8_t* texels, const int32_t* upper, int32_t down, Ints<D> (&word)[4]) {
  const __m256i index = _mm256_load_si256(reinterpret_cast<const __m256i*>(upper));
  const __m256i first = _mm256_min_epi32(_mm256_shuffle_epi32(index, 0x00), _mm256_shuffle_epi32(index, 0xff));
  const __m256i place = _mm256_sub_epi32(index, first);
  const __m256i eights = _mm256_srli_epi32(place, 3);
  if (HWY_UNLIKELY(!_mm256_testz_si256(eights, eights))) return false;
  const auto* const words = reinterpret_cast<const int32_t*>(texels);
  const int32_t* const low = words + (upper[0] < upper[3] ? upper[0] : upper[3]);
  const int32_t* const high = words + (upper[4] < upper[7] ? upper[4] : upper[7]);
  const auto look_up = [&](int32_t step) SHD_INLINE_LAMBDA {
    const auto from = [&](const int32_t* window) SHD_INLINE_LAMBDA {
      return _mm256_permutevar8x32_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(window + step)), place);
    };
    return Ints<D>{_mm256_blend_epi32(from(low), from(high), 0xf0)};
  };
  word[0] = look_up(0);
  word[1] = look_up(1);
  word[2] = look_up(down);
  word[3] = look_up(down + 1);
  return true;
}
#endif

/// Loads two consecutive words from each index, and those `down` words after them.
template <class D>
HWY_INLINE void LoadRowQuads(D d, const uint8_t* texels, const int32_t* upper, int32_t down, Ints<D> (&word)[4]) {
#if HWY_TARGET == HWY_AVX2
  if constexpr (hn::MaxLanes(D()) == 8) {
    if (HWY_LIKELY(LoadHalfWindows(d, texels, upper, down, word))) return;
  }
#endif
  const RowWindow<D> window = WindowOf(d, upper);
  if (window.fits) {
    LoadWindow(d, texels, window, window.first, &word[0], &word[1]);
    return LoadWindow(d, texels, window, window.first + down, &word[2], &word[3]);
  }
  LoadApart<4>(d, texels, upper, &word[0], &word[1]);
  LoadApart<4>(d, texels + ptrdiff_t{4} * down, upper, &word[2], &word[3]);
}

/// Loads two consecutive words from each index, in the upper and in the lower row of quads.
template <class D>
HWY_INLINE void LoadWordQuads(D d, const uint8_t* texels, const int32_t* upper, const int32_t* lower,
                              Ints<D> (&word)[4]) {
  const hn::RebindToSigned<D> di;
  const int32_t down = lower[0] - upper[0];
  if (hn::AllTrue(di, hn::Eq(hn::Load(di, lower) - hn::Load(di, upper), hn::Set(di, down)))) {
    return LoadRowQuads(d, texels, upper, down, word);
  }
  LoadApart<4>(d, texels, upper, &word[0], &word[1]);
  LoadApart<4>(d, texels, lower, &word[2], &word[3]);
}
#else
template <class D>
HWY_INLINE void LoadRowQuads(D d, const uint8_t* texels, const int32_t* upper, int32_t down, Ints<D> (&word)[4]) {
  LoadApart<4>(d, texels, upper, &word[0], &word[1]);
  LoadApart<4>(d, texels + ptrdiff_t{4} * down, upper, &word[2], &word[3]);
}

template <size_t kStride, class D>
HWY_INLINE void LoadWordPairs(D d, const uint8_t* texels, const int32_t* index, Ints<D>* left, Ints<D>* right) {
  LoadApart<kStride>(d, texels, index, left, right);
}

template <class D>
HWY_INLINE void LoadWordQuads(D d, const uint8_t* texels, const int32_t* upper, const int32_t* lower,
                              Ints<D> (&word)[4]) {
  LoadWordPairs<4>(d, texels, upper, &word[0], &word[1]);
  LoadWordPairs<4>(d, texels, lower, &word[2], &word[3]);
}
#endif

#if HWY_TARGET != HWY_SCALAR
/// Transposes each block of 4 x 4 words: word c of block b of row r becomes word r of block b of column[c].
template <class V>
HWY_INLINE void TransposeBlocks(const V (&row)[4], V (&column)[4]) {
  const hn::DFromV<V> di;
  const hn::Repartition<int64_t, decltype(di)> wide;
  const auto low01 = hn::BitCast(wide, hn::InterleaveLower(di, row[0], row[1]));
  const auto low23 = hn::BitCast(wide, hn::InterleaveLower(di, row[2], row[3]));
  const auto high01 = hn::BitCast(wide, hn::InterleaveUpper(di, row[0], row[1]));
  const auto high23 = hn::BitCast(wide, hn::InterleaveUpper(di, row[2], row[3]));
  column[0] = hn::BitCast(di, hn::InterleaveLower(wide, low01, low23));
  column[1] = hn::BitCast(di, hn::InterleaveUpper(wide, low01, low23));
  column[2] = hn::BitCast(di, hn::InterleaveLower(wide, high01, high23));
  column[3] = hn::BitCast(di, hn::InterleaveUpper(wide, high01, high23));
}
#endif

/// Loads four consecutive words from each index, which counts units of `kStride` bytes, by one load of 16 bytes per
/// lane. The indices are read from memory, because it is expensive to extract the elements of a vector.
template <size_t kStride, class D>
HWY_INLINE void LoadFourWords(D, const uint8_t* texels, const int32_t* index, Ints<D> (&word)[4]) {
  const hn::RebindToSigned<D> di;
  constexpr size_t kLanes = hn::MaxLanes(hn::RebindToSigned<D>());
  const auto at = [&](size_t lane) {
    return reinterpret_cast<const int32_t*>(texels + kStride * static_cast<uint32_t>(index[lane]));
  };
#if HWY_TARGET == HWY_SCALAR
  static_assert(kLanes == 1);
  for (size_t k = 0; k < 4; ++k) word[k] = hn::LoadU(di, at(0) + k);
#else
  // Block b of lane[r] holds the four words of lane 4 b + r.
  Ints<D> lane[4];
  for (size_t r = 0; r < 4; ++r) {
    if constexpr (kLanes == 4) {
      lane[r] = hn::LoadU(di, at(r));
    } else {
      const hn::Half<decltype(di)> half;
      if constexpr (kLanes == 8) {
        lane[r] = hn::Combine(di, hn::LoadU(half, at(r + 4)), hn::LoadU(half, at(r)));
      } else {
        const hn::Half<decltype(half)> quarter;
        const auto low = hn::Combine(half, hn::LoadU(quarter, at(r + 4)), hn::LoadU(quarter, at(r)));
        const auto high = hn::Combine(half, hn::LoadU(quarter, at(r + 12)), hn::LoadU(quarter, at(r + 8)));
        lane[r] = hn::Combine(di, high, low);
      }
    }
  }
  TransposeBlocks(lane, word);
#endif
}

/// fetch_quad() of a format by its fetch_pair(), row by row.
template <class Format>
struct QuadsOfPairs {
  template <class D, class Texel>
  static HWY_INLINE void fetch_quad(D d, const TexelSource& source, const int32_t* upper, const int32_t* lower,
                                    Texel (&quad)[4]) {
    Format::fetch_pair(d, source, upper, &quad[0], &quad[1]);
    Format::fetch_pair(d, source, lower, &quad[2], &quad[3]);
  }
  /// Fetches quads whose texels need not be neighbours: the indices of the first ones, and those of the others.
  template <class D, class Texel, class Others>
  static HWY_NOINLINE void fetch_split(D d, const TexelSource& source, const int32_t* first, const Others& others,
                                       size_t i, Texel (&quad)[4]) {
    quad[0] = Format::fetch(d, source, first + i);
    for (size_t k = 0; k < 3; ++k) quad[k + 1] = Format::fetch(d, source, others[k] + i);
  }
  /// Fetches quads whose lower row lies `down` texels after the upper one.
  template <class D, class Texel>
  static HWY_NOINLINE void fetch_rows(D d, const TexelSource& source, const int32_t* upper, int32_t down,
                                      Texel (&quad)[4]) {
    TexelSource below = source;
    const ptrdiff_t bytes = ptrdiff_t{down} * source.texel_size;
    below.origin += bytes;
    if (below.borrowed) below.borrowed += bytes;
    Format::fetch_pair(d, source, upper, &quad[0], &quad[1]);
    Format::fetch_pair(d, below, upper, &quad[2], &quad[3]);
  }
};

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // SHD_TEXTURE_GATHER_INL_H_
