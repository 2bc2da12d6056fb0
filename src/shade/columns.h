// SPDX-License-Identifier: MIT
#pragma once

#include "core/allocator.h"
#include "material/slot.h"
#include "raster/fragments.h"

namespace shd::shade {

/// Lobes of the model that has most.
constexpr uint32_t kMaxLobes = 3;

/// What each row reflects of the lights, before the coefficients that scale it (material/model.h): columns of
/// raster::kBatch.
struct Lobes {
  float* lobe[kMaxLobes][3];
};

/// Colour and the targets of SHD_AOV_TARGET1 to 3.
constexpr uint32_t kMaxTargets = 4;

/// Result of a batch: scene-linear, premultiplied; columns of raster::kBatch.
struct Radiance {
  float* channel[4 * kMaxTargets];  // r, g, b, a of colour, then of each target; null where there is none
};

/// Values of slots at rows; null = 1.
struct Parameters {
  const float* value[SHD_SLOT_COUNT][4];
};

/// Coefficients that shape lobes, by row; null = the material's constant.
struct Shape {
  const float* exponent;       // p
  const float* alpha_squared;  // roughness^4
  const float* gain;           // of the specular lobe; null = 1
};

/// Lights of a batch that have a texture or a shadow and are worked on at a time.
constexpr size_t kModulated = 4;

/// Columns of one worker besides its Fragments.
struct Columns {
  core::Array<float> block;
  Lobes lobes;                             // of the fragments
  Radiance radiance;                       // of the fragments
  float* slot[SHD_SLOT_COUNT][4];          // values of slots; null beyond their channels
  Lobes row_lobes;                         // of corners or centroids
  Radiance row_radiance;                   // of corners or centroids
  float* uv[6];                            // transformed u, v, dudx, dvdx, dudy, dvdy
  float* frame[6];                         // dp/du and dp/dv of the rows' triangles, world space
  float* tilt[2];                          // of bumps: height over u and v, or over a texel
  float* variance;                         // of slopes that a normal map lost
  float *exponent, *alpha_squared, *gain;  // of the rows
  float* factor[kModulated][3];            // of the rows: what texture and shadow leave of a light
  float* shadow_normal[3];                 // of the rows, before maps and bumps; with shadows
  float* visibility;                       // of the rows, of a light with texture and shadow
  uint32_t* row;                           // for each fragment, the first of its triangle's rows
  uint32_t* discard;                       // of the fragments: not 0 where a program dropped them
  uint32_t* row_discard;                   // of corners or centroids
};

namespace detail {

/// visit(column) for every column that there is; radiance for the targets.
template <class Visit>
void visit_columns(uint32_t targets, Columns* columns, Visit visit) {
  for (Lobes* lobes : {&columns->lobes, &columns->row_lobes}) {
    for (auto& lobe : lobes->lobe) {
      for (float*& column : lobe) visit(&column);
    }
  }
  for (Radiance* radiance : {&columns->radiance, &columns->row_radiance}) {
    for (uint32_t c = 0; c < 4 * kMaxTargets; ++c) {
      radiance->channel[c] = nullptr;
      if (targets >> c / 4 & 1) visit(&radiance->channel[c]);
    }
  }
  for (uint32_t i = 0; i < SHD_SLOT_COUNT; ++i) {
    for (uint32_t c = 0; c < 4; ++c) {
      columns->slot[i][c] = nullptr;
      if (c < material::slot_channels(i)) visit(&columns->slot[i][c]);
    }
  }
  for (float*& column : columns->uv) visit(&column);
  for (float*& column : columns->frame) visit(&column);
  for (float*& column : columns->tilt) visit(&column);
  for (float*& column : columns->shadow_normal) visit(&column);
  visit(&columns->visibility);
  for (float** column : {&columns->variance, &columns->exponent, &columns->alpha_squared, &columns->gain})
    visit(column);
  for (auto& factor : columns->factor) {
    for (float*& column : factor) visit(&column);
  }
  for (uint32_t** column : {&columns->row, &columns->discard, &columns->row_discard}) {
    visit(reinterpret_cast<float**>(column));
  }
}

}  // namespace detail

/// @param targets  bit t: there is target t; bit 0 is set
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
