// SPDX-License-Identifier: MIT
#include "frame/blended_pass.h"

#include <cmath>

namespace shd::frame {
namespace {

/// The comparison of the early depth test. It must not reject a fragment that may pass the late test: a NOT_EQUAL draw
/// changes the depths that its own later fragments are compared with.
shd_compare early_compare(shd_compare compare) {
  return compare == SHD_COMPARE_NOT_EQUAL ? SHD_COMPARE_ALWAYS : compare;
}

/// The first round(alpha count) samples of a pixel.
uint32_t covered_by_alpha(float alpha, uint32_t count) {
  const float kept = std::floor(alpha * static_cast<float>(count) + 0.5f);
  if (!(kept > 0.0f)) return 0;
  return kept >= static_cast<float>(count) ? ~0u : (1u << static_cast<uint32_t>(kept)) - 1;
}

}  // namespace

/// Samples of a row that pass the alpha test, alpha to coverage and discard.
uint32_t Survival::kept_samples(size_t row, film::FragmentColor* color) const {
  const shade::Columns& columns = tile_.worker.workspace.columns;
  const material::Material& material = *draw_.material;
  for (size_t c = 0; c < 4; ++c) color->channel[c] = columns.radiance.channel[c][row];
  tile_.worker.nonfinite_fragments += !film::is_finite(*color);
  uint32_t mask = tile_.worker.workspace.fragments.mask[row];
  if (material.flags & SHD_MATERIAL_DISCARDS && columns.discard[row]) mask = 0;
  if (color->channel[3] < material.alpha_cutoff) mask = 0;
  if (material.flags & SHD_MATERIAL_ALPHA_TO_COVERAGE) mask &= covered_by_alpha(color->channel[3], tile_.pattern.count);
  if (material.blend == SHD_BLEND_OPAQUE && material.model != SHD_MODEL_PROGRAM) color->channel[3] = 1.0f;
  return mask;
}

bool Survival::survives(size_t row, Survivor* out) {
  const uint32_t kept = kept_samples(row, &out->color);
  if (!kept) return false;
  const BatchTriangles& triangles = tile_.worker.triangles;
  const geometry::ScreenTriangle* triangle = triangles.triangle[triangles.of[row]];
  if (triangle != triangle_) {
    const raster::DepthSlope slope = raster::make_depth_slope(*triangle, draw_.depth);
    for (uint32_t s = 0; s < tile_.pattern.count; ++s) plane_[s] = raster::plane_at(slope, tile_.pattern.point[s]);
    triangle_ = triangle;
  }
  out->pixel = tile_.worker.workspace.fragments.pixel[row];
  out->mask = 0;
  const int32_t x = tile_.left_of(out->pixel), y = tile_.top_of(out->pixel);
  for (uint32_t rest = kept; rest; rest &= rest - 1) {
    const uint32_t s = first_sample(rest);
    out->depth[s] = raster::depth_at(plane_[s], x, y);
    if (raster::passes(test_, out->depth[s], *tile_.depth_of(s, out->pixel))) out->mask |= 1u << s;
  }
  return out->mask != 0;
}

void cover_triangle(TileState* tile, const Draw& draw, const geometry::PixelBox& box,
                    const geometry::ScreenTriangle& triangle) {
  Worker& worker = tile->worker;
  raster::DepthState state = draw.depth;
  state.compare = early_compare(state.compare);
  raster::cover_mask(tile->simd(), tile->cover_area(box), state, triangle, worker.tile, &worker.mask);
  worker.covered.clear();
  tile->for_each_masked([&](uint32_t pixel, uint32_t mask) {
    worker.covered.push_back({static_cast<uint16_t>(pixel), static_cast<uint16_t>(pixel + 1), mask});
  });
  if (tile->renderer.frame.counts_hidden) tile->count_hidden(tile->cover_area(box), triangle, tile->count_masked());
}

void blend_run(TileState* tile, const Run& run) {
  raster::forget_bounds(&tile->worker.tile);
  shade_run(tile, run, tile->box(), [&](const Draw& draw) {
    const raster::Fragments& f = tile->worker.workspace.fragments;
    film::AovScratch& aovs = tile->worker.aovs;
    aovs.row_count = 0;
    Survival survival(draw, tile);
    Survivor left;
    for (size_t i = 0; i < f.count; ++i) {
      if (!survival.survives(i, &left)) continue;
      tile->color.blend(draw.material->blend, left.pixel, left.mask, left.color,
                        tile->worker.workspace.columns.radiance, i);
      for (uint32_t rest = left.mask; rest && draw.depth.writes; rest &= rest - 1) {
        *tile->depth_of(first_sample(rest), left.pixel) = left.depth[first_sample(rest)];
      }
      if (!(left.mask & 1) || draw.material->blend != SHD_BLEND_OPAQUE) continue;
      aovs.row[aovs.row_count++] = static_cast<uint16_t>(i);
      if (tile->framebuffer.aovs & SHD_AOV_OVERDRAW) film::count_overdraw(tile->area, left.pixel, &tile->framebuffer);
    }
    if (tile->framebuffer.aovs) {
      film::write_aovs(tile->simd(), tile->area, {*draw.material, draw.object_to_world, draw.index}, f,
                       tile->worker.workspace.columns.uv, &aovs, &tile->framebuffer);
    }
  });
}

}  // namespace shd::frame
