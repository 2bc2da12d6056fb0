// SPDX-License-Identifier: MIT
#pragma once

#include "core/allocator.h"
#include "material/model.h"
#include "material/slot.h"
#include "raster/fragments.h"

namespace shd::shade {

/// Colour and the targets of SHD_AOV_TARGET1 to 3.
constexpr uint32_t kMaxTargets = 4;

/// Radiance of a batch: scene-linear, premultiplied; columns of raster::kBatch.
struct Radiance {
  float* channel[4 * kMaxTargets];  // r, g, b, a of colour, then of each target; null where a target is absent
};

/// Values that shape the lobes at points, in the order of the model's Shape; null = the material's constant.
struct LobeShape {
  const float* column[material::kMaxShapeColumns];
};

/// Largest number of lights with a cookie or a shadow whose factors are held at once.
constexpr size_t kModulated = 4;

/// Columns of a march along lines of sight over the heights of a surface, of the fragments.
struct MarchColumns {
  float *u0, *v0;  // on the surface
  float *du, *dv;  // from there to the full depth
  float* above;    // distance from the line down to the heights at the step before
  float* found;    // part of the way where the line meets the heights, 0..1; negative until that is known
};

/// Columns of one worker besides its Fragments. Points are where lobes are computed: the fragments at Phong frequency,
/// else the corners or centroids of triangles.
struct Columns {
  core::Array<float> block;
  material::Lobes lobes;                     // of the fragments
  Radiance radiance;                         // of the fragments
  float* slot[material::kSlotCount][4];      // values of slots; null beyond their channels
  material::Lobes point_lobes;               // of corners or centroids
  Radiance point_radiance;                   // of corners or centroids
  float* uv[6];                              // of texture lookups: u, v, dudx, dvdx, dudy, dvdy
  float* tangent_frame[6];                   // dp/du and dp/dv of the points' triangles, world space
  float* shifted;                            // u or v of lookups one texel away
  float* tilt[2];                            // of bumps: height over u and v, or over a texel
  float* variance;                           // of slopes that a normal map lost
  MarchColumns march;                        // of parallax
  float* shape[material::kMaxShapeColumns];  // of the points' lobes
  float* factor[kModulated][3];              // of the points: part of a light that passes its cookie and shadow
  float* shadow_normal[3];                   // of the points, before maps and bumps; only with shadows
  float* visibility;                         // of the points, for a light with cookie and shadow
  uint32_t* point;                           // of the fragments: the first point of their triangle
  uint32_t* discard;                         // of the fragments: not 0 where a program dropped them
  uint32_t* point_discard;                   // of corners or centroids
};

namespace detail {

/// visit(column) for every column, with the radiance columns of the targets.
template <class Visit>
void visit_columns(uint32_t targets, Columns* columns, Visit visit) {
  for (material::Lobes* lobes : {&columns->lobes, &columns->point_lobes}) {
    for (auto& lobe : lobes->lobe) {
      for (float*& column : lobe) visit(&column);
    }
  }
  for (Radiance* radiance : {&columns->radiance, &columns->point_radiance}) {
    for (uint32_t c = 0; c < 4 * kMaxTargets; ++c) {
      radiance->channel[c] = nullptr;
      if (targets >> c / 4 & 1) visit(&radiance->channel[c]);
    }
  }
  for (uint32_t i = 0; i < material::kSlotCount; ++i) {
    for (uint32_t c = 0; c < 4; ++c) {
      columns->slot[i][c] = nullptr;
      if (c < material::slot_channels(i)) visit(&columns->slot[i][c]);
    }
  }
  for (float*& column : columns->uv) visit(&column);
  for (float*& column : columns->tangent_frame) visit(&column);
  for (float*& column : columns->tilt) visit(&column);
  for (float*& column : columns->shadow_normal) visit(&column);
  for (float*& column : columns->shape) visit(&column);
  for (float** column : {&columns->visibility, &columns->shifted, &columns->variance}) visit(column);
  MarchColumns& march = columns->march;
  for (float** column : {&march.u0, &march.v0, &march.du, &march.dv, &march.above, &march.found}) visit(column);
  for (auto& factor : columns->factor) {
    for (float*& column : factor) visit(&column);
  }
  for (uint32_t** column : {&columns->point, &columns->discard, &columns->point_discard}) {
    visit(reinterpret_cast<float**>(column));
  }
}

}  // namespace detail

/// @param targets  bit t = target t exists; bit 0 is set
/// Throws std::bad_alloc.
inline void allocate(const core::Allocator& allocator, uint32_t targets, Columns* out) {
  size_t columns = 0;
  detail::visit_columns(targets, out, [&](float**) { ++columns; });
  out->block = core::Array<float>(allocator, columns * raster::kBatch);
  out->block.fill_zero();
  float* next = out->block.data();
  detail::visit_columns(targets, out, [&](float** column) {
    *column = next;
    next += raster::kBatch;
  });
}

}  // namespace shd::shade
