// SPDX-License-Identifier: MIT
#include <shd/light.h>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "abi/lookup.h"
#include "light/light.h"

namespace {

using namespace shd;
using namespace shd::abi;

constexpr core::ObjectType kLightType = core::ObjectType::kLight;
// As floats, which descs hold.
constexpr double kMinLength = static_cast<double>(1e-6f), kMinAngle = static_cast<double>(1e-3f);
constexpr double kRightAngle = 1.5707964;  // pi / 2 rounded up

shd_result check_cone(const shd_light_desc& desc) {
  SHD_TRY(check_range("light.outer_angle", double{desc.outer_angle}, kMinAngle, desc.texture ? 1.55 : kRightAngle));
  return check_range("light.inner_angle", double{desc.inner_angle}, 0.0, double{desc.outer_angle});
}

shd_result check_texture(const shd_light_desc& desc) {
  if (desc.sampler && !desc.texture) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "light.sampler: set, but light.texture is NULL");
  }
  if (desc.texture && desc.kind != SHD_LIGHT_KIND_SPOT && desc.kind != SHD_LIGHT_KIND_DIRECTIONAL) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT,
                      "light.texture: set, but the kind is neither SHD_LIGHT_KIND_SPOT nor SHD_LIGHT_KIND_DIRECTIONAL");
  }
  return SHD_OK;
}

shd_result check_light_desc(const shd_light_desc& desc) {
  SHD_TRY(check_enum("light.kind", desc.kind, SHD_LIGHT_KIND_POINT, SHD_LIGHT_KIND_SPOT));
  SHD_TRY(check_values("light.intensity", desc.intensity, 3, 0.0, 1e12));
  SHD_TRY(check_finite("light.position", desc.position, 3));
  SHD_TRY(check_finite("light.direction", desc.direction, 3));
  SHD_TRY(check_finite("light.up", desc.up, 3));
  if ((desc.kind == SHD_LIGHT_KIND_DIRECTIONAL || desc.kind == SHD_LIGHT_KIND_SPOT) && is_zero(desc.direction)) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "light.direction: (0, 0, 0) has no direction");
  }
  if (desc.range != 0.0f) SHD_TRY(check_range("light.range", double{desc.range}, kMinLength, 1e12));
  SHD_TRY(check_cone(desc));
  SHD_TRY(check_values("light.extent", desc.extent, 2, kMinLength, 1e12));
  return check_texture(desc);
}

shd_result fill(const shd_light_desc& desc, light::LightBody* out) {
  const texture::Texture* texture = nullptr;
  out->default_sampler = light::default_sampler();
  const texture::Sampler* sampler = &out->default_sampler;
  SHD_TRY(retain_part("light.texture", desc.texture, core::ObjectType::kTexture, &texture, &out->texture_object));
  SHD_TRY(retain_part("light.sampler", desc.sampler, core::ObjectType::kSampler, &sampler, &out->sampler_object));
  if (texture) SHD_TRY(check_flat("light.texture", *texture));
  if (texture) SHD_TRY(check_use(*texture, *sampler));
  out->light = light::make_light(desc, texture, sampler);
  return SHD_OK;
}

}  // namespace

extern "C" {

shd_result shd_light_create(shd_context* context, const shd_light_desc* desc, shd_light** out_light) {
  return guard([&]() -> shd_result {
    SHD_TRY(check_not_null("out_light", out_light));
    *out_light = nullptr;
    SHD_TRY(check_context(context));
    shd_light_desc read = shd_light_desc_default();
    SHD_TRY(read_desc("light", desc, true, &read));
    SHD_TRY(check_light_desc(read));
    core::Context& owner = context_of(context);
    return create_handle<light::LightBody>(
        owner, kLightType, [&](light::LightBody* body) { return fill(read, body); }, out_light);
  });
}

void shd_light_retain(shd_light* light) {
  retain_handle(light, kLightType);
}

void shd_light_release(shd_light* light) {
  release_handle(light, kLightType);
}

}  // extern "C"
