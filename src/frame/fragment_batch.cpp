// SPDX-License-Identifier: MIT
#include "frame/fragment_batch.h"

#include <algorithm>
#include <cstring>

#include "shade/needs.h"

namespace shd::frame {
namespace {

constexpr raster::SamplePoint kCentre = {geometry::kSubpixels / 2, geometry::kSubpixels / 2};

/// Pixels begin..end - 1 of one row of the tile, and the values of their fragments.
struct PixelRow {
  uint32_t begin, end;
  uint32_t mask, triangle;
  float left, top;  // centre of the tile's first pixel
};

template <class T>
void set_four(T* to, T value) {
  for (size_t k = 0; k < 4; ++k) to[k] = value;
}

/// Sets rows of the table from row `at` on, in fours: up to three rows past the last one are overwritten.
void set_rows(const PixelRow& pixels, size_t at, raster::Fragments* f) {
  const float top = pixels.top + static_cast<float>(static_cast<int32_t>(pixels.begin / raster::kTile));
  const size_t end = at + (pixels.end - pixels.begin);
  uint32_t pixel[4] = {pixels.begin, pixels.begin + 1, pixels.begin + 2, pixels.begin + 3};
  for (; at < end; at += 4) {
    float x[4];
    for (size_t k = 0; k < 4; ++k) {
      x[k] = pixels.left + static_cast<float>(static_cast<int32_t>(pixel[k] % raster::kTile));
    }
    std::memcpy(f->pixel + at, pixel, sizeof pixel);
    std::memcpy(f->x + at, x, sizeof x);
    set_four(f->mask + at, pixels.mask);
    set_four(f->triangle + at, pixels.triangle);
    set_four(f->y + at, top);
    for (uint32_t& next : pixel) next += 4;
  }
}

/// Samples of a pattern of kCount that lie inside the edges at a pixel.
template <uint32_t kCount>
uint32_t covered(const ShadingPoints& points, const PixelEdges& edges) {
  uint32_t mask = 0;
  for (uint32_t s = 0; s < kCount; ++s) {
    const int64_t sides = (edges.step[0] + points.at_sample[0][s]) | (edges.step[1] + points.at_sample[1][s]) |
                          (edges.step[2] + points.at_sample[2][s]);
    mask |= static_cast<uint32_t>(sides >= 0) << s;
  }
  return mask;
}

}  // namespace

FragmentBatch::FragmentBatch(const TileState& tile) : tile_(tile), worker_(tile.worker) {
  worker_.workspace.fragments.left = tile.left;
  worker_.workspace.fragments.top = tile.top;
}

void FragmentBatch::begin(uint32_t draw) {
  const Draw& d = tile_.renderer.frame.draws[draw];
  draw_ = draw;
  max_triangles_ = d.frequency == SHD_FREQUENCY_GOURAUD ? shade::kGouraudTriangles : raster::kBatch;
  per_sample_ = tile_.shades_samples(d);
  sets_depths_ = shade::runs_caller_code(*d.material);
  keeps_triangles_ = !is_plain(*d.material);
}

ShadingPoints FragmentBatch::shading_points(const geometry::ScreenTriangle& triangle) const {
  ShadingPoints points;
  const uint32_t count = tile_.pattern.count;
  points.per_sample = per_sample_;
  for (int k = 0; k < 3 && count > 1; ++k) {
    const raster::EdgeLine line = raster::make_edge_line(triangle, k, tile_.left, tile_.top);
    points.a[k] = line.a;
    points.b[k] = line.b;
    points.at_centre[k] = raster::edge_at(line, kCentre).value;
    for (uint32_t s = 0; s < count; ++s) points.at_sample[k][s] = raster::edge_at(line, tile_.pattern.point[s]).value;
  }
  return points;
}

/// Samples of a row that the triangle covers, visible or not. Independent of occlusion, so that results do not depend
/// on batch or pass boundaries. With sample shading: the one sample of the row.
uint32_t FragmentBatch::covered_samples(const ShadingPoints& points, size_t row) const {
  const raster::Fragments& f = worker_.workspace.fragments;
  if (points.per_sample || f.mask[row] == tile_.all_samples()) return f.mask[row];
  return samples_at(points, PixelEdges(points, f.pixel[row]));
}

uint32_t FragmentBatch::samples_at(const ShadingPoints& points, const PixelEdges& edges) const {
  switch (tile_.pattern.count) {
    case 2: return covered<2>(points, edges);
    case 4: return covered<4>(points, edges);
    case 8: return covered<8>(points, edges);
    default: return covered<16>(points, edges);
  }
}

/// Moves a row from the centre of its pixel to the centroid of the covered samples, unless the triangle covers the
/// centre. With sample shading: to the one sample of the row.
void FragmentBatch::move_to_centroid(const ShadingPoints& points, size_t row) const {
  raster::Fragments& f = worker_.workspace.fragments;
  uint32_t mask = f.mask[row];
  bool stays = false;
  if (!points.per_sample) {
    const PixelEdges edges(points, f.pixel[row]);
    mask = samples_at(points, edges);
    stays = edges.covers(points.at_centre) | (mask == tile_.all_samples());
  }
  const raster::PointSum sum = raster::sum_of_points(tile_.pattern, mask);
  const float scale = 1.0f / static_cast<float>(sum.count * geometry::kSubpixels);
  // Indices in place of a branch that would be predicted wrongly for many rows.
  const float x[2] = {static_cast<float>(tile_.left_of(f.pixel[row])) + static_cast<float>(sum.x) * scale, f.x[row]};
  const float y[2] = {static_cast<float>(tile_.top_of(f.pixel[row])) + static_cast<float>(sum.y) * scale, f.y[row]};
  f.x[row] = x[stays];
  f.y[row] = y[stays];
}

/// Moves rows of a bake from the centre of their texels to the nearest points of their triangles.
void FragmentBatch::move_to_nearest(size_t begin, size_t end) const {
  raster::Fragments& f = worker_.workspace.fragments;
  const raster::NearestTriangles& nearest = worker_.nearest[0];
  for (size_t row = begin; row < end; ++row) {
    f.x[row] = nearest.x[f.pixel[row]];
    f.y[row] = nearest.y[f.pixel[row]];
  }
}

/// Appends pixels of the latest triangle to the table, which must have room for them.
void FragmentBatch::append(const geometry::ScreenTriangle& triangle, const ShadingPoints& points,
                           const raster::PixelRun& run) {
  raster::Fragments& f = worker_.workspace.fragments;
  const size_t begin = f.count;
  const float left = static_cast<float>(tile_.left) + 0.5f, top = static_cast<float>(tile_.top) + 0.5f;
  for (uint32_t first = run.begin, end; first < run.end; first = end) {
    end = std::min<uint32_t>(run.end, raster::next_row(first));
    set_rows({first, end, run.mask, triangle.primitive, left, top}, f.count, &f);
    f.count += end - first;
  }
  worker_.runs.run[worker_.runs.count++] = run;
  if (points.per_sample || run.mask != tile_.all_samples()) {
    for (size_t row = begin; row < f.count; ++row) move_to_centroid(points, row);
  }
  if (tile_.renderer.frame.bake) move_to_nearest(begin, f.count);
  if (sets_depths_) set_depths(triangle, tile_.draw_of(triangle), points, begin, f.count);
  if (!keeps_triangles_) return;
  const auto latest = static_cast<uint16_t>(worker_.triangles.count - 1);
  for (size_t i = begin; i < f.count; ++i) worker_.triangles.of[i] = latest;
}

/// Sets the depths that a program reads: the depth of a row is taken at the first sample that the triangle covers.
void FragmentBatch::set_depths(const geometry::ScreenTriangle& triangle, const Draw& draw, const ShadingPoints& points,
                               size_t begin, size_t end) {
  raster::Fragments& f = worker_.workspace.fragments;
  const raster::DepthSlope slope = raster::make_depth_slope(triangle, draw.depth);
  for (size_t i = begin; i < end; ++i) {
    const uint32_t sample = first_sample(covered_samples(points, i));
    const raster::DepthPlane plane = raster::plane_at(slope, tile_.pattern.point[sample]);
    f.depth[i] = raster::depth_at(plane, tile_.left_of(f.pixel[i]), tile_.top_of(f.pixel[i]));
  }
}

void FragmentBatch::shade(uint32_t draw) {
  shade::shade_batch(tile_.simd(), tile_.shading_of(draw), tile_.renderer.lights, tile_.renderer.frame.view,
                     &worker_.workspace);
  worker_.fragments += worker_.workspace.fragments.count;
}

}  // namespace shd::frame
