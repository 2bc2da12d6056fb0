// SPDX-License-Identifier: MIT
// One tile: draws take effect in order. Opaque ones go to the visibility buffer, and what it shows is shaded before a
// draw that must see colours, and at the end; the others are shaded triangle by triangle and blended. Blends without an
// order follow.
#include "film/tile_renderer.h"

#include <algorithm>
#include <cmath>

#include "film/blend.h"
#include "raster/edge.h"

namespace shd::film {
namespace {

/// Neighbouring triangles of a tile's bin that belong to one draw.
struct Run {
  uint32_t draw;
  const geometry::ScreenTriangle* triangles;
  const uint32_t* entries;
  size_t count;
};

bool passes(shd_compare compare, float z, float stored) {
  switch (compare) {
    case SHD_COMPARE_LESS: return z < stored;
    case SHD_COMPARE_LESS_EQUAL: return z <= stored;
    case SHD_COMPARE_EQUAL: return z == stored;
    case SHD_COMPARE_GREATER_EQUAL: return z >= stored;
    case SHD_COMPARE_GREATER: return z > stored;
    case SHD_COMPARE_NOT_EQUAL: return z != stored;
    case SHD_COMPARE_ALWAYS: return true;
    default: return false;
  }
}

/// A comparison that lets pass at least what this one will after depths have changed by it.
shd_compare early_compare(shd_compare compare) {
  return compare == SHD_COMPARE_NOT_EQUAL ? SHD_COMPARE_ALWAYS : compare;
}

/// Whether the visibility buffer alone tells what a draw shows.
bool is_plain(const material::Material& material) {
  return material.blend == SHD_BLEND_OPAQUE && !material::drops_fragments(material);
}

/// Draws one tile.
class TilePass {
 public:
  TilePass(const TileRenderer& renderer, uint32_t index, Worker* worker)
      : r_(renderer),
        framebuffer_(*renderer.frame.framebuffer),
        pattern_(raster::sample_pattern(framebuffer_.samples)),
        index_(index),
        area_(tile_area(framebuffer_, index, renderer.scene.bins.tiles_x)),
        left_(renderer.frame.window.left + static_cast<int32_t>(area_.left)),
        top_(renderer.frame.window.top + static_cast<int32_t>(area_.top)),
        worker_(*worker) {
    for (uint32_t s = 0; s < pattern_.count; ++s) colors_[s] = sample_color(s);
  }

  void run() {
    if (!r_.frame.keep) clear();
    if (is_bare()) return;
    load_depth(area_, framebuffer_, &worker_.tile);
    if (pattern_.count > 1) load_color(area_, framebuffer_, pattern_.count, worker_.color.data());
    worker_.slots.clear();
    bool weighted = false, sorted = false;
    for_each_run([&](const Run& run) {
      const material::Material* material = draw_of(run).material;
      if (material && material::is_unordered(*material)) {
        (material->blend == SHD_BLEND_WEIGHTED ? weighted : sorted) = true;
      } else if (!material || is_plain(*material)) {
        cover(run);
      } else {
        shade_visible();
        draw_in_order(run);
      }
    });
    shade_visible();
    if (weighted) draw_weighted();
    if (sorted) draw_sorted(tile_box());
    if (pattern_.count > 1) resolve_color(area_, worker_.color.data(), pattern_.count, &framebuffer_);
    store_depth(area_, worker_.tile, &framebuffer_);
  }

 private:
  const Draw& draw_of(const Run& run) const { return r_.frame.draws[run.draw]; }

  SampleColor sample_color(uint32_t sample) {
    const bool several = pattern_.count > 1;
    const size_t corner = size_t{area_.top} * framebuffer_.stride + area_.left;
    SampleColor color;
    for (size_t c = 0; c < 4; ++c) {
      color.channel[c] = several ? worker_.color.data() + sample * 4 + c : framebuffer_.plane[c].data() + corner;
    }
    color.step = several ? 4 * pattern_.count : 1;
    color.row = several ? color.step * raster::kTile : framebuffer_.stride;
    return color;
  }

  /// What the scissor leaves of the tile.
  void clear() {
    const geometry::PixelBox tile = geometry::pixel_rectangle(left_, top_, area_.width, area_.height);
    const geometry::PixelBox box = geometry::intersection(tile, r_.frame.scissor);
    if (geometry::is_empty(box)) return;
    const TileArea cleared = {
        area_.left + static_cast<uint32_t>(box.min_x - left_), area_.top + static_cast<uint32_t>(box.min_y - top_),
        static_cast<uint32_t>(box.max_x - box.min_x + 1), static_cast<uint32_t>(box.max_y - box.min_y + 1)};
    clear_area(cleared, r_.frame.clear_color, r_.frame.clear_depth, &framebuffer_);
  }

  /// Pixels of the picture that may change.
  geometry::PixelBox tile_box() const {
    return geometry::intersection(geometry::pixel_rectangle(left_, top_, area_.width, area_.height),
                                  visible_box(r_.frame));
  }
  /// Position of a pixel of the tile in the picture.
  int32_t left_of(uint32_t pixel) const { return left_ + static_cast<int32_t>(pixel % raster::kTile); }
  int32_t top_of(uint32_t pixel) const { return top_ + static_cast<int32_t>(pixel / raster::kTile); }

  raster::CoverArea cover_area(const geometry::PixelBox& box) const { return {pattern_, left_, top_, box}; }

  bool is_bare() const {
    for (uint32_t g = 0; g < r_.scene.bins.group_count; ++g) {
      if (raster::segment(r_.scene.bins, index_, g).count) return false;
    }
    return true;
  }

  /// body(run) for the triangles of the tile, in order.
  template <class Body>
  void for_each_run(const Body& body) const {
    for (uint32_t g = 0; g < r_.scene.bins.group_count; ++g) {
      const raster::BinSegment segment = raster::segment(r_.scene.bins, index_, g);
      const geometry::ScreenTriangle* triangles = r_.scene.groups[g].data();
      for (size_t begin = 0; begin < segment.count;) {
        const uint32_t draw = triangles[segment.entries[begin]].draw;
        size_t end = begin + 1;
        while (end < segment.count && triangles[segment.entries[end]].draw == draw) ++end;
        body(Run{draw, triangles, segment.entries + begin, end - begin});
        begin = end;
      }
    }
  }

  /// To the visibility buffer.
  void cover(const Run& run) {
    const Draw& draw = draw_of(run);
    auto first_slot = raster::kNoSlot;
    if (draw.material) {
      first_slot = static_cast<uint32_t>(worker_.slots.size());
      for (size_t i = 0; i < run.count; ++i) worker_.slots.push_back(run.triangles + run.entries[i]);
    }
    const raster::CoverArea area = cover_area(tile_box());
    const bool counts_overdraw = draw.material && framebuffer_.aovs & SHD_AOV_OVERDRAW;
    if (!counts_overdraw && !r_.frame.counts_hidden) {
      raster::cover(r_.context.simd, area, draw.depth, run.triangles, run.entries, run.count, first_slot,
                    &worker_.tile);
      return;
    }
    for (size_t i = 0; i < run.count; ++i) {
      const geometry::ScreenTriangle& triangle = run.triangles[run.entries[i]];
      raster::cover_mask(r_.context.simd, area, draw.depth, triangle, worker_.tile, &worker_.mask);
      const uint64_t passed = count_masked();
      if (counts_overdraw) {
        for_each_masked([&](uint32_t pixel, uint32_t mask) {
          if (mask & 1) count_overdraw(area_, pixel, &framebuffer_);
        });
      }
      count_hidden(area, triangle, passed);
      raster::cover(r_.context.simd, area, draw.depth, run.triangles, run.entries + i, 1,
                    draw.material ? first_slot + static_cast<uint32_t>(i) : raster::kNoSlot, &worker_.tile);
    }
  }

  /// Samples of the latest mask.
  uint64_t count_masked() const {
    uint64_t count = 0;
    for_each_masked([&](uint32_t, uint32_t mask) { count += static_cast<uint64_t>(__builtin_popcount(mask)); });
    return count;
  }

  /// Counts the samples that a triangle covers beyond those that passed. Overwrites the mask.
  void count_hidden(const raster::CoverArea& area, const geometry::ScreenTriangle& triangle, uint64_t passed) {
    if (!r_.frame.counts_hidden) return;
    const raster::DepthState always = {SHD_COMPARE_ALWAYS, false, 0.0f, 0.0f};
    raster::cover_mask(r_.context.simd, area, always, triangle, worker_.tile, &worker_.mask);
    worker_.hidden_samples += count_masked() - passed;
  }

  /// Where in its pixels a triangle is shaded.
  struct Placing {
    bool at_samples;
    raster::EdgeLine edge[3];  // with several samples
  };

  Placing placing_of(const geometry::ScreenTriangle& triangle) const {
    Placing placing;
    placing.at_samples = pattern_.count > 1 && r_.frame.draws[triangle.draw].sample_shading;
    for (int k = 0; k < 3 && pattern_.count > 1; ++k) {
      placing.edge[k] = raster::make_edge_line(triangle, k, left_, top_);
    }
    return placing;
  }
  bool covers(const Placing& placing, uint32_t pixel, raster::SamplePoint point) const {
    return raster::covers(placing.edge, static_cast<int32_t>(pixel % raster::kTile),
                          static_cast<int32_t>(pixel / raster::kTile), point);
  }

  /// In a pixel of which a triangle shows some samples.
  void place(const Placing& placing, uint32_t pixel, uint32_t mask, float* x, float* y) const {
    const auto left = static_cast<float>(left_of(pixel)), top = static_cast<float>(top_of(pixel));
    constexpr raster::SamplePoint kCentre = {geometry::kSubpixels / 2, geometry::kSubpixels / 2};
    if (!placing.at_samples && (mask == all_samples() || covers(placing, pixel, kCentre))) {
      *x = left + 0.5f;
      *y = top + 0.5f;
      return;
    }
    int32_t sum_x = 0, sum_y = 0, count = 0;
    for (uint32_t s = 0; s < pattern_.count; ++s) {
      if (!(mask >> s & 1)) continue;
      sum_x += pattern_.point[s].x;
      sum_y += pattern_.point[s].y;
      ++count;
    }
    const float scale = 1.0f / static_cast<float>(count * geometry::kSubpixels);
    *x = left + static_cast<float>(sum_x) * scale;
    *y = top + static_cast<float>(sum_y) * scale;
  }

  /// Starts a triangle; makes room for it.
  template <class Done>
  void begin_triangle(const geometry::ScreenTriangle& triangle, const Done& done) {
    BatchTriangles& triangles = worker_.triangles;
    if (triangles.count == shade::kBatchTriangles) flush(triangle.draw, done);
    triangles.triangle[triangles.count++] = &triangle;
  }

  /// Makes room for fragments of the latest triangle; done() sees batches that are full. Returns for how many.
  template <class Done>
  size_t make_room(const Done& done) {
    const raster::Fragments& f = worker_.workspace.fragments;
    BatchTriangles& triangles = worker_.triangles;
    if (f.count == raster::kBatch) {
      const geometry::ScreenTriangle* triangle = triangles.triangle[triangles.count - 1];
      flush(triangle->draw, done);
      triangles.triangle[triangles.count++] = triangle;
    }
    return raster::kBatch - f.count;
  }

  /// Adds a pixel of the latest triangle to a batch that has room for it.
  void add(const geometry::ScreenTriangle& triangle, const Placing& placing, uint32_t pixel, uint32_t mask) {
    raster::Fragments& f = worker_.workspace.fragments;
    const Draw& draw = r_.frame.draws[triangle.draw];
    const size_t i = f.count++;
    f.pixel[i] = pixel;
    f.mask[i] = mask;
    if (!is_plain(*draw.material)) return add_by_coverage(triangle, placing, draw, i);
    f.triangle[i] = triangle.primitive;
    if (mask == all_samples() && !placing.at_samples) {
      f.x[i] = static_cast<float>(left_of(pixel)) + 0.5f;
      f.y[i] = static_cast<float>(top_of(pixel)) + 0.5f;
      f.depth[i] = *depth_of(0, pixel);
    } else {
      place(placing, pixel, mask, &f.x[i], &f.y[i]);
      f.depth[i] = *depth_of(first_sample(mask), pixel);
    }
    worker_.triangles.of[i] = static_cast<uint16_t>(worker_.triangles.count - 1);
  }

  /// The rest of a fragment whose mask went by depths that may change before its turn: it must not tell, or the
  /// fragment would depend on when batches end.
  void add_by_coverage(const geometry::ScreenTriangle& triangle, const Placing& placing, const Draw& draw, size_t i) {
    raster::Fragments& f = worker_.workspace.fragments;
    const int32_t left = left_of(f.pixel[i]), top = top_of(f.pixel[i]);
    uint32_t mask = f.mask[i];
    for (uint32_t s = 0; s < pattern_.count && !placing.at_samples && mask != all_samples(); ++s) {
      if (covers(placing, f.pixel[i], pattern_.point[s])) mask |= 1u << s;
    }
    f.triangle[i] = triangle.primitive;
    place(placing, f.pixel[i], mask, &f.x[i], &f.y[i]);
    if (draw.material->model == SHD_MODEL_PROGRAM) {
      const raster::DepthSlope slope = raster::make_depth_slope(triangle, draw.depth);
      f.depth[i] = raster::depth_at(raster::plane_at(slope, pattern_.point[first_sample(mask)]), left, top);
    }
    worker_.triangles.of[i] = static_cast<uint16_t>(worker_.triangles.count - 1);
  }

  /// Adds pixels of one triangle, one fragment for each or for each of its samples.
  template <class Done>
  void add_pixels(const geometry::ScreenTriangle& triangle, const raster::VisiblePixel* pixels, size_t count,
                  const Done& done) {
    begin_triangle(triangle, done);
    const Placing placing = placing_of(triangle);
    for (size_t i = 0; i < count && placing.at_samples; ++i) {
      for (uint32_t mask = pixels[i].mask; mask; mask &= mask - 1) {
        make_room(done);
        add(triangle, placing, pixels[i].position, mask & ~(mask - 1));
      }
    }
    for (size_t i = 0; i < count && !placing.at_samples;) {
      const size_t end = std::min(count, i + make_room(done));
      for (; i < end; ++i) add(triangle, placing, pixels[i].position, pixels[i].mask);
    }
  }

  uint32_t all_samples() const { return (1u << pattern_.count) - 1; }
  static uint32_t first_sample(uint32_t mask) { return static_cast<uint32_t>(__builtin_ctz(mask)); }

  /// Shades the batch and empties it.
  template <class Done>
  void flush(uint32_t draw, const Done& done) {
    shade::Workspace& workspace = worker_.workspace;
    if (workspace.fragments.count) {
      const Draw& d = r_.frame.draws[draw];
      const shade::DrawShading shading = {
          d.mesh,    &r_.scene.vertices[draw], d.material, d.frequency, r_.scene.transforms[draw].orientation, d.index,
          d.instance};
      shade::shade_batch(r_.context.simd, shading, r_.lights, r_.frame.view.eye, &workspace);
      worker_.fragments += workspace.fragments.count;
      done(d);
    }
    workspace.fragments.count = 0;
    worker_.triangles.count = 0;
  }

  /// Shades what the visibility buffer shows, and empties it.
  void shade_visible() {
    if (worker_.slots.size() == 0) return;
    raster::sort_pixels(worker_.tile, worker_.slots.size(), &worker_.order);
    const auto done = [&](const Draw& draw) { write_visible(draw); };
    uint32_t draw = 0;
    for (size_t slot = 0; slot < worker_.slots.size(); ++slot) {
      const size_t begin = worker_.order.start[slot], end = worker_.order.start[slot + 1];
      if (begin == end) continue;
      const geometry::ScreenTriangle& triangle = *worker_.slots[slot];
      if (triangle.draw != draw) flush(draw, done);
      draw = triangle.draw;
      add_pixels(triangle, worker_.order.pixel.data() + begin, end - begin, done);
    }
    flush(draw, done);
    worker_.slots.clear();
    clear_slots(&worker_.tile);
  }

  void write_visible(const Draw& draw) {
    const raster::Fragments& f = worker_.workspace.fragments;
    worker_.nonfinite_fragments += write_fragments(f, worker_.workspace.columns.radiance, colors_, pattern_.count);
    if (!framebuffer_.aovs) return;
    find_rows(f, &worker_.aovs);
    write_rows(draw);
  }

  /// AOVs of the batch's rows in worker_.aovs.
  void write_rows(const Draw& draw) {
    write_aovs(r_.context.simd, area_, *draw.material, static_cast<uint32_t>(&draw - r_.frame.draws),
               worker_.workspace.fragments, &worker_.aovs, &framebuffer_);
  }

  /// Shades the covered samples of every triangle of a run whose depth may pass; done() sees batches.
  template <class Done>
  void shade_run(const Run& run, const geometry::PixelBox& box, const Done& done) {
    const Draw& draw = draw_of(run);
    raster::DepthState state = draw.depth;
    state.compare = early_compare(state.compare);
    for (size_t i = 0; i < run.count; ++i) {
      const geometry::ScreenTriangle& triangle = run.triangles[run.entries[i]];
      raster::cover_mask(r_.context.simd, cover_area(box), state, triangle, worker_.tile, &worker_.mask);
      worker_.covered.clear();
      const uint64_t passed = r_.frame.counts_hidden ? count_masked() : 0;
      for_each_masked([&](uint32_t pixel, uint32_t mask) {
        worker_.covered.push_back({static_cast<uint16_t>(pixel), static_cast<uint16_t>(mask)});
      });
      count_hidden(cover_area(box), triangle, passed);
      if (worker_.covered.size()) add_pixels(triangle, worker_.covered.data(), worker_.covered.size(), done);
    }
    flush(run.draw, done);
  }

  template <class Body>
  void for_each_masked(const Body& body) const {
    const raster::CoverMask& mask = worker_.mask;
    for (int32_t y = mask.box.min_y; y <= mask.box.max_y; ++y) {
      for (int32_t x = mask.box.min_x; x <= mask.box.max_x; ++x) {
        const auto pixel = static_cast<uint32_t>(y * raster::kTile + x);
        if (mask.bits[pixel]) body(pixel, mask.bits[pixel]);
      }
    }
  }

  /// body(fragment, sample, depth, color) for what remains of a batch, in order, where depth passes now.
  template <class Body>
  void for_each_sample(const Draw& draw, const Body& body) {
    const raster::Fragments& f = worker_.workspace.fragments;
    const shade::Columns& columns = worker_.workspace.columns;
    const material::Material& material = *draw.material;
    raster::DepthPlane plane[raster::kMaxSamples];
    const geometry::ScreenTriangle* last = nullptr;
    for (size_t i = 0; i < f.count; ++i) {
      FragmentColor color;
      for (size_t c = 0; c < 4; ++c) color.channel[c] = columns.radiance.channel[c][i];
      worker_.nonfinite_fragments += !is_finite(color);
      uint32_t mask = f.mask[i];
      if (material.flags & SHD_MATERIAL_DISCARDS && columns.discard[i]) mask = 0;
      if (color.channel[3] < material.alpha_cutoff) mask = 0;
      if (material.flags & SHD_ALPHA_TO_COVERAGE) mask &= covered_by_alpha(color.channel[3]);
      if (material.blend == SHD_BLEND_OPAQUE && material.model != SHD_MODEL_PROGRAM) color.channel[3] = 1.0f;
      if (!mask) continue;
      const geometry::ScreenTriangle* triangle = worker_.triangles.triangle[worker_.triangles.of[i]];
      if (triangle != last) {
        const raster::DepthSlope slope = raster::make_depth_slope(*triangle, draw.depth);
        for (uint32_t s = 0; s < pattern_.count; ++s) plane[s] = raster::plane_at(slope, pattern_.point[s]);
      }
      last = triangle;
      const int32_t x = left_of(f.pixel[i]), y = top_of(f.pixel[i]);
      for (; mask; mask &= mask - 1) {
        const uint32_t s = first_sample(mask);
        const float depth = raster::depth_at(plane[s], x, y);
        if (passes(draw.depth.compare, depth, *depth_of(s, f.pixel[i]))) body(i, s, depth, color);
      }
    }
  }

  float* depth_of(uint32_t sample, uint32_t pixel) {
    return worker_.tile.depth.data() + size_t{pixel} * pattern_.count + sample;
  }
  uint32_t covered_by_alpha(float alpha) const {
    const float kept = std::floor(alpha * static_cast<float>(pattern_.count) + 0.5f);
    if (!(kept > 0.0f)) return 0;
    return kept >= static_cast<float>(pattern_.count) ? ~0u : (1u << static_cast<uint32_t>(kept)) - 1;
  }
  static bool is_finite(const FragmentColor& color) {
    bool finite = true;
    for (const float c : color.channel) finite &= std::isfinite(c);
    return finite;
  }

  /// Shades a run and blends it over the colours.
  void draw_in_order(const Run& run) {
    shade_run(run, tile_box(), [&](const Draw& draw) {
      const raster::Fragments& f = worker_.workspace.fragments;
      AovScratch& aovs = worker_.aovs;
      aovs.row_count = 0;
      for_each_sample(draw, [&](size_t i, uint32_t s, float depth, const FragmentColor& color) {
        const SampleColor& below = colors_[s];
        const size_t at = below.at(f.pixel[i]);
        float* const channels[4] = {below.channel[0] + at, below.channel[1] + at, below.channel[2] + at,
                                    below.channel[3] + at};
        blend(draw.material->blend, color, channels);
        if (draw.depth.writes) *depth_of(s, f.pixel[i]) = depth;
        if (s != 0 || draw.material->blend != SHD_BLEND_OPAQUE) return;
        aovs.row[aovs.row_count++] = static_cast<uint16_t>(i);
        if (framebuffer_.aovs & SHD_AOV_OVERDRAW) count_overdraw(area_, f.pixel[i], &framebuffer_);
      });
      if (framebuffer_.aovs) write_rows(draw);
    });
  }

  /// body(run) for the draws of one blend without order.
  template <class Body>
  void for_each_unordered(shd_blend_mode blend, const Body& body) const {
    for_each_run([&](const Run& run) {
      const material::Material* material = draw_of(run).material;
      if (material && material->blend == blend) body(run);
    });
  }

  void draw_weighted() {
    clear_weighted(r_.context.allocator, pattern_.count, &worker_.unordered);
    for_each_unordered(SHD_BLEND_WEIGHTED, [&](const Run& run) {
      shade_run(run, tile_box(), [&](const Draw& draw) {
        const raster::Fragments& f = worker_.workspace.fragments;
        for_each_sample(draw, [&](size_t i, uint32_t s, float depth, const FragmentColor& color) {
          add_weighted(s, f.pixel[i], depth, color, &worker_.unordered);
        });
      });
    });
    blend_weighted(colors_, pattern_.count, worker_.unordered);
  }

  /// Samples that the sorted draws cover in a box.
  size_t count_sorted(const geometry::PixelBox& box) {
    size_t count = 0;
    for_each_unordered(SHD_BLEND_SORTED, [&](const Run& run) {
      for (size_t i = 0; i < run.count; ++i) {
        raster::cover_mask(r_.context.simd, cover_area(box), draw_of(run).depth, run.triangles[run.entries[i]],
                           worker_.tile, &worker_.mask);
        for_each_masked([&](uint32_t, uint32_t mask) { count += static_cast<size_t>(__builtin_popcount(mask)); });
      }
    });
    return count;
  }

  /// Halves boxes that hold more than the table may.
  void draw_sorted(const geometry::PixelBox& box) {
    const int32_t width = box.max_x - box.min_x + 1, height = box.max_y - box.min_y + 1;
    if (width * height > 1 && count_sorted(box) > kMaxNodes) {
      geometry::PixelBox first = box, second = box;
      if (height >= width) {
        first.max_y = box.min_y + height / 2 - 1;
        second.min_y = first.max_y + 1;
      } else {
        first.max_x = box.min_x + width / 2 - 1;
        second.min_x = first.max_x + 1;
      }
      draw_sorted(first);
      return draw_sorted(second);
    }
    worker_.unordered.nodes.clear();
    for_each_unordered(SHD_BLEND_SORTED, [&](const Run& run) {
      const shd_compare compare = draw_of(run).depth.compare;
      const bool reversed = compare == SHD_COMPARE_GREATER || compare == SHD_COMPARE_GREATER_EQUAL;
      shade_run(run, box, [&](const Draw& draw) {
        const raster::Fragments& f = worker_.workspace.fragments;
        for_each_sample(draw, [&](size_t i, uint32_t s, float depth, const FragmentColor& color) {
          const auto place = static_cast<uint32_t>(s * raster::kTilePixels + f.pixel[i]);
          const auto order = static_cast<uint32_t>(worker_.unordered.nodes.size());
          worker_.unordered.nodes.push_back({place, reversed ? -depth : depth, order, color});
        });
      });
    });
    blend_sorted(colors_, &worker_.unordered);
  }

  const TileRenderer& r_;
  Framebuffer& framebuffer_;
  const raster::SamplePattern& pattern_;
  const uint32_t index_;
  const TileArea area_;       // in the framebuffer
  const int32_t left_, top_;  // in the picture
  Worker& worker_;
  SampleColor colors_[raster::kMaxSamples];
};

}  // namespace

void TileRenderer::render(uint32_t index, Worker* worker) const {
  TilePass(*this, index, worker).run();
}

}  // namespace shd::film
