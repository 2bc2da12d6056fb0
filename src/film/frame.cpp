// SPDX-License-Identifier: MIT
#include "film/frame.h"

#include <atomic>
#include <mutex>

#include "core/executor.h"
#include "film/scene.h"
#include "film/tile_writer.h"
#include "raster/coverage.h"
#include "raster/fragments.h"
#include "shade/run.h"

namespace shd::film {
namespace {

/// Everything one worker needs, made when it takes its first tile.
struct Worker {
  raster::Tile tile;
  raster::TileOrder order;
  core::Buffer<const geometry::ScreenTriangle*> slots;  // triangles of the tile in order
  shade::Workspace workspace;
  uint64_t fragments = 0, nonfinite_fragments = 0;
};

/// Workers by index; owns them.
class Workers {
 public:
  explicit Workers(const core::Context& context)
      : context_(context), workers_(context.allocator, context.executor.worker_count) {
    for (Worker*& worker : workers_) worker = nullptr;
  }
  ~Workers() {
    for (Worker* worker : workers_) core::destroy(context_.allocator, worker);
  }
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Throws std::bad_alloc.
  Worker& get(uint32_t index) {
    if (!workers_[index]) {
      Worker* worker = core::create<Worker>(context_.allocator);
      workers_[index] = worker;
      worker->order.start.attach(context_.allocator);
      worker->slots.attach(context_.allocator);
      shade::allocate(context_.allocator, &worker->workspace);
    }
    return *workers_[index];
  }
  void count(shd_render_stats* stats) const {
    for (size_t i = 0; i < workers_.size(); ++i) {
      if (!workers_[i]) continue;
      stats->fragments += workers_[i]->fragments;
      stats->nonfinite_fragments += workers_[i]->nonfinite_fragments;
    }
  }

 private:
  const core::Context& context_;
  core::Array<Worker*> workers_;
};

/// Reports finished tiles to the host, one call at a time, and carries its wish to stop.
class Progress {
 public:
  Progress(const shd_progress& callback, uint32_t total) : callback_(callback), total_(total) {}

  /// Throws Failure once the host has cancelled.
  void step() {
    if (!callback_.report) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    ++done_;
    if (!cancelled_) {
      cancelled_ = callback_.report(callback_.user_data, static_cast<float>(done_) / static_cast<float>(total_)) != 0;
    }
    if (cancelled_) throw core::Failure(core::fail(SHD_ERROR_CANCELLED, "render.progress: cancelled by the host"));
  }

 private:
  const shd_progress& callback_;
  const uint32_t total_;
  std::mutex mutex_;
  uint32_t done_ = 0;
  bool cancelled_ = false;
};

/// Draws the tiles of one frame.
struct TileRenderer {
  const core::Context& context;
  const Frame& frame;
  const Scene& scene;
  const shade::LightTable& lights;

  void cover_tile(uint32_t index, const TileArea& area, Worker* worker) const {
    worker->slots.clear();
    for (uint32_t g = 0; g < scene.bins.group_count; ++g) {
      const raster::BinSegment segment = raster::segment(scene.bins, index, g);
      const geometry::ScreenTriangle* triangles = scene.groups[g].data();
      const auto first_slot = static_cast<uint32_t>(worker->slots.size());
      for (size_t i = 0; i < segment.count; ++i) worker->slots.push_back(triangles + segment.entries[i]);
      raster::cover(context.simd, triangles, segment.entries, segment.count, first_slot,
                    static_cast<int32_t>(area.left), static_cast<int32_t>(area.top), &worker->tile);
    }
  }

  shade::DrawShading shading_of(uint32_t draw) const {
    const Draw& d = frame.draws[draw];
    return {d.mesh, &scene.vertices[draw], d.material, d.frequency, scene.transforms[draw].orientation, draw};
  }

  void flush(const TileArea& area, uint32_t draw, Worker* worker) const {
    shade::Workspace& workspace = worker->workspace;
    if (workspace.fragments.count == 0) return;
    shade::shade_batch(context.simd, shading_of(draw), lights, frame.view.eye, &workspace);
    worker->fragments += workspace.fragments.count;
    worker->nonfinite_fragments +=
        write_fragments(area, workspace.fragments, workspace.columns.radiance, frame.framebuffer);
    workspace.fragments.count = 0;
  }

  /// Gathers the sorted pixels into batches of one draw each and shades them.
  void shade_tile(const TileArea& area, Worker* worker) const {
    raster::sort_pixels(worker->tile, worker->slots.size(), &worker->order);
    raster::Fragments& f = worker->workspace.fragments;
    f.count = 0;
    uint32_t draw = 0;
    size_t triangles = 0;
    for (size_t slot = 0; slot < worker->slots.size(); ++slot) {
      const size_t begin = worker->order.start[slot], end = worker->order.start[slot + 1];
      if (begin == end) continue;
      const geometry::ScreenTriangle& triangle = *worker->slots[slot];
      if (triangle.draw != draw || triangles == shade::kBatchTriangles) {
        flush(area, draw, worker);
        triangles = 0;
      }
      draw = triangle.draw;
      ++triangles;
      for (size_t i = begin; i < end; ++i) {
        if (f.count == raster::kBatch) {
          flush(area, draw, worker);
          triangles = 1;
        }
        const uint32_t pixel = worker->order.pixel[i];
        f.pixel[f.count] = pixel;
        f.triangle[f.count] = triangle.primitive;
        f.x[f.count] = static_cast<float>(area.left + pixel % raster::kTile) + 0.5f;
        f.y[f.count] = static_cast<float>(area.top + pixel / raster::kTile) + 0.5f;
        f.depth[f.count] = worker->tile.depth[pixel];
        ++f.count;
      }
    }
    flush(area, draw, worker);
  }

  void render_tile(uint32_t index, Worker* worker) const {
    const TileArea area = tile_area(*frame.framebuffer, index, scene.bins.tiles_x);
    if (!frame.keep) clear_tile(area, frame.clear_color, frame.clear_depth, frame.framebuffer);
    load_depth(area, *frame.framebuffer, &worker->tile);
    cover_tile(index, area, worker);
    if (worker->slots.size() == 0) return;
    shade_tile(area, worker);
    store_depth(area, worker->tile, frame.framebuffer);
  }
};

}  // namespace

void render(const core::Context& context, const Frame& frame, shd_render_stats* stats) {
  const shade::LightTable lights = shade::make_light_table(context.allocator, frame.lights, frame.light_count);
  Scene scene(context.allocator, frame);
  prepare(context, frame, &scene, stats);
  const uint32_t tiles = scene.bins.tiles_x * scene.bins.tiles_y;
  Workers workers(context);
  Progress progress(frame.progress, tiles);
  const TileRenderer renderer = {context, frame, scene, lights};
  core::parallel_for(context, tiles, [&](uint32_t index, uint32_t worker) {
    renderer.render_tile(index, &workers.get(worker));
    progress.step();
  });
  workers.count(stats);
}

}  // namespace shd::film
