// SPDX-License-Identifier: MIT
#include "shade/surface.h"

#include <algorithm>

#include "shade/illuminate.h"
#include "shade/needs.h"
#include "shade/normals.h"
#include "shade/tangent_frames.h"
#include "texture/lookup/sample.h"

namespace shd::shade {
namespace {

/// Sets the tilt to the differences of the height over one texel of level 0 along u and v, times the scales.
void difference_height(const core::SimdTarget& simd, const material::Slot& slot, const SlotContext& context,
                       const float* height, float scale_u, float scale_v, Columns* columns) {
  const texture::Lookups at = lookups_of(slot, context, columns);
  const float step[2] = {1.0f / static_cast<float>(slot.texture->width),
                         1.0f / static_cast<float>(slot.texture->height)};
  float* const shifted = columns->shifted;
  for (int axis = 0; axis < 2; ++axis) {
    const float* from = axis ? at.v : at.u;
    for (size_t i = 0; i < at.count; ++i) shifted[i] = from[i] + step[axis];
    texture::Lookups next = at;
    (axis ? next.v : next.u) = shifted;
    texture::Texels out = {};
    out.channel[slot.channel] = columns->tilt[axis];
    texture::sample(*slot.texture, *slot.sampler, simd, next, out);
    const float scale = axis ? scale_v : scale_u;
    float* tilt = columns->tilt[axis];
    for (size_t i = 0; i < at.count; ++i) tilt[i] = (tilt[i] - height[i]) * scale;
  }
}

float* look_up_height(const core::SimdTarget& simd, const material::Slot& slot, const SlotContext& context,
                      Columns* columns) {
  texture::Texels out = {};
  out.channel[slot.channel] = columns->slot[SHD_SLOT_HEIGHT][0];
  texture::sample(*slot.texture, *slot.sampler, simd, lookups_of(slot, context, columns), out);
  return columns->slot[SHD_SLOT_HEIGHT][0];
}

/// Height difference over a texel: negated along u, not along v, because bitangents run against v.
void find_texel_tilt(const core::SimdTarget& simd, const SlotContext& context, Columns* columns) {
  const material::Material& material = *context.shading.material;
  const material::Slot& slot = material.slot[SHD_SLOT_HEIGHT];
  const float* height = look_up_height(simd, slot, context, columns);
  difference_height(simd, slot, context, height, -material.bump_scale, material.bump_scale, columns);
}

/// Derivatives of bump_scale times the height by the points' own u and v, in world units.
void find_gradient(const core::SimdTarget& simd, const SlotContext& context, Columns* columns) {
  const material::Material& material = *context.shading.material;
  const material::Slot& slot = material.slot[SHD_SLOT_HEIGHT];
  if (texture::has_gradient(slot.sampler->filter) && slot.sampler->magnification == SHD_MAGNIFICATION_DEFAULT) {
    texture::Texels out = {};
    out.du[slot.channel] = columns->tilt[0];
    out.dv[slot.channel] = columns->tilt[1];
    texture::sample(*slot.texture, *slot.sampler, simd, lookups_of(slot, context, columns), out);
  } else {
    const float* height = look_up_height(simd, slot, context, columns);
    difference_height(simd, slot, context, height, static_cast<float>(slot.texture->width),
                      static_cast<float>(slot.texture->height), columns);
  }
  const float* t = slot.uv_transform;
  const float s = material.bump_scale;
  for (size_t i = 0; i < context.points.count; ++i) {
    const float du = columns->tilt[0][i], dv = columns->tilt[1][i];
    columns->tilt[0][i] = s * (t[0] * du + t[3] * dv);
    columns->tilt[1][i] = s * (t[1] * du + t[4] * dv);
  }
}

/// Calls body() while the points' normals are those of the clear coat.
template <class Body>
void with_coat_normals(raster::Fragments* points, Columns* columns, const Body& body) {
  const auto swap = [&] {
    std::swap(points->nx, columns->coat_normal[0]);
    std::swap(points->ny, columns->coat_normal[1]);
    std::swap(points->nz, columns->coat_normal[2]);
  };
  swap();
  body();
  swap();
}

/// Sets the normals of the clear coat to the points' normals, tilted by its normal map.
void map_coat_normals(const core::SimdTarget& simd, const material::Material& material,
                      const material::Parameters& parameters, raster::Fragments* points, Columns* columns) {
  const size_t count = points->count;
  std::copy_n(points->nx, count, columns->coat_normal[0]);
  std::copy_n(points->ny, count, columns->coat_normal[1]);
  std::copy_n(points->nz, count, columns->coat_normal[2]);
  if (!material::has_slot(material, SHD_SLOT_CLEARCOAT_NORMAL)) return;
  const float* const* map = parameters.value[SHD_SLOT_CLEARCOAT_NORMAL];
  const float factor = material.coat_normal_factor, offset = material.coat_normal_offset;
  const float up = material.flags & SHD_MATERIAL_NORMAL_Y_DOWN ? -1.0f : 1.0f;
  for (size_t i = 0; i < count; ++i) {
    const float inverse = 1.0f / std::max(factor * map[2][i] + offset, 1e-3f);
    columns->tilt[0][i] = (factor * map[0][i] + offset) * inverse;
    columns->tilt[1][i] = up * (factor * map[1][i] + offset) * inverse;
  }
  with_coat_normals(points, columns, [&] { tilt_normals(simd, columns->tilt, points); });
}

}  // namespace

void make_tangent_bases(const SlotContext& context, raster::Fragments* points, Columns* columns) {
  const material::Material& material = *context.shading.material;
  if (!needs_tangent_frames(material)) return;
  const geometry::Vertices& vertices = *context.shading.vertices;
  const float orientation = context.shading.orientation;
  if (vertices.tangent.size() == 0) {
    const uint32_t slot = material::has_slot(material, SHD_SLOT_NORMAL) ? SHD_SLOT_NORMAL : SHD_SLOT_CLEARCOAT_NORMAL;
    const uint32_t set = material::has_slot(material, slot) ? material.slot[slot].uv_set : 0;
    make_tangent_frames(vertices, orientation, set, true, points, columns);
  }
  const bool has_height = material::has_slot(material, SHD_SLOT_HEIGHT);
  if (has_height) {
    make_tangent_frames(vertices, orientation, material.slot[SHD_SLOT_HEIGHT].uv_set, false, points, columns);
  }
}

LobeShape evaluate_surface(const core::SimdTarget& simd, const SlotContext& context, raster::Fragments* points,
                           Columns* columns, material::Parameters* parameters) {
  const material::Material& material = *context.shading.material;
  look_up_slots(simd, context, material::kShapingSlots, columns, parameters);
  const bool has_coat = material.model == material::ModelKey::kClearCoat;
  if (has_coat) map_coat_normals(simd, material, *parameters, points, columns);
  const bool bumps = material::has_slot(material, SHD_SLOT_HEIGHT) && material.bump_scale != 0.0f;
  const bool maps = material::has_slot(material, SHD_SLOT_NORMAL);
  if (bumps && material.bump == SHD_BUMP_TEXEL) find_texel_tilt(simd, context, columns);
  if (bumps && material.bump == SHD_BUMP_GRADIENT) find_gradient(simd, context, columns);
  const bool has_moments = maps && material.normal_encoding == SHD_NORMAL_ENCODING_MOMENTS;
  if (has_moments) {
    map_moments(simd, material, parameters->value[SHD_SLOT_NORMAL], parameters->value[SHD_SLOT_NORMAL_MIXED][0], points,
                columns->spread);
  } else if (maps) {
    map_normals(simd, material, parameters->value[SHD_SLOT_NORMAL], points, columns->variance);
  }
  if (bumps && material.bump == SHD_BUMP_TEXEL) tilt_normals(simd, columns->tilt, points);
  if (bumps && material.bump == SHD_BUMP_GRADIENT) bump_normals(simd, columns->tilt, columns->tangent_frame, points);
  if (material.flags & SHD_MATERIAL_DOUBLE_SIDED && !context.shading.keeps_sides) {
    const auto face = [&] { face_normals(*context.shading.vertices, context.shading.orientation, points); };
    face();
    if (has_coat) with_coat_normals(points, columns, face);
  }
  const bool has_variance = maps && material.normal_encoding == SHD_NORMAL_ENCODING_TOKSVIG;
  LobeShape shape =
      shape_lobes(simd, material, *parameters, has_variance ? columns->variance : nullptr, points->count, columns);
  for (int k = 0; k < 6 && has_moments; ++k) shape.spread[k] = columns->spread[k];
  for (uint32_t c = 0; c < 3 && has_coat; ++c) {
    shape.column[material::kCoatNormalColumn + c] = columns->coat_normal[c];
  }
  return shape;
}

}  // namespace shd::shade
