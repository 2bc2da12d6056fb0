// SPDX-License-Identifier: MIT
#include "material/slot_lookup.h"

#include <algorithm>

#include "material/places.h"
#include "material/projected.h"
#include "texture/domain/lod.h"

namespace shd::material {
namespace {

/// out = row . (a, b) + offset.
void transform(const float* a, const float* b, const float* row, float offset, size_t count, float* __restrict out) {
  for (size_t i = 0; i < count; ++i) out[i] = row[0] * a[i] + row[1] * b[i] + offset;
}

struct Column {
  alignas(64) float value[raster::kBatch];
};
constexpr Column make_ones() {
  Column ones = {};
  for (float& value : ones.value) value = 1.0f;
  return ones;
}
constexpr Column kOnes = make_ones();

constexpr Parameters make_unset() {
  Parameters unset = {};
  for (auto& slot : unset.value) {
    for (const float*& column : slot) column = kOnes.value;
  }
  return unset;
}
constexpr Parameters kUnset = make_unset();

/// Returns the lookups of a 3D texture.
texture::Lookups lookups_at_places(const Slot& slot, const raster::Fragments& points, const float object_to_world[16],
                                   bool has_footprint, float* const scratch[kLookupScratch]) {
  const PlaceMap map = place_map(slot, object_to_world);
  texture::Lookups lookups = {};
  lookups.count = points.count;
  find_places(map, points, scratch);
  lookups.u = scratch[0];
  lookups.v = scratch[1];
  lookups.w = scratch[2];
  if (!has_footprint) return lookups;
  find_steps(map, slot.place_width, points, scratch + 3);
  lookups.dudx = scratch[3];
  lookups.dvdx = scratch[4];
  lookups.dwdx = scratch[5];
  lookups.dudy = scratch[6];
  lookups.dvdy = scratch[7];
  lookups.dwdy = scratch[8];
  return lookups;
}

}  // namespace

texture::Lookups lookups_of(const Slot& slot, const float* const (&uv)[6], size_t count,
                            float* const scratch[kLookupScratch]) {
  const float* in[6];
  std::copy_n(uv, 6, in);
  if (slot.is_transformed) {
    const float* t = slot.uv_transform;
    for (int k = 0; k < 6; k += 2) {
      transform(in[k], in[k + 1], t, k ? 0.0f : t[2], count, scratch[k]);
      transform(in[k], in[k + 1], t + 3, k ? 0.0f : t[5], count, scratch[k + 1]);
    }
    std::copy_n(scratch, 6, in);
  }
  texture::Lookups lookups = {};
  lookups.count = count;
  lookups.u = in[0];
  lookups.v = in[1];
  lookups.dudx = in[2];
  lookups.dvdx = in[3];
  lookups.dudy = in[4];
  lookups.dvdy = in[5];
  return lookups;
}

texture::Lookups lookups_of(const Slot& slot, const raster::Fragments& f, const float object_to_world[16],
                            bool has_footprint, float* const scratch[kLookupScratch]) {
  if (slot.coordinates == SHD_SLOT_COORDINATES_PROJECTED)
    return projected_lookups(slot, f, object_to_world, has_footprint, scratch);
  if (reads_places(slot)) return lookups_at_places(slot, f, object_to_world, has_footprint, scratch);
  const bool second = slot.uv_set == 1;
  const float* uv[6] = {second ? f.u1 : f.u,       second ? f.v1 : f.v,       second ? f.du1dx : f.dudx,
                        second ? f.dv1dx : f.dvdx, second ? f.du1dy : f.dudy, second ? f.dv1dy : f.dvdy};
  texture::Lookups lookups = lookups_of(slot, uv, f.count, scratch);
  if (!has_footprint) lookups.dudx = lookups.dvdx = lookups.dudy = lookups.dvdy = nullptr;
  return lookups;
}

Parameters complete(const Parameters& parameters) {
  Parameters all = parameters;
  for (auto& slot : all.value) {
    for (const float*& column : slot) column = column ? column : kOnes.value;
  }
  return all;
}

const Parameters& unset_parameters() {
  return kUnset;
}

void find_levels(const core::SimdTarget& simd, const Material& material, const raster::Fragments& fragments,
                 const float object_to_world[16], float* const scratch[kLookupScratch], float* lod) {
  const Slot& slot = material.slot[SHD_SLOT_DIFFUSE];
  std::fill_n(lod, fragments.count, 0.0f);
  if (!has_slot(material, SHD_SLOT_DIFFUSE) || !slot.texture) return;
  const auto find = [&](const texture::Lookups& lookups, float* out) {
    texture::find_lods(*slot.texture, *slot.sampler, texture::lod_range(*slot.texture, *slot.sampler),
                       texture::LodAxis::kLonger, simd, lookups, out);
  };
  if (!is_triplanar(slot)) return find(lookups_of(slot, fragments, object_to_world, true, scratch), lod);
  blend_axes(slot, fragments, object_to_world, true, scratch, {lod, nullptr, nullptr, nullptr},
             [&](const texture::Lookups& lookups, float* const(&part)[4]) { find(lookups, part[0]); });
}

}  // namespace shd::material
