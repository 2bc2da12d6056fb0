// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include <shd/slot.h>

#include "procedural/solid.h"
#include "texture/texture.h"

namespace shd::material {

/// Number of coefficients that slots feed.
constexpr uint32_t kSlotCount = SHD_SLOT_TINT + 1;

/// A checked shd_slot.
struct Slot {
  uint32_t index;  // in the caller's array
  shd_slot_source source;
  uint32_t uv_set, channel, attribute;
  const texture::Texture* texture;  // null unless SHD_SLOT_SOURCE_TEXTURE
  const texture::Sampler* sampler;  // never null with a texture
  bool is_transformed;              // uv_transform is not the identity
  float uv_transform[6];
  shd_slot_fn procedure;
  void* user_data;
  const procedural::Solid* solid;  // null unless SHD_SLOT_SOURCE_SOLID
  shd_place_space place_space;     // the place fields are set if reads_places()
  float place_transform[16];
  float place_width;  // factor of the width of a pixel
  shd_slot_coordinates coordinates;
  uint32_t triplanar_sharpness;
};

/// Values of slots at points, as columns; null = 1.
struct Parameters {
  const float* value[kSlotCount][4];
};

/// Whether a slot has a source other than its constant.
inline bool is_set(const Slot& slot) {
  return slot.source != SHD_SLOT_SOURCE_CONSTANT;
}

/// Whether a slot is looked up at places in space: it has a solid texture, a 3D texture or coordinates from positions.
inline bool reads_places(const Slot& slot) {
  return slot.solid || (slot.texture && slot.texture->depth != 0) || slot.coordinates != SHD_SLOT_COORDINATES_UV;
}

/// Whether a slot is looked up along three axes.
inline bool is_triplanar(const Slot& slot) {
  return slot.coordinates == SHD_SLOT_COORDINATES_TRIPLANAR;
}

/// Whether the colour of a slot is divided by its fourth channel after the lookup.
inline bool is_divided(const Slot& slot, uint32_t index) {
  return slot.texture && slot.texture->premultiplied && (index == SHD_SLOT_DIFFUSE || index == SHD_SLOT_TINT);
}

/// Number of columns of a slot.
constexpr uint32_t slot_channels(uint32_t slot) {
  switch (slot) {
    case SHD_SLOT_DIFFUSE:
    case SHD_SLOT_TINT:
    case SHD_SLOT_NORMAL:
    case SHD_SLOT_CLEARCOAT_NORMAL: return 4;
    case SHD_SLOT_AMBIENT:
    case SHD_SLOT_SPECULAR:
    case SHD_SLOT_EMISSION:
    case SHD_SLOT_MATCAP: return 3;
    default: return 1;
  }
}

/// Slots that are looked up at the points where lobes are computed; the other slots are looked up at every fragment.
constexpr uint32_t kShapingSlots = 1u << SHD_SLOT_EXPONENT | 1u << SHD_SLOT_ROUGHNESS | 1u << SHD_SLOT_NORMAL |
                                   1u << SHD_SLOT_NORMAL_MIXED | 1u << SHD_SLOT_HEIGHT | 1u << SHD_SLOT_CLEARCOAT |
                                   1u << SHD_SLOT_CLEARCOAT_ROUGHNESS | 1u << SHD_SLOT_CLEARCOAT_NORMAL;

/// Whether two slots make equal lookups in one texture.
inline bool share_lookups(const Slot& a, const Slot& b) {
  if (a.texture != b.texture || a.sampler != b.sampler || a.coordinates != b.coordinates) return false;
  if (!std::equal(a.uv_transform, a.uv_transform + 6, b.uv_transform)) return false;
  if (!reads_places(a)) return a.uv_set == b.uv_set;
  return a.place_space == b.place_space && a.place_width == b.place_width &&
         a.triplanar_sharpness == b.triplanar_sharpness &&
         std::equal(a.place_transform, a.place_transform + 16, b.place_transform);
}

}  // namespace shd::material
