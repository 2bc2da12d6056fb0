// SPDX-License-Identifier: MIT
#include <shd/light.h>

#include "abi/desc.h"
#include "abi/guard.h"
#include "abi/handle.h"
#include "light/light.h"

namespace {

using namespace shd;
using namespace shd::abi;

constexpr core::ObjectType kType = core::ObjectType::kLight;

shd_result check_light_desc(const shd_light_desc& desc) {
  SHD_TRY(check_enum("light.kind", desc.kind, SHD_LIGHT_POINT, SHD_LIGHT_AMBIENT));
  SHD_TRY(check_values("light.intensity", desc.intensity, 3, 0.0, 1e12));
  SHD_TRY(check_finite("light.position", desc.position, 3));
  SHD_TRY(check_finite("light.direction", desc.direction, 3));
  const float* d = desc.direction;
  if (desc.kind == SHD_LIGHT_DIRECTIONAL && d[0] == 0.0f && d[1] == 0.0f && d[2] == 0.0f) {
    return core::fail(SHD_ERROR_INVALID_ARGUMENT, "light.direction: (0, 0, 0) has no direction");
  }
  return check_zero("light.reserved", desc.reserved);
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
    make_handle(owner, kType, core::create<light::Light>(owner.allocator, light::make_light(read)), out_light);
    return SHD_OK;
  });
}

void shd_light_retain(shd_light* light) {
  retain_handle(light, kType);
}

void shd_light_release(shd_light* light) {
  release_handle(light, kType);
}

}  // extern "C"
