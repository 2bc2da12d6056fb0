// SPDX-License-Identifier: MIT
#include "light/light.h"

#include <algorithm>
#include <cmath>

#include "data/trig.h"
#include "data/vec3.h"

namespace shd::light {
namespace {

using data::Vec3;

void store(Vec3 from, float to[3]) {
  to[0] = 0.0f + from.x;  // the sum removes -0
  to[1] = 0.0f + from.y;
  to[2] = 0.0f + from.z;
}

/// Sets the axes of a light from its direction; up is the desc's vector orthogonalised against the direction.
void set_axes(const shd_light_desc& desc, Light* light) {
  const Vec3 way = data::normalized(Vec3{desc.direction[0], desc.direction[1], desc.direction[2]});
  const Vec3 back = {0.0f - way.x, 0.0f - way.y, 0.0f - way.z};
  const Vec3 wanted = data::normalized(Vec3{desc.up[0], desc.up[1], desc.up[2]});
  Vec3 right = data::cross(wanted, back);
  if (!(data::dot(right, right) > 1e-8f)) {
    const bool along_x = std::fabs(back.x) > 0.5f;
    right = data::cross(along_x ? Vec3{0.0f, 0.0f, 1.0f} : Vec3{1.0f, 0.0f, 0.0f}, back);
  }
  right = data::normalized(right);
  store(back, light->to_light);
  store(right, light->right);
  store(data::normalized(data::cross(back, right)), light->up);
}

void set_cone(const shd_light_desc& desc, Light* light) {
  light->cone_start = static_cast<float>(data::cos(desc.outer_angle));
  // The cosines of the narrowest cones differ by only 5e-7, so that the rounding of the start matters; 2^-24 is one
  // step.
  const double width = data::cos(desc.inner_angle) - double{light->cone_start};
  light->cone_scale = static_cast<float>(1.0 / std::max(width, 0x1p-24));
  light->outer_tangent = static_cast<float>(data::tan(std::min(double{desc.outer_angle}, 1.57)));
}

}  // namespace

LightBody::~LightBody() {
  core::release(texture_object, static_cast<uint32_t>(core::ObjectType::kTexture));
  core::release(sampler_object, static_cast<uint32_t>(core::ObjectType::kSampler));
}

Light make_light(const shd_light_desc& desc, const texture::Texture* cookie, const texture::Sampler* cookie_sampler) {
  Light light = {};
  light.kind = desc.kind;
  for (int c = 0; c < 3; ++c) light.intensity[c] = desc.intensity[c];
  const bool is_local = desc.kind == SHD_LIGHT_KIND_POINT || desc.kind == SHD_LIGHT_KIND_SPOT;
  const bool is_aimed = desc.kind == SHD_LIGHT_KIND_DIRECTIONAL || desc.kind == SHD_LIGHT_KIND_SPOT;
  if (is_local || (is_aimed && cookie)) {
    for (int c = 0; c < 3; ++c) light.position[c] = desc.position[c];
  }
  if (is_local && desc.range > 0.0f) {
    light.range = desc.range;
    light.inverse_range_squared = static_cast<float>(1.0 / (double{desc.range} * desc.range));
  }
  if (is_aimed) set_axes(desc, &light);
  if (desc.kind == SHD_LIGHT_KIND_SPOT) set_cone(desc, &light);
  if (!cookie) return light;
  light.cookie = cookie;
  light.cookie_sampler = cookie_sampler;
  for (int c = 0; c < 2; ++c) {
    light.cookie_scale[c] = desc.kind == SHD_LIGHT_KIND_SPOT ? 1.0f / light.outer_tangent : 2.0f / desc.extent[c];
  }
  return light;
}

texture::Sampler default_sampler() {
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = SHD_FILTER_BILINEAR;
  desc.wrap_u = desc.wrap_v = SHD_WRAP_BORDER;
  for (float& channel : desc.border) channel = 0.0f;
  return texture::make_sampler(desc);
}

}  // namespace shd::light
