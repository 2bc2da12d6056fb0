// SPDX-License-Identifier: MIT
#include "shade/needs.h"

#include "geometry/attributes.h"
#include "raster/interpolate.h"

namespace shd::shade {
namespace {

using material::Material;

template <class Test>
bool any_slot(const Material& material, const Test& test) {
  for (uint32_t i = 0; i < material::kSlotCount; ++i) {
    if (material::has_slot(material, i) && test(material.slot[i])) return true;
  }
  return false;
}

bool reads_uv(const Material& material, uint32_t set) {
  return any_slot(material, [&](const material::Slot& slot) {
    return slot.texture && !material::reads_places(slot) && slot.uv_set == set;
  });
}

bool reads_attributes(const Material& material) {
  return any_slot(material, [](const material::Slot& slot) { return slot.source == SHD_SLOT_SOURCE_VERTEX; });
}

/// Columns of the fragments from which places are found.
uint32_t place_columns(const Material& material) {
  if (!any_slot(material, material::reads_places)) return 0;
  uint32_t needed = raster::kPosition | raster::kPositionSteps;
  if (any_slot(material, material::is_triplanar)) needed |= raster::kNormal;
  return needed;
}

bool reads_tangents(const Material& material) {
  return material::has_slot(material, SHD_SLOT_NORMAL) || material::has_slot(material, SHD_SLOT_CLEARCOAT_NORMAL) ||
         (material::has_slot(material, SHD_SLOT_HEIGHT) && material.bump == SHD_BUMP_TEXEL);
}

/// Columns of the points that the lights of a frame and the lobes of the model read.
uint32_t lit_columns(const Material& material, const LightTable& lights) {
  const material::ModelInfo& info = material::info_of(material.model);
  uint32_t needed = raster::kNormal;
  if (info.needs_eye) needed |= raster::kToEye;
  if (lights.any_shadow) needed |= raster::kPosition;
  for (size_t i = 0; i < lights.count; ++i) {
    if (lights.lights[i].kind != SHD_LIGHT_KIND_DIRECTIONAL || lights.lights[i].cookie) needed |= raster::kPosition;
  }
  return needed;
}

}  // namespace

bool runs_caller_code(const Material& material) {
  return material.model == SHD_MODEL_PROGRAM ||
         any_slot(material, [](const material::Slot& slot) { return slot.source == SHD_SLOT_SOURCE_PROCEDURE; });
}

uint32_t needed_extras(const Material& material) {
  if (runs_caller_code(material)) {
    return geometry::kExtraTangent | geometry::kExtraTexture1 | geometry::kExtraAttributes;
  }
  uint32_t extras = 0;
  if (reads_tangents(material)) extras |= geometry::kExtraTangent;
  if (reads_uv(material, 1)) extras |= geometry::kExtraTexture1;
  if (reads_attributes(material)) extras |= geometry::kExtraAttributes;
  return extras;
}

bool needs_tangent_frames(const Material& material) {
  return runs_caller_code(material) || reads_tangents(material) || material::has_slot(material, SHD_SLOT_HEIGHT);
}

uint32_t needed_columns(const DrawShading& shading, const LightTable& lights) {
  const Material& material = *shading.material;
  const bool per_fragment = shading.frequency == SHD_FREQUENCY_PHONG;
  if (runs_caller_code(material) && (per_fragment || material.model != SHD_MODEL_PROGRAM))
    return raster::kInterpolateAll | place_columns(material);
  const material::ModelInfo& info = material::info_of(material.model);
  uint32_t needed = info.shown_columns | place_columns(material);
  if (reads_uv(material, 0)) needed |= raster::kTexture;
  if (reads_uv(material, 1)) needed |= raster::kTexture1;
  if (reads_attributes(material)) needed |= raster::kAttributes;
  if (shading.frequency == SHD_FREQUENCY_GOURAUD) needed |= raster::kBarycentrics;
  if (!per_fragment) return needed;
  if (info.lobes) needed |= lit_columns(material, lights);
  if (info.has_normal) needed |= raster::kNormal;
  if (info.has_normal && reads_tangents(material)) needed |= raster::kTangent;
  if (material.parallax_depth > 0.0f && material::has_slot(material, SHD_SLOT_HEIGHT)) {
    needed |= raster::kNormal | raster::kToEye;
  }
  return needed;
}

}  // namespace shd::shade
