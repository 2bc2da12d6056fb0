// SPDX-License-Identifier: MIT
// tiles/{cold,ssd}/<filter>/<who>/<file>/<pattern>/edge:8192: a frame of lookups in a tiled file that is not in memory.
// An iteration opens the file with a new cache and filters the frame. The pages of the file are in memory for `cold`,
// and dropped before each iteration for `ssd`. Time is wall time on one thread, and median_ms is its median. Rows of
// shd alternate with OpenImageIO; ratio_openimageio is the median time of OpenImageIO by that of shd. Both filter
// the same levels (SHD_PROFILE_OIIO), and a tile of the cache is a tile of the file.
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <map>
#include <memory>
#include <stdexcept>

#include <shd/tile_file.h>

#include "peers/cold.h"
#include "texture_setup.h"

namespace shd::bench {
namespace {

constexpr uint32_t kEdge = 8192;
constexpr uint64_t kBudget = uint64_t{1} << 28;
/// Largest mean difference of SHD_PROFILE_OIIO from OpenImageIO: half a code of 8 bits.
constexpr double kMaxMeanDifference = 0.5 / 255.0;

struct Row {
  bool drop_pages;
  std::string filter, extension, pattern;

  bool is_trilinear() const { return filter == "trilinear"; }
  PeerFilter peer() const { return is_trilinear() ? PeerFilter::kTrilinear : PeerFilter::kAnisotropic16; }
  std::string name(const std::string& who) const {
    return std::string("tiles/") + (drop_pages ? "ssd/" : "cold/") + filter + "/" + who + "/" +
           (extension == "exr" ? "exr/" : "tiff/") + pattern + "/edge:" + std::to_string(kEdge);
  }
};

struct Run {
  double seconds, megabytes;
  std::vector<float> rgba;
};

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

const std::string& path_of(const std::string& extension) {
  static std::map<std::string, std::unique_ptr<TiledFile>> files;
  std::unique_ptr<TiledFile>& file = files[extension];
  if (!file) file = std::make_unique<TiledFile>(extension, kEdge, make_rgba8(kEdge));
  return file->path();
}

/// The floor of a frame, or one in 16 of its pixels along both axes.
const Lookups& lookups_of(const std::string& pattern) {
  static std::map<std::string, Lookups> cache;
  Lookups& q = cache[pattern];
  if (!q.u.empty()) return q;
  const Lookups floor = floor_lookups(Floor::of_texture(kEdge));
  if (pattern == "floor") return q = floor;
  const auto thin = [](const std::vector<float>& all) {
    std::vector<float> some;
    for (size_t y = 8; y < kFrameEdge; y += 16) {
      for (size_t x = 8; x < kFrameEdge; x += 16) some.push_back(all[y * kFrameEdge + x]);
    }
    return some;
  };
  q.u = thin(floor.u), q.v = thin(floor.v);
  q.dudx = thin(floor.dudx), q.dvdx = thin(floor.dvdx);
  q.dudy = thin(floor.dudy), q.dvdy = thin(floor.dvdy);
  return q;
}

/// Share of the pages of a file that are in memory.
double resident_share(int descriptor, size_t bytes) {
  const size_t page = static_cast<size_t>(sysconf(_SC_PAGESIZE));
  void* const map = mmap(nullptr, bytes, PROT_READ, MAP_SHARED, descriptor, 0);
  if (map == MAP_FAILED) throw std::runtime_error("mmap of the file failed");
  std::vector<unsigned char> pages((bytes + page - 1) / page);
  const int failed = mincore(map, bytes, pages.data());
  munmap(map, bytes);
  if (failed) throw std::runtime_error("mincore of the file failed");
  const auto in_memory = std::count_if(pages.begin(), pages.end(), [](unsigned char flags) { return flags & 1; });
  return static_cast<double>(in_memory) / static_cast<double>(pages.size());
}

/// Drops the pages of a file. A folder in memory keeps them, which is an error.
void drop_pages(const std::string& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw std::runtime_error("cannot open " + path);
  fdatasync(descriptor);
  posix_fadvise(descriptor, 0, 0, POSIX_FADV_DONTNEED);
  const double share = resident_share(descriptor, static_cast<size_t>(lseek(descriptor, 0, SEEK_END)));
  close(descriptor);
  if (share > 0.01) throw std::runtime_error("the pages of " + path + " stay in memory");
}

Run run_openimageio(const Row& row) {
  const Lookups& q = lookups_of(row.pattern);
  Run run = {0.0, 0.0, std::vector<float>(4 * q.count())};
  if (row.drop_pages) drop_pages(path_of(row.extension));
  const auto start = Clock::now();
  ColdOpenImageIO peer(path_of(row.extension), static_cast<double>(kBudget >> 20));
  peer.run(q, row.peer(), &run.rgba);
  run.seconds = since(start);
  run.megabytes = peer.megabytes();
  return run;
}

shd_sampler* make_sampler(shd_context* context, const Row& row) {
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = row.is_trilinear() ? SHD_FILTER_TRILINEAR : SHD_FILTER_ANISOTROPIC;
  desc.profile = SHD_PROFILE_OIIO;
  shd_sampler* sampler = nullptr;
  check(shd_sampler_create(context, &desc, &sampler));
  return sampler;
}

double megabytes_of(const shd_tile_cache* cache) {
  shd_tile_cache_stats stats = shd_tile_cache_stats_default();
  check(shd_tile_cache_get_stats(cache, &stats));
  return static_cast<double>(stats.loaded_tile_count * stats.tile_bytes) / (1 << 20);
}

Run run_shd(shd_context* context, const Row& row) {
  const Lookups& q = lookups_of(row.pattern);
  Run run = {0.0, 0.0, std::vector<float>(4 * q.count())};
  if (row.drop_pages) drop_pages(path_of(row.extension));
  const auto start = Clock::now();
  shd_sampler* const sampler = make_sampler(context, row);
  shd_tile_cache_desc cache_desc = shd_tile_cache_desc_default();
  cache_desc.budget_bytes = kBudget;
  cache_desc.tile_bytes = kFileTile * kFileTile * 4 * (row.extension == "exr" ? 2 : 1);
  shd_tile_file_desc desc = shd_tile_file_desc_default();
  check(shd_tile_cache_create(context, &cache_desc, &desc.cache));
  desc.encoding = SHD_COLOR_ENCODING_DATA;
  shd_texture* texture = nullptr;
  check(shd_texture_open(context, path_of(row.extension).c_str(), &desc, &texture, nullptr));
  shd_lookups columns = shd_lookups_default();
  columns.count = q.count();
  columns.u.data = q.u.data(), columns.v.data = q.v.data();
  columns.dudx.data = q.dudx.data(), columns.dvdx.data = q.dvdx.data();
  columns.dudy.data = q.dudy.data(), columns.dvdy.data = q.dvdy.data();
  shd_texels out = {};
  for (size_t c = 0; c < 4; ++c) out.channel[c] = {&run.rgba[c], 4 * sizeof(float)};
  check(shd_texture_sample(texture, sampler, &columns, &out));
  run.seconds = since(start);
  run.megabytes = megabytes_of(desc.cache);
  shd_texture_release(texture);
  shd_tile_cache_release(desc.cache);
  shd_sampler_release(sampler);
  return run;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

void measure_openimageio(benchmark::State& state, const Row& row) {
  std::vector<double> times;
  Run run = run_openimageio(row);  // its pages are in memory now
  for (auto _ : state) {
    run = run_openimageio(row);
    times.push_back(run.seconds);
    state.SetIterationTime(run.seconds);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(lookups_of(row.pattern).count()));
  state.counters["median_ms"] = 1e3 * median(times);
  state.counters["read_mb"] = run.megabytes;
}

void measure_shd(benchmark::State& state, const Row& row, const Target& target) {
  shd_context* const raw = make_context(target.simd);
  const std::unique_ptr<shd_context, void (*)(shd_context*)> context(raw, shd_context_release);
  const Difference difference = compare(run_shd(context.get(), row).rgba, run_openimageio(row).rgba);
  state.counters["mean_difference"] = difference.mean;
  state.counters["max_difference"] = difference.max;
  if (!(difference.mean <= kMaxMeanDifference)) throw std::runtime_error("the picture differs from OpenImageIO's");
  std::vector<double> ours, theirs;
  Run run = run_shd(context.get(), row);
  for (auto _ : state) {
    run = run_shd(context.get(), row);
    ours.push_back(run.seconds);
    state.SetIterationTime(run.seconds);
    theirs.push_back(run_openimageio(row).seconds);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(lookups_of(row.pattern).count()));
  state.counters["median_ms"] = 1e3 * median(ours);
  state.counters["ratio_openimageio"] = median(theirs) / median(ours);
  state.counters["read_mb"] = run.megabytes;
}

template <class Body>
void add(const std::string& name, Body body) {
  const auto run = [=](benchmark::State& state) {
    try {
      body(state);
    } catch (const std::exception& e) {
      state.SkipWithError(e.what());
    }
  };
  benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond)->UseManualTime();
}

void add_rows(const Row& row) {
  const Target best = targets().back();
  add(row.name("openimageio"), [=](benchmark::State& state) { measure_openimageio(state, row); });
  add(row.name(best.name), [=](benchmark::State& state) { measure_shd(state, row, best); });
}

}  // namespace

void register_tiles() {
  for (const bool drop_pages : {false, true}) {
    for (const char* filter : {"trilinear", "anisotropic"}) {
      for (const char* extension : {"tif", "exr"}) {
        for (const char* pattern : {"floor", "sparse"}) add_rows({drop_pages, filter, extension, pattern});
      }
    }
  }
}

}  // namespace shd::bench
