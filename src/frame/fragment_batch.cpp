// SPDX-License-Identifier: MIT
#include "frame/fragment_batch.h"

#include <algorithm>

#include "raster/append_rows.h"
#include "shade/needs.h"

namespace shd::frame {
namespace {

constexpr raster::SamplePoint kCentre = {geometry::kSubpixels / 2, geometry::kSubpixels / 2};

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

/// Appends runs of the latest triangle to the table, which must have room for them.
void FragmentBatch::append(const geometry::ScreenTriangle& triangle, const ShadingPoints& points,
                           const raster::PixelRun* runs, size_t count) {
  raster::Fragments& f = worker_.workspace.fragments;
  const size_t begin = f.count;
  raster::append_rows(tile_.simd(), runs, count, triangle.primitive, &f);
  std::copy_n(runs, count, worker_.runs.run + worker_.runs.count);
  worker_.runs.count += count;
  for (size_t i = 0, row = begin; i < count && tile_.pattern.count > 1; ++i) {
    const size_t end = row + raster::length_of(runs[i]);
    const bool moves = points.per_sample || runs[i].mask != tile_.all_samples();
    for (; row < end && moves; ++row) move_to_centroid(points, row);
    row = end;
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
