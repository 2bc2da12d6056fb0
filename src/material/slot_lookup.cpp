// SPDX-License-Identifier: MIT
#include "material/slot_lookup.h"

#include <algorithm>

#include "texture/footprint/lod.h"

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

}  // namespace

texture::Lookups lookups_of(const Slot& slot, const float* const (&uv)[6], size_t count, float* const scratch[6]) {
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

texture::Lookups lookups_of(const Slot& slot, const raster::Fragments& f, bool has_footprint, float* const scratch[6]) {
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
                 float* const scratch[6], float* lod) {
  const Slot& slot = material.slot[SHD_SLOT_DIFFUSE];
  std::fill_n(lod, fragments.count, 0.0f);
  if (!has_slot(material, SHD_SLOT_DIFFUSE) || !slot.texture) return;
  texture::find_lods(*slot.texture, *slot.sampler, texture::lod_range(*slot.texture, *slot.sampler),
                     texture::LodAxis::kLonger, simd, lookups_of(slot, fragments, true, scratch), lod);
}

}  // namespace shd::material
