// SPDX-License-Identifier: MIT
#include "texture/domain/lod.h"

#include <cstring>

#include "core/simd_target.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "texture/domain/lods.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "texture/domain/places-inl.h"
#include "texture/domain/project-inl.h"
#include "texture/domain/shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace shd::texture::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// LodColumn() of a 3D texture.
size_t PlaceLodColumn(const Texture& texture, const Sampler& sampler, const LodRange& range, LodAxis axis,
                      const Lookups& in, float* out) {
  size_t nonfinite = 0;
  for (size_t first = 0; first < in.count; first += kBlock) {
    const Lookups part = block_of(in, first);
    PlaceProbeBlock probes;
    PlaceLodBlock levels;
    const bool by_probes = axis == LodAxis::kProbes;
    nonfinite += by_probes ? FindShapes(texture, sampler, part, &probes, &range)
                           : FindShapes(texture, sampler, part, &levels, &range);
    std::memcpy(out + first, by_probes ? probes.lod : levels.lod, part.count * sizeof(float));
  }
  return nonfinite;
}

size_t LodColumn(const Texture& texture, const Sampler& sampler, const LodRange& range, LodAxis axis, const Lookups& in,
                 float* out) {
  if (texture.depth != 0) return PlaceLodColumn(texture, sampler, range, axis, in, out);
  size_t nonfinite = 0;
  for (size_t first = 0; first < in.count; first += kBlock) {
    Lookups part = block_of(in, first);
    ProbeBlock block;
    ProjectedBlock points;
    const bool directions = texture.projection != SHD_PROJECTION_NONE;
    if (HWY_UNLIKELY(directions)) {
      nonfinite += ProjectLookups(texture, part, &points);
      part = points.points;
    }
    const size_t found = axis == LodAxis::kProbes
                             ? FindShapes(texture, sampler, part, &block, &range)
                             : FindShapes(texture, sampler, part, static_cast<LodBlock*>(&block), &range);
    if (!directions) nonfinite += found;
    std::memcpy(out + first, block.lod, part.count * sizeof(float));
  }
  return nonfinite;
}

/// Implements find_axes().
void Axes(const Texture& texture, const Sampler& sampler, const Lookups& lookup, float (&axes)[4]) {
  const auto width = static_cast<float>(texture.width), height = static_cast<float>(texture.height);
  const bool lod_given = lookup.lod != nullptr;
  if (texture.depth != 0) {
    PlaceBlock place;
    FillPlaces(texture, sampler, lookup, &place, place.w, [&](auto d, const auto& p, size_t) {
      const auto f = lod_given ? RoundPlaceAxes(d, p.lod) : AxesOfPlaces(d, p);
      axes[0] = hn::GetLane(f.length * f.u);
      axes[1] = hn::GetLane(f.length * f.v);
      axes[2] = axes[3] = 0.0f;
    });
    return;
  }
  PointBlock point;
  Lookups in = lookup;
  ProjectedBlock points;
  if (texture.projection != SHD_PROJECTION_NONE) {
    ProjectLookups(texture, lookup, &points);
    in = points.points;
  }
  FillBlock(texture, sampler, in, &point, [&](auto d, const auto& p, size_t) {
    const auto f = lod_given ? RoundFootprint(d, p.lod) : FootprintOf(d, p.derivatives, width, height);
    const auto shorter = f.length * f.roundness;
    axes[0] = hn::GetLane(f.length * f.u);
    axes[1] = hn::GetLane(f.length * f.v);
    axes[2] = hn::GetLane(hn::Neg(shorter * f.v));
    axes[3] = hn::GetLane(shorter * f.u);
  });
}

}  // namespace shd::texture::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::texture {
namespace {
HWY_EXPORT(LodColumn);
HWY_EXPORT(Axes);
}  // namespace

size_t find_lods(const Texture& texture, const Sampler& sampler, const LodRange& range, LodAxis axis,
                 const core::SimdTarget& simd, const Lookups& lookups, float* out) {
  return SHD_DISPATCH(LodColumn, simd)(texture, sampler, range, axis, lookups, out);
}

void find_axes(const Texture& texture, const Sampler& sampler, const core::SimdTarget& simd, const Lookups& lookup,
               float (&axes)[4]) {
  SHD_DISPATCH(Axes, simd)(texture, sampler, lookup, axes);
}

}  // namespace shd::texture
#endif
