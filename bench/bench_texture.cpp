// SPDX-License-Identifier: MIT
// texture/<filter>/<format>/<target or peer>/<floor or random>/edge:<texels>: one lookup a pixel of a 1024 x 1024
// frame, from one thread. The floor has analytic derivatives; random lookups have a footprint of 1.5 texels.
#include <cmath>
#include <cstring>
#include <map>
#include <memory>

#include "bench.h"
#include "peers/peers.h"
#include "workload.h"

namespace shd::bench {
namespace {

struct Filter {
  const char* name;
  shd_filter filter;
};
constexpr Filter kFilters[] = {
    {"nearest", SHD_FILTER_NEAREST}, {"bilinear", SHD_FILTER_BILINEAR}, {"trilinear", SHD_FILTER_TRILINEAR}};

struct Format {
  const char* name;
  shd_format format;
  int channels;
};
constexpr Format kFormats[] = {{"r8", SHD_FORMAT_R8, 1},
                               {"rgba8", SHD_FORMAT_RGBA8, 4},
                               {"rgba8_srgb", SHD_FORMAT_RGBA8_SRGB, 4},
                               {"rgba16f", SHD_FORMAT_RGBA16F, 4},
                               {"rgba32f", SHD_FORMAT_RGBA32F, 4}};
constexpr Format kPeerFormat = kFormats[1];
constexpr uint32_t kEdges[] = {64, 2048};
constexpr const char* kPatterns[] = {"floor", "random"};

std::string row_name(const char* filter, const char* format, const std::string& who, const std::string& pattern,
                     uint32_t edge) {
  return std::string("texture/") + filter + "/" + format + "/" + who + "/" + pattern + "/edge:" + std::to_string(edge);
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

/// binary16 of a value in [0, 1] that is 0 or at least 2^-14, rounded to nearest.
uint16_t to_half(float value) {
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return value == 0.0f ? 0 : static_cast<uint16_t>((bits - (112u << 23) + 0x1000u) >> 13);
}

std::vector<uint8_t> convert(const std::vector<uint8_t>& rgba, const Format& format) {
  if (format.format == SHD_FORMAT_RGBA8 || format.format == SHD_FORMAT_RGBA8_SRGB) return rgba;
  const size_t size = shd_format_size(format.format) / static_cast<size_t>(format.channels);
  const size_t step = 4 / static_cast<size_t>(format.channels);
  std::vector<uint8_t> texels(rgba.size() / step * size);
  for (size_t i = 0; i < rgba.size() / step; ++i) {
    const float value = static_cast<float>(rgba[i * step]) / 255.0f;
    const uint16_t half = to_half(value);
    const void* source = size == 1   ? static_cast<const void*>(&rgba[i * step])
                         : size == 2 ? &half
                                     : static_cast<const void*>(&value);
    std::memcpy(&texels[i * size], source, size);
  }
  return texels;
}

/// Texture and sampler of one row; the last texture is kept, since the runner calls a row several times.
struct Sampled {
  shd_context* context = nullptr;
  shd_texture* texture = nullptr;
  std::string key;
};

shd_texture* texture_of(const Target& target, const Format& format, uint32_t edge) {
  static Sampled last;
  const std::string key = target.name + format.name + std::to_string(edge);
  if (last.key == key) return last.texture;
  shd_texture_release(last.texture);
  shd_context_release(last.context);
  last = {make_context(target.simd), nullptr, key};
  const std::vector<uint8_t> texels = convert(rgba8(edge), format);
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = format.format;
  desc.width = desc.height = edge;
  desc.texels = texels.data();
  desc.tables = SHD_TABLE_MIPMAP;
  check(shd_texture_create(last.context, &desc, &last.texture));
  return last.texture;
}

shd_lookups columns_of(const Lookups& q, shd_filter filter) {
  shd_lookups columns = shd_lookups_default();
  columns.count = kLookupCount;
  columns.u.data = q.u.data();
  columns.v.data = q.v.data();
  if (filter != SHD_FILTER_TRILINEAR) return columns;
  columns.dudx.data = q.dudx.data();
  columns.dvdx.data = q.dvdx.data();
  columns.dudy.data = q.dudy.data();
  columns.dvdy.data = q.dvdy.data();
  return columns;
}

/// What shd gives for the workload, as RGBA rows, to compare a peer's picture with.
std::vector<float> reference_image(shd_filter filter, const std::string& pattern, uint32_t edge) {
  shd_context* context = make_context(SHD_SIMD_BEST);
  shd_texture* texture = texture_of({SHD_SIMD_BEST, "best"}, kPeerFormat, edge);
  shd_sampler* sampler = nullptr;
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = filter;
  check(shd_sampler_create(context, &desc, &sampler));
  std::vector<float> image(kLookupCount * 4);
  const shd_lookups columns = columns_of(lookups(pattern, edge), filter);
  shd_texels out = {};
  for (int c = 0; c < 4; ++c) out.channel[c] = {&image[static_cast<size_t>(c)], 4 * sizeof(float)};
  check(shd_texture_sample(texture, sampler, &columns, &out));
  shd_sampler_release(sampler);
  shd_context_release(context);
  return image;
}

void run_shd(benchmark::State& state, const Target& target, const Filter& filter, const Format& format,
             const std::string& pattern, uint32_t edge) {
  shd_texture* texture = texture_of(target, format, edge);
  shd_context* context = make_context(target.simd);
  shd_sampler* sampler = nullptr;
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = filter.filter;
  check(shd_sampler_create(context, &desc, &sampler));
  const shd_lookups columns = columns_of(lookups(pattern, edge), filter.filter);
  std::vector<float> channels[4];
  shd_texels out = {};
  for (int c = 0; c < format.channels; ++c) {
    channels[c].resize(kLookupCount);
    out.channel[c].data = channels[c].data();
  }
  const Stopwatch watch;
  for (auto _ : state) check(shd_texture_sample(texture, sampler, &columns, &out));
  const double rate = watch.items_per_second(static_cast<double>(state.iterations()) * kLookupCount);
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(kLookupCount));
  for (const char* peer : {"llvmpipe", "openimageio"}) {
    const double other = recorded_rate(row_name(filter.name, format.name, peer, pattern, edge));
    if (other > 0.0) state.counters[std::string("ratio_") + peer] = rate / other;
  }
  shd_sampler_release(sampler);
  shd_context_release(context);
}

[[maybe_unused]] void run_peer(benchmark::State& state, const std::string& peer, const Filter& filter,
                               const std::string& pattern, uint32_t edge) {
  std::unique_ptr<Peer> pass;
#ifdef SHD_BENCH_OSMESA
  if (peer == "llvmpipe") pass = make_llvmpipe_floor(Floor::of_texture(edge), edge, rgba8(edge), filter.filter);
#endif
#ifdef SHD_BENCH_OIIO
  if (peer == "openimageio") pass = make_openimageio(lookups(pattern, edge), edge, rgba8(edge), filter.filter);
#endif
  pass->run();
  const Stopwatch watch;
  for (auto _ : state) pass->run();
  const double rate = watch.items_per_second(static_cast<double>(state.iterations()) * kLookupCount);
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(kLookupCount));
  const std::string row = row_name(filter.name, kPeerFormat.name, peer, pattern, edge);
  record_rate(row, rate);
  const std::vector<float> ours = reference_image(filter.filter, pattern, edge), theirs = pass->image();
  const Difference difference = compare(ours, theirs);
  state.counters["mean_difference"] = difference.mean;
  state.counters["max_difference"] = difference.max;
  if (pattern == "floor") {
    maybe_write(std::string("floor-") + filter.name + "-" + std::to_string(edge) + "-" + peer, theirs);
    maybe_write(std::string("floor-") + filter.name + "-" + std::to_string(edge) + "-shd", ours);
  }
}

template <class Body>
void add(const std::string& name, Body body) {
  benchmark::RegisterBenchmark(name.c_str(), body)->Unit(benchmark::kMillisecond);
}

/// body(filter, pattern, edge) for every combination.
template <class Body>
void for_each_workload(Body body) {
  for (const Filter& filter : kFilters) {
    for (const char* pattern : kPatterns) {
      for (const uint32_t edge : kEdges) body(filter, std::string(pattern), edge);
    }
  }
}

}  // namespace

void register_texture_peers() {
#if defined(SHD_BENCH_OSMESA) || defined(SHD_BENCH_OIIO)
  const auto add_peer = [](const char* peer, const Filter& filter, const std::string& pattern, uint32_t edge) {
    add(row_name(filter.name, kPeerFormat.name, peer, pattern, edge),
        [=](benchmark::State& state) { run_peer(state, peer, filter, pattern, edge); });
  };
  for_each_workload([&](const Filter& filter, const std::string& pattern, uint32_t edge) {
#ifdef SHD_BENCH_OSMESA
    if (pattern == "floor") add_peer("llvmpipe", filter, pattern, edge);
#endif
#ifdef SHD_BENCH_OIIO
    add_peer("openimageio", filter, pattern, edge);
#endif
  });
#endif
}

void register_texture() {
  for (const Format& format : kFormats) {
    for (const Target& target : targets()) {
      for_each_workload([&](const Filter& filter, const std::string& pattern, uint32_t edge) {
        add(row_name(filter.name, format.name, target.name, pattern, edge),
            [=](benchmark::State& state) { run_shd(state, target, filter, format, pattern, edge); });
      });
    }
  }
}

}  // namespace shd::bench
