// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <shd/material.h>
#include <shd/view.h>

#include "core/simd_target.h"
#include "raster/fragments.h"

namespace shd::material {

struct Material;

/// A model or a debug view: what a material is shaded with, and the key of the table of models.
enum class ModelKey : uint32_t {
  kProgram = SHD_MODEL_PROGRAM,
  kFirstView = 32,  // above all models
  kClearCoat = 64,  // SHD_MODEL_METALLIC_ROUGHNESS with a clear coat
};

constexpr ModelKey key_of(ModelKey key) {
  return key;
}
constexpr ModelKey key_of(shd_model model) {
  return static_cast<ModelKey>(model);
}
/// The key of a view that is not SHD_DEBUG_VIEW_NONE.
constexpr ModelKey key_of(shd_debug_view view) {
  return static_cast<ModelKey>(static_cast<uint32_t>(ModelKey::kFirstView) + view - SHD_DEBUG_VIEW_NORMAL);
}
constexpr bool operator==(ModelKey key, shd_model model) {
  return key == key_of(model);
}
constexpr bool operator!=(ModelKey key, shd_model model) {
  return key != key_of(model);
}
/// A debug view is shown in place of the model.
constexpr ModelKey model_key(shd_model model, shd_debug_view view) {
  return view == SHD_DEBUG_VIEW_NONE ? key_of(model) : key_of(view);
}

/// Largest number of lobes of a model.
constexpr uint32_t kMaxLobes = 4;
/// Largest number of shape parameters of the lobes of a model at a point.
constexpr uint32_t kMaxShapeColumns = 6;
/// First of three shape parameters that are the normal of a clear coat.
constexpr uint32_t kCoatNormalColumn = 3;

/// Reflected light of each point before the coefficients are applied: the lobes of the model, RGB, summed over the
/// lights.
struct Lobes {
  float* lobe[kMaxLobes][3];  // columns
};

/// Properties of a model that other stages use. model-inl.h explains the fields.
struct ModelInfo {
  uint32_t slots;        // bits of the slots that the model reads
  uint32_t lobes;        // 0 = unlit
  uint32_t shape_slots;  // bits of the slots that shape the lobes
  uint32_t shape_columns;
  uint32_t shown_columns;  // raster::Interpolated bits
  bool needs_eye;
  bool has_normal;
  bool ignores_irradiance;
  bool colors_ambient;
  bool reflects_environment;
  uint32_t environment_tables;  // shd_environment_table bits
};

/// Properties of a model; all zero for ModelKey::kProgram.
const ModelInfo& info_of(ModelKey model);

/// The largest value of shd_model that has a model.
shd_model last_model();

/// Inputs of show(): the fragments of an unlit model.
struct ShowInputs {
  const core::SimdTarget& simd;
  const Material& material;
  const shd_view& view;
  const raster::Fragments& fragments;
  const float* object_to_world;  // [16] of the draw
  float* const* uv;              // [kLookupScratch] scratch columns
};

/// Writes the colour of an unlit model to out, columns of the fragments. Writes nothing past their count, and nothing
/// at all for models with lobes and for SHD_MODEL_UNLIT.
void show(const ShowInputs& in, float* const out[3]);

}  // namespace shd::material
