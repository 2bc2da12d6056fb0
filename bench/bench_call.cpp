// SPDX-License-Identifier: MIT
// call/<filter>/<target>/count:{1,4,16,64}: calls of a few lookups at random places of a 64 x 64 RGBA8 texture, whose
// texels stay in the caches: the cost of a call. over_one is the time of a call by that of one lookup.
// call/<filter>/openimageio: the same lookups, one call each; ratio_openimageio is shd's rate of lookups over it.
#include <memory>

#include "texture_setup.h"

namespace shd::bench {
namespace {

constexpr uint32_t kEdge = 64;
constexpr size_t kCounts[] = {1, 4, 16, 64};
constexpr size_t kLookups = 4096;  // in one pass

bool is_measured(const Filter& filter) {
  switch (filter.filter) {
    case SHD_FILTER_BILINEAR:
    case SHD_FILTER_TRILINEAR:
    case SHD_FILTER_ANISOTROPIC:
    case SHD_FILTER_EWA: return filter.profile == SHD_PROFILE_LEAST_ERROR;
    default: return false;
  }
}

std::string row_name(const std::string& filter, const std::string& who) {
  return "call/" + filter + "/" + who;
}

const std::vector<uint8_t>& texels() {
  static const std::vector<uint8_t> all = make_rgba8(kEdge);
  return all;
}

const Lookups& lookups() {
  static const Lookups all = [] {
    Lookups q = random_lookups(kEdge, 1.5f);
    for (std::vector<float>* column : {&q.u, &q.v, &q.dudx, &q.dvdx, &q.dudy, &q.dvdy}) column->resize(kLookups);
    return q;
  }();
  return all;
}

/// The columns from `first` on.
shd_lookups part(const shd_lookups& whole, size_t first, size_t count) {
  shd_lookups some = whole;
  some.count = count;
  for (shd_f32_in* column : {&some.u, &some.v, &some.dudx, &some.dvdx, &some.dudy, &some.dvdy}) {
    if (column->data) column->data += first;
  }
  return some;
}

void run_shd(benchmark::State& state, const Target& target, const Filter& filter, size_t count) {
  const Sampling sampling(target.simd, filter, kRgba8, kEdge, texels());
  const shd_lookups whole = columns_of(lookups(), filter);
  std::vector<float> channels[4];
  shd_texels out = {};
  for (int c = 0; c < 4; ++c) {
    channels[c].resize(count);
    out.channel[c].data = channels[c].data();
  }
  const Stopwatch watch;
  for (auto _ : state) {
    for (size_t first = 0; first < kLookups; first += count) sampling.run(part(whole, first, count), &out);
  }
  const double rate = watch.items_per_second(static_cast<double>(state.iterations()) * kLookups);
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(kLookups));
  state.counters["ns_per_call"] = 1e9 * static_cast<double>(count) / rate;
  const std::string one = row_name(filter.name, target.name);
  if (count == 1) record_rate(one, rate);
  const double of_one = recorded_rate(one);
  if (of_one > 0.0) state.counters["over_one"] = static_cast<double>(count) * of_one / rate;
  const double other = recorded_rate(row_name(filter.peer_row, "openimageio"));
  if (other > 0.0) state.counters["ratio_openimageio"] = rate / other;
}

#ifdef SHD_BENCH_OIIO
void run_openimageio(benchmark::State& state, const Filter& filter) {
  const std::unique_ptr<Peer> pass = make_openimageio(lookups(), kEdge, texels(), filter.peer);
  pass->run();
  const Stopwatch watch;
  for (auto _ : state) pass->run();
  const double rate = watch.items_per_second(static_cast<double>(state.iterations()) * kLookups);
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(kLookups));
  state.counters["ns_per_call"] = 1e9 / rate;
  record_rate(row_name(filter.name, "openimageio"), rate);
}
#endif

}  // namespace

void register_calls() {
  for (const Filter& filter : kFilters) {
    if (!is_measured(filter)) continue;
#ifdef SHD_BENCH_OIIO
    if (has_own_peers(filter)) {
      benchmark::RegisterBenchmark(row_name(filter.name, "openimageio").c_str(),
                                   [&filter](benchmark::State& state) { run_openimageio(state, filter); });
    }
#endif
    for (const Target& target : targets()) {
      for (const size_t count : kCounts) {
        benchmark::RegisterBenchmark(
            (row_name(filter.name, target.name) + "/count:" + std::to_string(count)).c_str(),
            [&filter, target, count](benchmark::State& state) { run_shd(state, target, filter, count); });
      }
    }
  }
}

}  // namespace shd::bench
