// SPDX-License-Identifier: MIT
// create/<format>/edge:<texels> and mipmap/<format>/edge:<texels>: shd_texture_create without tables, and with a
// mipmap; mipmap_ms is the time of the second minus the time of the first.
// update/<format>/edge:<texels>: shd_texture_update of 64 x 64 texels, with the mipmap, after the first update.
#include <algorithm>

#include "texture_setup.h"

namespace shd::bench {
namespace {

constexpr uint32_t kEdge = 8192;

/// A small image repeated over a large one.
std::vector<uint8_t> make_tiled(const Format& format) {
  constexpr uint32_t kTile = 1024;
  const std::vector<uint8_t> tile = convert(make_rgba8(kTile), format);
  const size_t row = tile.size() / kTile;
  std::vector<uint8_t> texels;
  texels.reserve(size_t{kEdge / kTile} * row * kEdge);
  for (uint32_t y = 0; y < kEdge; ++y) {
    const auto begin = tile.begin() + static_cast<std::ptrdiff_t>(y % kTile * row);
    for (uint32_t x = 0; x < kEdge; x += kTile) {
      texels.insert(texels.end(), begin, begin + static_cast<std::ptrdiff_t>(row));
    }
  }
  return texels;
}

std::string row_name(const char* what, const Format& format) {
  return std::string(what) + "/" + format.name + "/edge:" + std::to_string(kEdge);
}

void run(benchmark::State& state, const Format& format, uint32_t tables) {
  const std::vector<uint8_t> texels = make_tiled(format);
  shd_context* context = make_context(SHD_SIMD_BEST);
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = format.format;
  desc.width = desc.height = kEdge;
  desc.texels = texels.data();
  desc.tables = tables;
  const auto create = [&] {
    shd_texture* texture = nullptr;
    check(shd_texture_create(context, &desc, &texture));
    shd_texture_release(texture);
  };
  create();  // a virtual machine provides memory slowly the first time
  const Stopwatch watch;
  for (auto _ : state) create();
  const double rate = watch.items_per_second(static_cast<double>(state.iterations()));
  state.SetItemsProcessed(state.iterations() * kEdge * kEdge);
  if (tables == SHD_TABLE_NONE) record_rate(row_name("create", format), rate);
  const double plain = recorded_rate(row_name("create", format));
  if (tables != SHD_TABLE_NONE && plain > 0.0) state.counters["mipmap_ms"] = 1000.0 / rate - 1000.0 / plain;
  shd_context_release(context);
}

void run_update(benchmark::State& state, const Format& format) {
  constexpr uint32_t kPatch = 64;
  const std::vector<uint8_t> texels = make_tiled(format);
  shd_context* context = make_context(SHD_SIMD_BEST);
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = format.format;
  desc.width = desc.height = kEdge;
  desc.texels = texels.data();
  desc.tables = SHD_TABLE_MIPMAP;
  shd_texture* texture = nullptr;
  check(shd_texture_create(context, &desc, &texture));
  std::vector<uint8_t> patch(kPatch * kPatch * shd_format_size(format.format));
  shd_image image = shd_image_default();
  image.format = format.format;
  image.width = image.height = kPatch;
  image.pixels = patch.data();
  check(shd_texture_update(texture, 0, 0, 0, &image));
  uint32_t random = 1;
  for (auto _ : state) {
    random = random * 1664525u + 1013904223u;
    check(shd_texture_update(texture, 0, (random >> 19) % (kEdge - kPatch), (random >> 6) % (kEdge - kPatch), &image));
  }
  state.SetItemsProcessed(state.iterations() * kPatch * kPatch);
  shd_texture_release(texture);
  shd_context_release(context);
}

}  // namespace

void register_texture_create() {
  for (const Format& format : kFormats) {
    for (const uint32_t tables : {SHD_TABLE_NONE, SHD_TABLE_MIPMAP}) {
      benchmark::RegisterBenchmark(row_name(tables == SHD_TABLE_NONE ? "create" : "mipmap", format).c_str(),
                                   [=](benchmark::State& state) { run(state, format, tables); })
          ->Unit(benchmark::kMillisecond);
    }
    benchmark::RegisterBenchmark(row_name("update", format).c_str(), [=](benchmark::State& state) {
      run_update(state, format);
    })->Unit(benchmark::kMicrosecond);
  }
}

}  // namespace shd::bench
