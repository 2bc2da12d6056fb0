// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <shd/material.h>
#include <shd/slot.h>

namespace shd::material {

/// What a model is made of. A lobe is what the lights give before the coefficients that scale it.
struct ModelInfo {
  uint32_t lobes;   // RGB sums over the lights: 0 = it knows no lights
  bool needs_eye;   // lobes go by wo
  uint32_t slots;   // bits of those that it reads
  bool has_normal;  // bumps and mapped normals change it
};

namespace detail {

constexpr uint32_t bit(uint32_t slot) {
  return 1u << slot;
}
constexpr uint32_t kAlways = bit(SHD_SLOT_DIFFUSE) | bit(SHD_SLOT_OPACITY) | bit(SHD_SLOT_EMISSION);
constexpr uint32_t kSurface = bit(SHD_SLOT_NORMAL) | bit(SHD_SLOT_HEIGHT);
constexpr uint32_t kLit = kAlways | kSurface | bit(SHD_SLOT_AMBIENT) | bit(SHD_SLOT_OCCLUSION);
constexpr uint32_t kShiny = kLit | bit(SHD_SLOT_SPECULAR) | bit(SHD_SLOT_EXPONENT);

}  // namespace detail

inline ModelInfo info_of(shd_model model) {
  using namespace detail;
  switch (model) {
    case SHD_MODEL_LAMBERT: return {1, false, kLit, true};
    case SHD_MODEL_BLINN_PHONG:
    case SHD_MODEL_BLINN_PHONG_NORMALIZED:
    case SHD_MODEL_PHONG:
    case SHD_MODEL_TOON: return {2, true, kShiny, true};
    case SHD_MODEL_COMBINED: return {2, true, kShiny & ~bit(SHD_SLOT_AMBIENT), true};
    case SHD_MODEL_GOOCH: return {1, false, kAlways | kSurface, true};
    case SHD_MODEL_METALLIC_ROUGHNESS: return {3, true, kLit | bit(SHD_SLOT_METALLIC) | bit(SHD_SLOT_ROUGHNESS), true};
    case SHD_MODEL_MATCAP: return {0, false, kAlways | kSurface | bit(SHD_SLOT_MATCAP), true};
    case SHD_MODEL_SHOW_NORMAL: return {0, false, kAlways | kSurface, true};
    case SHD_MODEL_UNLIT:
    case SHD_MODEL_SHOW_UV:
    case SHD_MODEL_SHOW_LEVEL:
    case SHD_MODEL_SHOW_BARYCENTRICS: return {0, false, kAlways | bit(SHD_SLOT_HEIGHT), false};
    default: return {0, false, 0, false};
  }
}

}  // namespace shd::material
