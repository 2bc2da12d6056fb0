// SPDX-License-Identifier: MIT
#include "abi/volume.h"

#include <cstdio>
#include <cstring>

#include "abi/desc.h"
#include "abi/draws.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "data/column.h"
#include "volume/volume.h"

namespace shd::abi {
namespace {

constexpr core::ObjectType kVolumeType = core::ObjectType::kVolume;
constexpr uint64_t kMaxVolumes = 1024;

/// A column of values of the points, each in [low, high].
shd_result check_points(const char* field, const shd_f32_in& column, uint32_t count, double low, double high) {
  SHD_TRY(check_column(field, column, count));
  for (uint32_t i = 0; column.data && i < count; ++i) {
    char name[48];
    std::snprintf(name, sizeof name, "%s[%u]", field, i);
    SHD_TRY(check_range(name, static_cast<double>(data::load(column, i)), low, high));
  }
  return SHD_OK;
}

shd_result check_transfer(const shd_volume_desc& desc) {
  constexpr double kLargest = 1e38;  // differences are finite
  SHD_TRY(check_count("volume.point_count", desc.point_count, 1, volume::kMaxPoints));
  SHD_TRY(check_not_null("volume.density.data", desc.density.data));
  SHD_TRY(check_not_null("volume.extinction.data", desc.extinction.data));
  SHD_TRY(check_points("volume.density", desc.density, desc.point_count, -kLargest, kLargest));
  SHD_TRY(check_points("volume.extinction", desc.extinction, desc.point_count, 0.0, 1e12));
  for (int c = 0; c < 3; ++c) {
    char name[32];
    std::snprintf(name, sizeof name, "volume.color[%d]", c);
    SHD_TRY(check_points(name, desc.color[c], desc.point_count, 0.0, 1e6));
  }
  for (uint32_t i = 1; i < desc.point_count; ++i) {
    const float before = data::load(desc.density, i - 1), own = data::load(desc.density, i);
    if (own >= before) continue;
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "volume.density[%u]: %g is below volume.density[%u], %g", i,
                      double{own}, i - 1, double{before});
  }
  return SHD_OK;
}

shd_result check_volume_desc(const shd_volume_desc& desc) {
  SHD_TRY(check_transfer(desc));
  SHD_TRY(check_finite("volume.bounds_min", desc.bounds_min, 3));
  SHD_TRY(check_finite("volume.bounds_max", desc.bounds_max, 3));
  for (int c = 0; c < 3; ++c) {
    if (desc.bounds_min[c] < desc.bounds_max[c]) continue;
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "volume.bounds_max[%d]: %g is not above volume.bounds_min[%d], %g", c,
                      double{desc.bounds_max[c]}, c, double{desc.bounds_min[c]});
  }
  if (!(desc.step > 0.0f && desc.step <= 1e12f)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "volume.step: %g is not above 0 and at most 1e+12",
                      double{desc.step});
  }
  return check_range("volume.jitter", double{desc.jitter}, 0.0, 1.0);
}

/// Whether a material can shade points that have no surface.
shd_result check_material(const material::Material& material) {
  if (material.model == SHD_MODEL_PROGRAM || material::info_of(material.model).lobes == 0) {
    return core::fail(SHD_ERROR_UNSUPPORTED, "volume.material: its model or debug view reflects no light");
  }
  if (material.slots != 0) return core::fail(SHD_ERROR_UNSUPPORTED, "volume.material: it has slots");
  if (material.blend != SHD_BLEND_OPAQUE) {
    return core::fail(SHD_ERROR_UNSUPPORTED, "volume.material: its blend is %d, not SHD_BLEND_OPAQUE",
                      static_cast<int>(material.blend));
  }
  return SHD_OK;
}

shd_result fill(const core::Context& context, const shd_volume_desc& desc, volume::Volume* out) {
  SHD_TRY(check_not_null("volume.texture", desc.texture));
  SHD_TRY(retain_part("volume.texture", desc.texture, core::ObjectType::kTexture, &out->texture, &out->texture_object));
  if (out->texture->depth == 0) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "volume.texture: its depth is 0, so it is not a 3D texture");
  }
  out->material = nullptr;
  SHD_TRY(retain_part("volume.material", desc.material, core::ObjectType::kMaterial, &out->material,
                      &out->material_object));
  if (out->material) SHD_TRY(check_material(*out->material));
  volume::build(context, desc, out);
  return SHD_OK;
}

shd_result read_volume(const shd_volume_draw* in, frame::VolumeDraw* out) {
  shd_volume_draw draw = shd_volume_draw_default();
  SHD_TRY(read_desc("volume", in, false, &draw));
  SHD_TRY(read_handle("volume.volume", draw.volume, kVolumeType, &out->volume));
  SHD_TRY(check_matrix("volume.object_to_world", draw.object_to_world));
  if (volume::make_world_to_box(draw.object_to_world, out->volume->box_min, out->volume->box_max, &out->world_to_box)) {
    return SHD_OK;
  }
  return core::fail(SHD_ERROR_INVALID_ARGUMENT, "volume.object_to_world: it cannot be inverted");
}

}  // namespace

shd_result read_volumes(const shd_volume_draw* draws, size_t count, core::Buffer<frame::VolumeDraw>* out) {
  SHD_TRY(check_count("render.volume_count", count, 0, kMaxVolumes));
  if (count == 0) return SHD_OK;
  SHD_TRY(check_not_null("render.volumes", draws));
  const auto* bytes = reinterpret_cast<const char*>(draws);
  const uint32_t stride = core::struct_size_of(bytes);
  for (size_t i = 0; i < count; ++i) {
    const char* draw = bytes + i * stride;
    if (core::struct_size_of(draw) != stride) {
      return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                        "render.volumes[%zu].struct_size: %u differs from that of volumes[0], %u", i,
                        core::struct_size_of(draw), stride);
    }
    frame::VolumeDraw read = {};
    SHD_TRY(in_element(read_volume(reinterpret_cast<const shd_volume_draw*>(draw), &read), "render", "volumes", i));
    out->push_back(read);
  }
  return SHD_OK;
}

}  // namespace shd::abi

extern "C" {

using namespace shd;
using namespace shd::abi;

shd_result shd_volume_create(shd_context* context, const shd_volume_desc* desc, shd_volume** out_volume) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_volume", out_volume));
    *out_volume = nullptr;
    SHD_TRY(check_context(context));
    shd_volume_desc read = shd_volume_desc_default();
    SHD_TRY(read_desc("volume", desc, false, &read));
    SHD_TRY(check_volume_desc(read));
    core::Context& owner = context_of(context);
    return create_handle<volume::Volume>(
        owner, kVolumeType, [&](volume::Volume* body) { return fill(owner, read, body); }, out_volume);
  });
}

void shd_volume_retain(shd_volume* volume) {
  retain_handle(volume, kVolumeType);
}

void shd_volume_release(shd_volume* volume) {
  release_handle(volume, kVolumeType);
}

}  // extern "C"
