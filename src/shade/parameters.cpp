// SPDX-License-Identifier: MIT
#include "shade/parameters.h"

#include <algorithm>

#include "material/places.h"
#include "shade/program.h"
#include "texture/lookup/sample.h"

namespace shd::shade {
namespace {

using material::Slot;

/// Number of columns of a slot that are filled. The alpha of a colour texture has no effect on opaque materials, unless
/// it divides the colour.
uint32_t filled_channels(const material::Material& material, uint32_t index) {
  const shd_slot_source source = material.slot[index].source;
  const bool has_texture = source == SHD_SLOT_SOURCE_TEXTURE || source == SHD_SLOT_SOURCE_SOLID;
  const bool is_color = index == SHD_SLOT_DIFFUSE || index == SHD_SLOT_TINT;
  const bool lacks_alpha =
      is_color && has_texture && !material::has_opacity(material) && !material::is_divided(material.slot[index], index);
  return lacks_alpha ? 3 : material::slot_channels(index);
}

/// Evaluates the solid texture of a slot.
void evaluate_solid(const core::SimdTarget& simd, const Slot& slot, uint32_t index, const SlotContext& context,
                    Columns* columns) {
  const uint32_t channels = filled_channels(*context.shading.material, index);
  float* out[4] = {};
  for (uint32_t c = 0; c < channels; ++c) out[channels == 1 ? slot.channel : c] = columns->slot[index][c];
  const material::PlaceMap map = material::place_map(slot, context.shading.object_to_world);
  float* const* const place = columns->uv;
  float* const width = context.has_footprint ? place[3] : nullptr;
  material::find_places(map, context.points, place);
  if (width) material::find_widths(map, slot.place_width, context.points, width);
  procedural::evaluate_colors(*slot.solid, simd, {context.points.count, place[0], place[1], place[2], width}, out);
}

/// Adds columns of a slot to the channels of its texture. Returns false if a channel is already in use.
bool add_outputs(const Slot& slot, uint32_t index, uint32_t channels, const Columns& columns, texture::Texels* out) {
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

/// Looks up the textures of slots, once for all slots with equal lookups.
void look_up_textures(const core::SimdTarget& simd, const SlotContext& context, uint32_t slots, Columns* columns) {
  const material::Material& material = *context.shading.material;
  while (slots) {
    const auto first = static_cast<uint32_t>(__builtin_ctz(slots));
    const Slot& slot = material.slot[first];
    texture::Texels out = {};
    for (uint32_t i = first; i < material::kSlotCount; ++i) {
      const bool shares = slots >> i & 1 && material::share_lookups(slot, material.slot[i]);
      if (!shares) continue;
      if (add_outputs(material.slot[i], i, filled_channels(material, i), *columns, &out)) slots &= ~(1u << i);
    }
    if (!material::is_triplanar(slot)) {
      texture::sample(*slot.texture, *slot.sampler, simd, lookups_of(slot, context, columns), out);
      continue;
    }
    material::blend_axes(slot, context.points, context.shading.object_to_world, context.has_footprint, columns->uv,
                         out.channel, [&](const texture::Lookups& lookups, float* const(&values)[4]) {
                           texture::Texels part = {};
                           std::copy_n(values, 4, part.channel);
                           texture::sample(*slot.texture, *slot.sampler, simd, lookups, part);
                         });
  }
}

/// Points the channels of a slot to the columns of the mesh. Absent channels are null; for normals they are columns of
/// 1, because the normal kernel reads all channels.
void point_to_attributes(const Slot& slot, uint32_t index, const SlotContext& context, const Columns& columns,
                         material::Parameters* out) {
  const geometry::Vertices& vertices = *context.shading.vertices;
  for (uint32_t c = 0; c < material::slot_channels(index); ++c) {
    const uint32_t column = slot.attribute + c;
    const bool is_there = column < SHD_MAX_ATTRIBUTES && vertices.has_attribute[column];
    out->value[index][c] = is_there ? context.points.attribute[column] : nullptr;
    if (is_there || (index != SHD_SLOT_NORMAL && index != SHD_SLOT_CLEARCOAT_NORMAL)) continue;
    std::fill_n(columns.slot[index][c], context.points.count, 1.0f);
    out->value[index][c] = columns.slot[index][c];
  }
}

void run_procedure(const Slot& slot, uint32_t index, const SlotContext& context, const Columns& columns) {
  for (uint32_t c = 0; c < material::slot_channels(index); ++c) {
    std::fill_n(columns.slot[index][c], context.points.count, 1.0f);
  }
  ProgramInputs inputs;
  make_inputs(context.shading, context.points, context.varyings, &inputs);
  call_procedure(context.shading, inputs.fragments, slot, columns.slot[index]);
}

/// Makes straight colours of the premultiplied ones of a slot.
void divide_by_alpha(size_t count, float* const color[4]) {
  const float* const alpha = color[3];
  for (uint32_t c = 0; c < 3; ++c) {
    for (size_t i = 0; i < count; ++i) color[c][i] = alpha[i] > 0.0f ? color[c][i] / alpha[i] : 0.0f;
  }
}

/// Multiplies the diffuse slot by the tint, whose columns may be those of the points.
void multiply_by_tint(size_t count, const Columns& columns, material::Parameters* out) {
  for (uint32_t c = 0; c < material::slot_channels(SHD_SLOT_TINT); ++c) {
    const float* const tint = out->value[SHD_SLOT_TINT][c];
    const float*& diffuse = out->value[SHD_SLOT_DIFFUSE][c];
    if (!tint) continue;
    if (!diffuse) {
      diffuse = tint;
      continue;
    }
    float* const product = columns.slot[SHD_SLOT_DIFFUSE][c];
    for (size_t i = 0; i < count; ++i) product[i] = diffuse[i] * tint[i];
    diffuse = product;
  }
}

}  // namespace

void look_up_slots(const core::SimdTarget& simd, const SlotContext& context, uint32_t slots, Columns* columns,
                   material::Parameters* out) {
  const material::Material& material = *context.shading.material;
  uint32_t textured = 0;
  slots &= material.slots & ~(1u << SHD_SLOT_HEIGHT | 1u << SHD_SLOT_MATCAP);
  for (uint32_t i = 0; i < material::kSlotCount; ++i) {
    if (!(slots >> i & 1)) continue;
    const Slot& slot = material.slot[i];
    std::copy_n(columns->slot[i], filled_channels(material, i), out->value[i]);
    if (slot.source == SHD_SLOT_SOURCE_TEXTURE) textured |= 1u << i;
    if (slot.source == SHD_SLOT_SOURCE_VERTEX) point_to_attributes(slot, i, context, *columns, out);
    if (slot.source == SHD_SLOT_SOURCE_SOLID) evaluate_solid(simd, slot, i, context, columns);
    if (slot.source == SHD_SLOT_SOURCE_PROCEDURE) run_procedure(slot, i, context, *columns);
  }
  look_up_textures(simd, context, textured, columns);
  for (const uint32_t i : {SHD_SLOT_DIFFUSE, SHD_SLOT_TINT}) {
    if (textured >> i & 1 && material::is_divided(material.slot[i], i)) {
      divide_by_alpha(context.points.count, columns->slot[i]);
    }
  }
  if (slots >> SHD_SLOT_TINT & 1) multiply_by_tint(context.points.count, *columns, out);
}

}  // namespace shd::shade
