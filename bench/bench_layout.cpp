// SPDX-License-Identifier: MIT
// layout/<storage>/<fetch>/<pattern>/edge:<texels>: a separate bilinear RGBA8 loop over storage orders that the library
// does not have, on the best SIMD target, one thread. Fetches: words = four gathers; pairs = two gathers of 8 bytes
// where the right texel follows the left one; rows = the library's loads of whole rows, otherwise pairs. _prefetch
// prefetches the lines of later lookups. Patterns: floor, the floor turned by 45 degrees in texture space, uniform
// random positions, and these positions sorted by the Morton order of their texels.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <string>

#include "workload.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench_layout.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/format/gather-inl.h"

#ifndef SHD_BENCH_LAYOUT_ONCE
#define SHD_BENCH_LAYOUT_ONCE
namespace shd::bench {

enum class Storage { kLinear, kTiles4, kTiles8, kMorton };
enum class Fetch { kWords, kPairs, kRows };

/// A square texture of 2^log2_edge texels and the lookups; out has four columns of `count` floats.
struct LayoutJob {
  const uint32_t* texels;
  int log2_edge;
  const float* u;
  const float* v;
  size_t count;
  float* out;
};
using LayoutLoop = void (*)(const LayoutJob&);

}  // namespace shd::bench
#endif

HWY_BEFORE_NAMESPACE();
namespace shd::bench::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Spreads 16 bits over the even bits.
template <class V>
HWY_INLINE V Spread(V x) {
  const hn::DFromV<V> d;
  x = (x | hn::ShiftLeft<8>(x)) & hn::Set(d, 0x00FF00FF);
  x = (x | hn::ShiftLeft<4>(x)) & hn::Set(d, 0x0F0F0F0F);
  x = (x | hn::ShiftLeft<2>(x)) & hn::Set(d, 0x33333333);
  return (x | hn::ShiftLeft<1>(x)) & hn::Set(d, 0x55555555);
}

/// The part of a texel's index that depends on x; another part depends on y.
template <Storage kStorage, class V>
HWY_INLINE V PartOfX(V x) {
  const hn::DFromV<V> d;
  if constexpr (kStorage == Storage::kTiles4) {
    return hn::ShiftLeft<4>(hn::ShiftRight<2>(x)) + (x & hn::Set(d, 3));
  } else if constexpr (kStorage == Storage::kTiles8) {
    return hn::ShiftLeft<6>(hn::ShiftRight<3>(x)) + (x & hn::Set(d, 7));
  } else if constexpr (kStorage == Storage::kMorton) {
    return Spread(x);
  } else {
    return x;
  }
}

template <Storage kStorage, class V>
HWY_INLINE V PartOfY(V y, int log2_edge) {
  const hn::DFromV<V> d;
  if constexpr (kStorage == Storage::kTiles4) {
    return hn::ShiftLeftSame(hn::ShiftRight<2>(y), log2_edge + 2) + hn::ShiftLeft<2>(y & hn::Set(d, 3));
  } else if constexpr (kStorage == Storage::kTiles8) {
    return hn::ShiftLeftSame(hn::ShiftRight<3>(y), log2_edge + 3) + hn::ShiftLeft<3>(y & hn::Set(d, 7));
  } else if constexpr (kStorage == Storage::kMorton) {
    return hn::ShiftLeft<1>(Spread(y));
  } else {
    return hn::ShiftLeftSame(y, log2_edge);
  }
}

/// Fetches the four taps. Pairs and rows need the right texel after the left one; other lanes gather it afterwards.
template <Storage kStorage, Fetch kFetch, class V>
HWY_INLINE void FetchTaps(const LayoutJob& job, V x, V y, V* taps) {
  const hn::DFromV<V> di;
  const auto* words = reinterpret_cast<const int32_t*>(job.texels);
  const auto mask = hn::Set(di, (1 << job.log2_edge) - 1), one = hn::Set(di, 1);
  const auto left = PartOfX<kStorage>(x), right = PartOfX<kStorage>((x + one) & mask);
  const auto top = PartOfY<kStorage>(y, job.log2_edge);
  const auto bottom = PartOfY<kStorage>((y + one) & mask, job.log2_edge);
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  if constexpr (kFetch == Fetch::kPairs || kFetch == Fetch::kRows) {
    const hn::RebindToFloat<decltype(di)> d;
    const auto* bytes = reinterpret_cast<const uint8_t*>(job.texels);
    const auto behind = hn::Eq(right, left + one);
    const bool all = hn::AllTrue(di, behind);
    if constexpr (kFetch == Fetch::kRows) {
      if (all && texture::HWY_NAMESPACE::FetchRows(d, bytes, top, bottom, left, &taps[0], &taps[1], &taps[2], &taps[3]))
        return;
    }
    texture::HWY_NAMESPACE::GatherWordPairs(d, bytes, top + left, &taps[0], &taps[1]);
    texture::HWY_NAMESPACE::GatherWordPairs(d, bytes, bottom + left, &taps[2], &taps[3]);
    if (HWY_LIKELY(all)) return;
    taps[1] = hn::IfThenElse(behind, taps[1], hn::GatherIndex(di, words, top + right));
    taps[3] = hn::IfThenElse(behind, taps[3], hn::GatherIndex(di, words, bottom + right));
    return;
  }
#endif
  taps[0] = hn::GatherIndex(di, words, top + left);
  taps[1] = hn::GatherIndex(di, words, top + right);
  taps[2] = hn::GatherIndex(di, words, bottom + left);
  taps[3] = hn::GatherIndex(di, words, bottom + right);
}

/// Texel coordinate, wrapped, and the weight of the next texel.
template <class D>
HWY_INLINE hn::VFromD<hn::RebindToSigned<D>> Place(D d, const float* coordinate, int log2_edge, hn::VFromD<D>* weight) {
  const hn::RebindToSigned<D> di;
  const auto edge = hn::Set(d, static_cast<float>(1 << log2_edge));
  const auto place = hn::LoadU(d, coordinate) * edge - hn::Set(d, 0.5f);
  const auto below = hn::Floor(place);
  *weight = place - below;
  return hn::ConvertTo(di, below) & hn::Set(di, (1 << log2_edge) - 1);
}

/// Prefetches the lines of the top left and the bottom left texel of the lookups from `begin` on.
template <Storage kStorage, class D>
HWY_INLINE void PrefetchTaps(D d, const LayoutJob& job, size_t begin) {
  const hn::RebindToSigned<D> di;
  if (begin + hn::Lanes(d) > job.count) return;
  hn::VFromD<D> weight;
  const auto x = Place(d, job.u + begin, job.log2_edge, &weight), y = Place(d, job.v + begin, job.log2_edge, &weight);
  const auto mask = hn::Set(di, (1 << job.log2_edge) - 1);
  const auto left = PartOfX<kStorage>(x);
  HWY_ALIGN int32_t index[2 * HWY_MAX_BYTES / 4];
  hn::Store(PartOfY<kStorage>(y, job.log2_edge) + left, di, index);
  const auto below = PartOfY<kStorage>((y + hn::Set(di, 1)) & mask, job.log2_edge);
  hn::Store(below + left, di, index + hn::Lanes(di));
  for (size_t i = 0; i < 2 * hn::Lanes(di); ++i) hwy::Prefetch(job.texels + index[i]);
}

template <Storage kStorage, Fetch kFetch, bool kPrefetch>
void Loop(const LayoutJob& job) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  constexpr size_t kAhead = 64;
  for (size_t i = 0; i + hn::Lanes(d) <= job.count; i += hn::Lanes(d)) {
    if constexpr (kPrefetch) PrefetchTaps<kStorage>(d, job, i + kAhead);
    hn::VFromD<decltype(d)> wx, wy;
    const auto x = Place(d, job.u + i, job.log2_edge, &wx), y = Place(d, job.v + i, job.log2_edge, &wy);
    hn::VFromD<decltype(di)> taps[4];
    FetchTaps<kStorage, kFetch>(job, x, y, taps);
    for (int c = 0; c < 4; ++c) {
      hn::VFromD<decltype(d)> value[4];
      for (int k = 0; k < 4; ++k) {
        value[k] = hn::ConvertTo(d, hn::ShiftRightSame(taps[k], 8 * c) & hn::Set(di, 255));
      }
      const auto above = value[0] + wx * (value[1] - value[0]);
      const auto below = value[2] + wx * (value[3] - value[2]);
      const auto sum = above + wy * (below - above);
      hn::StoreU(sum * hn::Set(d, 1.0f / 255.0f), d, job.out + static_cast<size_t>(c) * job.count + i);
    }
  }
}

template <Storage kStorage, bool kPrefetch>
LayoutLoop LoopOfFetch(Fetch fetch) {
  return fetch == Fetch::kWords   ? Loop<kStorage, Fetch::kWords, kPrefetch>
         : fetch == Fetch::kPairs ? Loop<kStorage, Fetch::kPairs, kPrefetch>
                                  : Loop<Storage::kLinear, Fetch::kRows, kPrefetch>;
}

template <bool kPrefetch>
LayoutLoop LoopOfStorage(Storage storage, Fetch fetch) {
  switch (storage) {
    case Storage::kTiles4: return LoopOfFetch<Storage::kTiles4, kPrefetch>(fetch);
    case Storage::kTiles8: return LoopOfFetch<Storage::kTiles8, kPrefetch>(fetch);
    case Storage::kMorton: return LoopOfFetch<Storage::kMorton, kPrefetch>(fetch);
    default: return LoopOfFetch<Storage::kLinear, kPrefetch>(fetch);
  }
}

LayoutLoop FindLoop(Storage storage, Fetch fetch, bool prefetch) {
  return prefetch ? LoopOfStorage<true>(storage, fetch) : LoopOfStorage<false>(storage, fetch);
}

}  // namespace shd::bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::bench {
HWY_EXPORT(FindLoop);
namespace {

uint32_t spread(uint32_t x) {
  uint32_t sum = 0;
  for (uint32_t bit = 0; bit < 16; ++bit) sum |= (x >> bit & 1) << 2 * bit;
  return sum;
}

size_t index_of(Storage storage, uint32_t x, uint32_t y, uint32_t edge) {
  const auto tiled = [&](uint32_t t) {
    return (size_t{y / t} * (edge / t) + x / t) * t * t + size_t{y % t} * t + x % t;
  };
  return storage == Storage::kTiles4   ? tiled(4)
         : storage == Storage::kTiles8 ? tiled(8)
         : storage == Storage::kMorton ? spread(x) | spread(y) << 1
                                       : size_t{y} * edge + x;
}

/// Texels whose value is their position, in one of the orders; the latest set is kept. The last pair reads one word
/// beyond the end.
const std::vector<uint32_t>& texels_of(Storage storage, uint32_t edge) {
  static std::vector<uint32_t> texels;
  static size_t key = 0;
  const size_t wanted = edge * 8 + static_cast<size_t>(storage);
  if (key == wanted) return texels;
  key = wanted;
  texels.assign(size_t{edge} * edge + 1, 0);
  for (uint32_t y = 0; y < edge; ++y) {
    for (uint32_t x = 0; x < edge; ++x) texels[index_of(storage, x, y, edge)] = x * 2654435761u + y * 40503u;
  }
  return texels;
}

Lookups make_lookups(const std::string& pattern, uint32_t edge) {
  const bool on_floor = pattern.rfind("floor", 0) == 0;
  Lookups q = on_floor ? floor_lookups(Floor::of_texture(edge)) : random_lookups(edge, 1.0f);
  if (pattern == "floor45") {
    for (size_t i = 0; i < q.count(); ++i) {
      const float u = q.u[i], v = q.v[i];
      q.u[i] = 0.70710678f * (u - v);
      q.v[i] = 0.70710678f * (u + v);
    }
  }
  if (pattern == "sorted") {
    std::vector<std::pair<uint32_t, size_t>> order;
    const auto texel = [&](float coordinate) { return static_cast<uint32_t>(coordinate * static_cast<float>(edge)); };
    for (size_t i = 0; i < q.count(); ++i) order.emplace_back(spread(texel(q.u[i])) | spread(texel(q.v[i])) << 1, i);
    std::sort(order.begin(), order.end());
    const Lookups unsorted = q;
    for (size_t i = 0; i < q.count(); ++i) {
      q.u[i] = unsorted.u[order[i].second];
      q.v[i] = unsorted.v[order[i].second];
    }
  }
  return q;
}

void run(benchmark::State& state, Storage storage, Fetch fetch, bool prefetch, const std::string& pattern,
         int log2_edge) {
  static std::map<std::string, Lookups> cache;
  const uint32_t edge = 1u << log2_edge;
  Lookups& q = cache[pattern + std::to_string(edge)];
  if (q.u.empty()) q = make_lookups(pattern, edge);
  std::vector<float> out(4 * q.count());
  const LayoutJob job = {texels_of(storage, edge).data(), log2_edge, q.u.data(), q.v.data(), q.count(), out.data()};
  const LayoutLoop loop = HWY_DYNAMIC_DISPATCH(FindLoop)(storage, fetch, prefetch);
  loop(job);
  for (auto _ : state) loop(job);
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(q.count()));
  double sum = 0.0;
  for (const float value : out) sum += static_cast<double>(value);
  state.counters["sum"] = sum;  // equal for all storages and fetches
}

}  // namespace
}  // namespace shd::bench

int main(int argc, char** argv) {
  using namespace shd::bench;
  constexpr const char* kStorages[] = {"linear", "tiles4x4", "tiles8x8", "morton"};
  constexpr const char* kFetches[] = {"words", "pairs", "rows", "words_prefetch", "pairs_prefetch", "rows_prefetch"};
  for (const int log2_edge : {11, 13}) {
    for (int s = 0; s < 4; ++s) {
      for (const char* pattern : {"floor", "floor45", "random", "sorted"}) {
        for (int f = 0; f < 6; ++f) {
          if (f % 3 == 2 && s != 0) continue;  // only linear storage has rows
          const std::string name = std::string("layout/") + kStorages[s] + "/" + kFetches[f] + "/" + pattern +
                                   "/edge:" + std::to_string(1 << log2_edge);
          benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
            run(state, static_cast<Storage>(s), static_cast<Fetch>(f % 3), f >= 3, pattern, log2_edge);
          })->Unit(benchmark::kMillisecond);
        }
      }
    }
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
#endif
