// SPDX-License-Identifier: MIT
#include "lights.h"

#include <algorithm>
#include <cmath>

#include "patterns.h"

namespace viewer {
namespace {

constexpr float kPi = 3.14159265f;
constexpr float kShadowReach = 2.5f;  // [radii] around the model

shd::light make_key(shd_context* context, const Lighting& lighting, float factor) {
  const float az = lighting.azimuth * kPi / 180.0f, el = lighting.elevation * kPi / 180.0f;
  shd::light_desc desc;
  desc.kind = SHD_LIGHT_KIND_DIRECTIONAL;
  desc.direction[0] = -std::cos(el) * std::sin(az);
  desc.direction[1] = -std::sin(el);
  desc.direction[2] = -std::cos(el) * std::cos(az);
  constexpr float kWarm[3] = {1.0f, 0.95f, 0.87f};
  for (size_t c = 0; c < 3; ++c) desc.intensity[c] = factor * lighting.intensity * kWarm[c];
  return shd::light_create(context, &desc);
}

shd::light make_ambient(shd_context* context, float intensity) {
  shd::light_desc desc;
  desc.kind = SHD_LIGHT_KIND_AMBIENT;
  std::fill(desc.intensity, desc.intensity + 3, intensity);
  return shd::light_create(context, &desc);
}

shd::shadow make_shadow(shd_context* context, const shd_light* light, const Assets& assets) {
  std::vector<shd_draw> draws;
  for (const Part& part : assets.parts) {
    if (assets.surfaces[part.surface].is_floor) continue;
    draws.push_back(shd_draw_default());
    draws.back().mesh = part.mesh;
    std::copy(part.object_to_world.begin(), part.object_to_world.end(), draws.back().object_to_world);
  }
  shd::shadow_desc desc;
  desc.size = 2048;
  desc.filter = SHD_SHADOW_FILTER_PCSS;
  desc.taps = 7;
  desc.light_size = 0.14f;
  desc.normal_offset = 0.004f * assets.bounds.radius;
  shd::shadow_render_desc render;
  render.light = light;
  render.draws = draws.data(), render.draw_count = draws.size();
  for (size_t c = 0; c < 3; ++c) {
    render.bounds_min[c] = assets.bounds.center[c] - kShadowReach * assets.bounds.radius;
    render.bounds_max[c] = assets.bounds.center[c] + kShadowReach * assets.bounds.radius;
  }
  shd::shadow shadow = shd::shadow_create(context, &desc);
  shd::shadow_render(context, shadow, &render);
  return shadow;
}

shd::environment make_environment(shd_context* context, const std::string& name) {
  if (name == "none") return shd::environment();
  return name == "studio" ? make_studio(context) : load_environment(context, name);
}

}  // namespace

void Lights::prepare(shd_context* context, const Lighting& lighting, const Assets& assets, bool assets_changed) {
  if (lighting_ && *lighting_ == lighting && !assets_changed) return;
  lighting_.reset();  // stays empty if something throws
  if (!environment_name_ || *environment_name_ != lighting.environment) {
    environment_name_.reset();
    environment_ = make_environment(context, lighting.environment);
    environment_name_ = lighting.environment;
  }
  for (int i = 0; i < 2; ++i) {
    sets_[i].key = make_key(context, lighting, i == 1 ? kPi : 1.0f);
    sets_[i].ambient = make_ambient(context, lighting.ambient);
    sets_[i].list[0] = sets_[i].key, sets_[i].list[1] = sets_[i].ambient;
  }
  shadow_ = lighting.shadows ? make_shadow(context, sets_[0].key, assets) : shd::shadow();
  shadows_[0] = shadow_;
  lighting_ = lighting;
}

void Lights::set(bool over_pi, shd_render_desc& frame) const {
  frame.lights = sets_[over_pi].list, frame.light_count = 2;
  frame.shadows = shadow_ ? shadows_ : nullptr;
  constexpr float kBackdrop[4] = {0.40f, 0.41f, 0.43f, 1.0f};
  std::copy(kBackdrop, kBackdrop + 4, frame.clear_color);
  if (!environment_) return;
  // The other models do not divide by pi, so their environment is that much darker.
  frame.environment = environment_;
  frame.environment_intensity = lighting_->environment_intensity * (over_pi ? 1.0f : 1.0f / kPi);
  if (lighting_->environment == "studio") return;
  frame.background = SHD_BACKGROUND_ENVIRONMENT;
}

}  // namespace viewer
