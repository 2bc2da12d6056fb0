// SPDX-License-Identifier: MIT
#pragma once

#include "core/allocator.h"
#include "material/model.h"
#include "material/slot.h"
#include "material/slot_lookup.h"
#include "raster/fragments.h"

namespace shd::shade {

/// Number of targets: colour, and the targets of SHD_AOV_TARGET1 to 3.
constexpr uint32_t kMaxTargets = 4;

/// Radiance of a batch: scene-linear, premultiplied; columns of raster::kBatch elements.
struct Radiance {
  float* channel[4 * kMaxTargets];  // r, g, b, a of colour, then of each target; null if a target is absent
};

/// Shape parameters of the lobes at points, in the order of the model's Shape; null = the material's constant.
struct LobeShape {
  const float* column[material::kMaxShapeColumns];
  /// Two vectors a, b in world space: n + p a + q b (normalised), for standard normal deviates p and q and the point's
  /// normal n, are the normals averaged by filtering a normal map. All null = 0.
  const float* spread[6];
};

/// Largest number of lights with a cookie or a shadow in one LightGroup; their factors are stored.
constexpr size_t kModulated = 4;

/// Columns for marching the fragments' lines of sight through a height field.
struct MarchColumns {
  float *u0, *v0;  // uv of the fragment on the surface
  float *du, *dv;  // uv step from the surface to the full depth
  float* above;    // height of the line above the field at the previous step
  float* found;    // position on the line where it meets the field, 0..1; negative until found
};

/// Columns of one worker in addition to its Fragments. Points are the positions where lobes are computed: the fragments
/// at Phong frequency, otherwise the corners or centroids of triangles.
struct Columns {
  core::Array<float> block;
  material::Lobes lobes;                     // at fragments
  material::Lobes environment;               // at fragments: the environment's part of the lobes, without occlusion
  Radiance radiance;                         // at fragments
  float* slot[material::kSlotCount][4];      // values of slots; null beyond their channels
  material::Lobes point_lobes;               // at corners or centroids
  material::Lobes point_environment;         // at corners or centroids
  Radiance point_radiance;                   // at corners or centroids
  float* uv[material::kLookupScratch];       // texture lookups, and places in solid textures
  float* tangent_frame[6];                   // dp/du and dp/dv of the points' triangles, world space
  float* shifted;                            // u or v of lookups displaced by one texel
  float* tilt[2];                            // bump slopes: derivative of the height by u and v, or difference over a
                                             // texel
  float* variance;                           // variance of slopes removed by filtering a normal map; TOKSVIG
  float* spread[6];                          // as LobeShape::spread; MOMENTS
  MarchColumns march;                        // parallax scratch
  float* shape[material::kMaxShapeColumns];  // shape parameters of the lobes at points
  float* factor[kModulated][3];              // at points: factor of a light's cookie and shadow
  float* coat_normal[3];                     // at points: normal of a clear coat
  float* shadow_normal[3];                   // at points, before normal maps and bumps; set only with shadows
  float* visibility;                         // at points, for a light with a cookie and a shadow
  uint32_t* point;                           // [fragment] first point of its triangle
  uint32_t* discard;                         // [fragment] not 0 if a program discarded it
  uint32_t* point_discard;                   // [corner or centroid] as `discard`
};

namespace detail {

/// Calls visit(column) for every column, including the radiance columns of existing targets.
template <class Visit>
void visit_columns(uint32_t targets, Columns* columns, Visit visit) {
  for (material::Lobes* lobes :
       {&columns->lobes, &columns->point_lobes, &columns->environment, &columns->point_environment}) {
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
  for (float*& column : columns->spread) visit(&column);
  for (float*& column : columns->shadow_normal) visit(&column);
  for (float*& column : columns->coat_normal) visit(&column);
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

/// @param targets  bit t is set if target t exists; bit 0 is set
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
