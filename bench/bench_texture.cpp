// SPDX-License-Identifier: MIT
// texture/<filter>/<format>/<target or peer>/<floor or random>/edge:<texels>: one lookup per pixel of a 1024 x 1024
// frame, from one thread. The floor has analytic derivatives; random lookups have a footprint of 1.5 texels.
#include <exception>
#include <map>
#include <memory>

#include "texture_setup.h"

namespace shd::bench {
namespace {

constexpr uint32_t kEdges[] = {64, 2048};
constexpr const char* kPatterns[] = {"floor", "random"};

std::string row_name(const std::string& filter, const char* format, const std::string& who, const std::string& pattern,
                     uint32_t edge) {
  return "texture/" + filter + "/" + format + "/" + who + "/" + pattern + "/edge:" + std::to_string(edge);
}

const std::vector<uint8_t>& rgba8(uint32_t edge) {
  static std::map<uint32_t, std::vector<uint8_t>> cache;
  std::vector<uint8_t>& texels = cache[edge];
  if (texels.empty()) texels = make_rgba8(edge);
  return texels;
}

const Lookups& lookups(const std::string& pattern, uint32_t edge) {
  static std::map<std::string, Lookups> cache;
  Lookups& q = cache[pattern + std::to_string(edge)];
  if (q.u.empty()) q = pattern == "floor" ? floor_lookups(Floor::of_texture(edge)) : random_lookups(edge, 1.5f);
  return q;
}

/// The objects of one row. The latest ones are kept, because the runner calls a row several times.
const Sampling& sampling_of(const Target& target, const Filter& filter, const Format& format, uint32_t edge) {
  static std::unique_ptr<Sampling> last;
  static std::string last_key;
  const std::string key = target.name + filter.name + format.name + std::to_string(edge);
  if (last_key == key) return *last;
  last.reset();
  last = std::make_unique<Sampling>(target.simd, filter, format, edge, rgba8(edge));
  last_key = key;
  return *last;
}

void run_shd(benchmark::State& state, const Target& target, const Filter& filter, const Format& format,
             const std::string& pattern, uint32_t edge) {
  const Sampling& sampling = sampling_of(target, filter, format, edge);
  const shd_lookups columns = columns_of(lookups(pattern, edge), filter);
  std::vector<float> channels[4];
  shd_texels out = {};
  for (int c = 0; c < format.channels; ++c) {
    channels[c].resize(columns.count);
    out.channel[c].data = channels[c].data();
  }
  const Stopwatch watch;
  for (auto _ : state) sampling.run(columns, &out);
  const double rate = watch.items_per_second(static_cast<double>(state.iterations()) * columns.count);
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(columns.count));
  if (format.name == std::string(kRgba8.name))
    record_rate(row_name(filter.name, kRgba8.name, target.name, pattern, edge), rate);
  const double texels = recorded_rate(row_name(filter.name, kRgba8.name, target.name, pattern, edge));
  const bool is_variant = format.in_tiles || shd_format_block_size(format.format) != 0;
  if (is_variant && texels > 0.0) state.counters["ratio_rgba8"] = rate / texels;
  const char* const peer_format = format.in_tiles ? kRgba8.name : format.name;
  for (const char* peer : {"llvmpipe", "lavapipe", "openimageio", "openimageio_batch"}) {
    const double other = recorded_rate(row_name(filter.peer_row, peer_format, peer, pattern, edge));
    if (other > 0.0) state.counters[std::string("ratio_") + peer] = rate / other;
  }
}

[[maybe_unused]] void run_peer(benchmark::State& state, const std::string& peer, const Filter& filter,
                               const std::string& pattern, uint32_t edge) {
  std::unique_ptr<Peer> pass;
  const Lookups& q = lookups(pattern, edge);
#ifdef SHD_BENCH_OSMESA
  const Surface floor = floor_surface(Floor::of_texture(edge));
  if (peer == "llvmpipe") pass = make_llvmpipe_surface(floor, kFrameEdge, edge, rgba8(edge), filter.peer);
#endif
#ifdef SHD_BENCH_LAVAPIPE
  if (peer == "lavapipe") pass = make_lavapipe(q, edge, rgba8(edge), filter.peer);
#endif
#ifdef SHD_BENCH_OIIO
  if (peer == "openimageio") pass = make_openimageio(q, edge, rgba8(edge), filter.peer);
  if (peer == "openimageio_batch") pass = make_openimageio_batch(q, edge, rgba8(edge), filter.peer);
#endif
  pass->run();
  const Stopwatch watch;
  for (auto _ : state) pass->run();
  const size_t count = kLookupCount * pass->copies();
  const double rate = watch.items_per_second(static_cast<double>(state.iterations()) * static_cast<double>(count));
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(count));
  record_rate(row_name(filter.peer_row, kRgba8.name, peer, pattern, edge), rate);
  const std::vector<float> ours = filtered_image(filter, q, edge, rgba8(edge)), theirs = pass->image();
  const Difference difference = compare(ours, theirs);
  state.counters["mean_difference"] = difference.mean;
  state.counters["max_difference"] = difference.max;
  if (pattern == "floor") {
    maybe_write(std::string("floor-") + filter.name + "-" + std::to_string(edge) + "-" + peer, theirs);
    maybe_write(std::string("floor-") + filter.name + "-" + std::to_string(edge) + "-shd", ours);
  }
}

template <class Body>
benchmark::internal::Benchmark* add(const std::string& name, Body body) {
  return benchmark::RegisterBenchmark(name.c_str(), body)->Unit(benchmark::kMillisecond);
}

/// Calls body(filter, pattern, edge) for every combination.
template <class Body>
void for_each_workload(Body body) {
  for (const Filter& filter : kFilters) {
    for (const char* pattern : kPatterns) {
      for (const uint32_t edge : kEdges) body(filter, std::string(pattern), edge);
    }
  }
}

/// Whether a row of compressed blocks or tiles is run: those whose filter has levels, at the larger size.
bool has_variant_row(const Filter& filter, uint32_t edge) {
  return edge == kEdges[1] && filter.tables == SHD_TABLE_MIPMAP && filter.precision == SHD_PRECISION_FULL &&
         filter.profile == SHD_PROFILE_LEAST_ERROR && filter.filter != SHD_FILTER_EXACT;
}

/// Whether a row is run. Slow and irrelevant rows are left out: all filters run on RGBA8 at the larger size.
bool is_measured(const Filter& filter, const Format& format, uint32_t edge) {
  const bool is_unorm8 = format.format == SHD_FORMAT_R8 || format.format == SHD_FORMAT_RGBA8;
  if (filter.precision == SHD_PRECISION_FAST && !is_unorm8) return false;  // it would be SHD_PRECISION_FULL
  return filter.on_all_formats || (format.format == kRgba8.format && edge == kEdges[1]);
}

}  // namespace

void register_texture_peers() {
#if defined(SHD_BENCH_OSMESA) || defined(SHD_BENCH_LAVAPIPE) || defined(SHD_BENCH_OIIO)
  const auto add_peer = [](const char* peer, const Filter& filter, const std::string& pattern, uint32_t edge) {
    const auto run = [=](benchmark::State& state) {
      try {
        run_peer(state, peer, filter, pattern, edge);
      } catch (const std::exception& e) {
        state.SkipWithError(e.what());
      }
    };
    auto* row = add(row_name(filter.peer_row, kRgba8.name, peer, pattern, edge), run);
    if (peer == std::string("lavapipe")) row->MeasureProcessCPUTime();  // it works on the thread of its queue
  };
  for_each_workload([&](const Filter& filter, const std::string& pattern, uint32_t edge) {
    if (!has_own_peers(filter) || !is_measured(filter, kRgba8, edge)) return;
#ifdef SHD_BENCH_OSMESA
    if (pattern == "floor") add_peer("llvmpipe", filter, pattern, edge);
#endif
#ifdef SHD_BENCH_LAVAPIPE
    if (lavapipe_problem().empty()) add_peer("lavapipe", filter, pattern, edge);
#endif
#ifdef SHD_BENCH_OIIO
    add_peer("openimageio", filter, pattern, edge);
    if (filter.reads_derivatives || filter.filter == SHD_FILTER_BILINEAR) {
      add_peer("openimageio_batch", filter, pattern, edge);
    }
#endif
  });
#endif
}

void register_texture() {
  const auto add_rows = [](const Format& format, auto is_row) {
    for (const Target& target : targets()) {
      for_each_workload([&](const Filter& filter, const std::string& pattern, uint32_t edge) {
        if (!is_row(filter, edge)) return;
        add(row_name(filter.name, format.name, target.name, pattern, edge),
            [=](benchmark::State& state) { run_shd(state, target, filter, format, pattern, edge); });
      });
    }
  };
  for (const Format& format : kFormats) {
    add_rows(format, [&](const Filter& filter, uint32_t edge) { return is_measured(filter, format, edge); });
  }
  for (const Format& format : kBlockFormats) add_rows(format, has_variant_row);
  add_rows(kTiles, has_variant_row);
}

}  // namespace shd::bench
