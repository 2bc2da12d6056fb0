// SPDX-License-Identifier: MIT
#include "shade/surface.h"

#include <algorithm>

#include "shade/frames.h"
#include "shade/needs.h"
#include "shade/normals.h"

namespace shd::shade {
namespace {

/// The derivative of a wanted channel over a unit of u and v at rows, by differences over a texel of the base.
void difference_height(const core::SimdTarget& simd, const material::Slot& slot, const SlotRows& where,
                       const float* height, float scale_u, float scale_v, Columns* columns) {
  const texture::Lookups at = lookups_of(slot, where, columns);
  const float step[2] = {1.0f / static_cast<float>(slot.texture->width),
                         1.0f / static_cast<float>(slot.texture->height)};
  float* const moved = columns->variance;  // free until normals are mapped
  for (int axis = 0; axis < 2; ++axis) {
    const float* from = axis ? at.v : at.u;
    for (size_t i = 0; i < at.count; ++i) moved[i] = from[i] + step[axis];
    texture::Lookups next = at;
    (axis ? next.v : next.u) = moved;
    texture::Texels out = {};
    out.channel[slot.channel] = columns->tilt[axis];
    texture::sample(*slot.texture, *slot.sampler, simd, next, out);
    const float scale = axis ? scale_v : scale_u;
    float* tilt = columns->tilt[axis];
    for (size_t i = 0; i < at.count; ++i) tilt[i] = (tilt[i] - height[i]) * scale;
  }
}

float* look_up_height(const core::SimdTarget& simd, const material::Slot& slot, const SlotRows& where,
                      Columns* columns) {
  texture::Texels out = {};
  out.channel[slot.channel] = columns->slot[SHD_SLOT_HEIGHT][0];
  texture::sample(*slot.texture, *slot.sampler, simd, lookups_of(slot, where, columns), out);
  return columns->slot[SHD_SLOT_HEIGHT][0];
}

/// Height over a texel of u, downhill, and of v, uphill: bitangents run against v.
void find_texel_tilt(const core::SimdTarget& simd, const SlotRows& where, Columns* columns) {
  const material::Material& material = *where.shading.material;
  const material::Slot& slot = material.slot[SHD_SLOT_HEIGHT];
  const float* height = look_up_height(simd, slot, where, columns);
  difference_height(simd, slot, where, height, -material.bump_scale, material.bump_scale, columns);
}

/// Height over the rows' own u and v, in world units, of bump_scale times the texture.
void find_gradient(const core::SimdTarget& simd, const SlotRows& where, Columns* columns) {
  const material::Material& material = *where.shading.material;
  const material::Slot& slot = material.slot[SHD_SLOT_HEIGHT];
  if (texture::has_gradient(slot.sampler->filter) && slot.sampler->magnification == SHD_MAGNIFICATION_DEFAULT) {
    texture::Texels out = {};
    out.du[slot.channel] = columns->tilt[0];
    out.dv[slot.channel] = columns->tilt[1];
    texture::sample(*slot.texture, *slot.sampler, simd, lookups_of(slot, where, columns), out);
  } else {
    const float* height = look_up_height(simd, slot, where, columns);
    difference_height(simd, slot, where, height, static_cast<float>(slot.texture->width),
                      static_cast<float>(slot.texture->height), columns);
  }
  const float* t = slot.uv_transform;
  const float s = material.bump_scale;
  for (size_t i = 0; i < where.rows.count; ++i) {
    const float du = columns->tilt[0][i], dv = columns->tilt[1][i];
    columns->tilt[0][i] = s * (t[0] * du + t[3] * dv);
    columns->tilt[1][i] = s * (t[1] * du + t[4] * dv);
  }
}

}  // namespace

void make_bases(const SlotRows& where, raster::Fragments* rows, Columns* columns) {
  const material::Material& material = *where.shading.material;
  if (!needs_frames(material)) return;
  const geometry::Vertices& vertices = *where.shading.vertices;
  const float orientation = where.shading.orientation;
  if (vertices.tangent.size() == 0) {
    const uint32_t set = material::has_slot(material, SHD_SLOT_NORMAL) ? material.slot[SHD_SLOT_NORMAL].uv_set : 0;
    make_frames(vertices, orientation, set, true, rows, columns);
  }
  const bool has_height = material::has_slot(material, SHD_SLOT_HEIGHT);
  if (has_height) {
    make_frames(vertices, orientation, material.slot[SHD_SLOT_HEIGHT].uv_set, false, rows, columns);
  }
}

Shape shape_surface(const core::SimdTarget& simd, const SlotRows& where, raster::Fragments* rows, Columns* columns,
                    Parameters* parameters) {
  const material::Material& material = *where.shading.material;
  look_up_slots(simd, where, material::kShapingSlots, columns, parameters);
  const bool bumps = material::has_slot(material, SHD_SLOT_HEIGHT) && material.bump_scale != 0.0f;
  const bool maps = material::has_slot(material, SHD_SLOT_NORMAL);
  if (bumps && material.bump == SHD_BUMP_TEXEL) find_texel_tilt(simd, where, columns);
  if (bumps && material.bump == SHD_BUMP_GRADIENT) find_gradient(simd, where, columns);
  if (maps) map_normals(simd, material, parameters->value[SHD_SLOT_NORMAL], rows, columns->variance);
  if (bumps && material.bump == SHD_BUMP_TEXEL) tilt_normals(simd, columns->tilt, rows);
  if (bumps && material.bump == SHD_BUMP_GRADIENT) bump_normals(simd, columns->tilt, columns->frame, rows);
  if (material.flags & SHD_DOUBLE_SIDED) face_normals(*where.shading.vertices, where.shading.orientation, rows);
  const bool loses = maps && material.normal_encoding >= SHD_NORMAL_TOKSVIG;
  return shape_lobes(simd, material, *parameters, loses ? columns->variance : nullptr, rows->count, columns);
}

}  // namespace shd::shade
