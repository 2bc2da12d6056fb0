// SPDX-License-Identifier: MIT
#include "shade/parameters.h"

#include <algorithm>

#include "shade/program.h"

namespace shd::shade {
namespace {

using material::Slot;

/// Columns of a slot for the channels of its texture; false if `out` has one of them already.
bool add_outputs(const Slot& slot, uint32_t index, const Columns& columns, texture::Texels* out) {
  const uint32_t channels = material::slot_channels(index);
  if (channels == 1) {
    if (out->channel[slot.channel]) return false;
    out->channel[slot.channel] = columns.slot[index][0];
    return true;
  }
  for (uint32_t c = 0; c < channels; ++c) {
    if (out->channel[c]) return false;
  }
  for (uint32_t c = 0; c < channels; ++c) out->channel[c] = columns.slot[index][c];
  return true;
}

/// Textures of the slots, one lookup for those that share it.
void look_up_textures(const core::SimdTarget& simd, const SlotRows& where, uint32_t slots, Columns* columns) {
  const material::Material& material = *where.shading.material;
  while (slots) {
    const auto first = static_cast<uint32_t>(__builtin_ctz(slots));
    const Slot& slot = material.slot[first];
    texture::Texels out = {};
    for (uint32_t i = first; i < SHD_SLOT_COUNT; ++i) {
      const bool shares = slots >> i & 1 && material::share_lookups(slot, material.slot[i]);
      if (shares && add_outputs(material.slot[i], i, *columns, &out)) slots &= ~(1u << i);
    }
    texture::sample(*slot.texture, *slot.sampler, simd, lookups_of(slot, where, columns), out);
  }
}

/// One column through a row of a matrix.
void transform(const float* a, const float* b, const float* row, float offset, size_t count, float* __restrict out) {
  for (size_t i = 0; i < count; ++i) out[i] = row[0] * a[i] + row[1] * b[i] + offset;
}

/// Channels that the mesh lacks are null, of normals a column of 1: their kernel reads all.
void point_to_attributes(const Slot& slot, uint32_t index, const SlotRows& where, const Columns& columns,
                         Parameters* out) {
  const geometry::Vertices& vertices = *where.shading.vertices;
  for (uint32_t c = 0; c < material::slot_channels(index); ++c) {
    const uint32_t column = slot.attribute + c;
    const bool is_there = column < SHD_MAX_ATTRIBUTES && vertices.has_attribute[column];
    out->value[index][c] = is_there ? where.rows.attribute[column] : nullptr;
    if (is_there || index != SHD_SLOT_NORMAL) continue;
    std::fill_n(columns.slot[index][c], where.rows.count, 1.0f);
    out->value[index][c] = columns.slot[index][c];
  }
}

void run_procedure(const Slot& slot, uint32_t index, const SlotRows& where, const Columns& columns) {
  for (uint32_t c = 0; c < material::slot_channels(index); ++c) {
    std::fill_n(columns.slot[index][c], where.rows.count, 1.0f);
  }
  call_procedure(where.shading, make_inputs(where.shading, where.rows, where.varyings), slot, index,
                 columns.slot[index]);
}

}  // namespace

texture::Lookups lookups_of(const Slot& slot, const raster::Fragments& f, bool has_footprint, float* const scratch[6]) {
  const bool second = slot.uv_set == 1;
  const float* in[6] = {second ? f.u1 : f.u,       second ? f.v1 : f.v,       second ? f.du1dx : f.dudx,
                        second ? f.dv1dx : f.dvdx, second ? f.du1dy : f.dudy, second ? f.dv1dy : f.dvdy};
  if (slot.is_transformed) {
    const float* t = slot.uv_transform;
    for (int k = 0; k < 6; k += 2) {
      transform(in[k], in[k + 1], t, k ? 0.0f : t[2], f.count, scratch[k]);
      transform(in[k], in[k + 1], t + 3, k ? 0.0f : t[5], f.count, scratch[k + 1]);
    }
    std::copy_n(scratch, 6, in);
  }
  if (!has_footprint) std::fill_n(in + 2, 4, nullptr);
  return {f.count, in[0], in[1], in[2], in[3], in[4], in[5], nullptr, nullptr, nullptr};
}

void look_up_slots(const core::SimdTarget& simd, const SlotRows& where, uint32_t slots, Columns* columns,
                   Parameters* out) {
  const material::Material& material = *where.shading.material;
  uint32_t textured = 0;
  slots &= material.slots & ~(1u << SHD_SLOT_HEIGHT | 1u << SHD_SLOT_MATCAP);
  for (uint32_t i = 0; i < SHD_SLOT_COUNT; ++i) {
    if (!(slots >> i & 1)) continue;
    const Slot& slot = material.slot[i];
    std::copy_n(columns->slot[i], 4, out->value[i]);
    if (slot.source == SHD_SOURCE_TEXTURE) textured |= 1u << i;
    if (slot.source == SHD_SOURCE_VERTEX) point_to_attributes(slot, i, where, *columns, out);
    if (slot.source == SHD_SOURCE_PROCEDURE) run_procedure(slot, i, where, *columns);
  }
  look_up_textures(simd, where, textured, columns);
}

}  // namespace shd::shade
