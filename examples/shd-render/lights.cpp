// SPDX-License-Identifier: MIT
#include "lights.h"

#include "failure.h"

namespace {

void add_light(shd_context* context, const shd_light_desc& desc, std::vector<Light>& out) {
  Light light;
  check(shd_light_create(context, &desc, light.out()), "light");
  out.push_back(std::move(light));
}

/// Light from `from` in the camera's frame: right, up, back.
void add_view_light(shd_context* context, const Camera& camera, const float from[3], const float color[3],
                    std::vector<Light>& out) {
  shd_light_desc desc = shd_light_desc_default();
  desc.kind = SHD_LIGHT_DIRECTIONAL;
  for (size_t c = 0; c < 3; ++c) {
    desc.direction[c] = -(from[0] * camera.right[c] + from[1] * camera.up[c] + from[2] * camera.back[c]);
    desc.intensity[c] = color[c];
  }
  add_light(context, desc, out);
}

struct PresetLight {
  float from[3], color[3];
};

// Warm key from the upper left, cool fill from the right, white rim from behind.
constexpr PresetLight kStudio[] = {{{-0.6f, 0.8f, 0.7f}, {1.5f, 1.42f, 1.3f}},
                                   {{0.9f, 0.1f, 0.5f}, {0.3f, 0.34f, 0.42f}},
                                   {{0.4f, 0.7f, -0.8f}, {0.5f, 0.5f, 0.5f}}};
constexpr PresetLight kHeadlight[] = {{{0.0f, 0.0f, 1.0f}, {1.5f, 1.5f, 1.5f}}};

}  // namespace

std::vector<Light> make_lights(shd_context* context, const Options& options, const Bounds& bounds,
                               const Camera& camera) {
  std::vector<Light> lights;
  if (options.preset == LightPreset::kStudio) {
    for (const PresetLight& light : kStudio) add_view_light(context, camera, light.from, light.color, lights);
  } else if (options.preset == LightPreset::kHeadlight) {
    for (const PresetLight& light : kHeadlight) add_view_light(context, camera, light.from, light.color, lights);
  }
  for (const LightOption& option : options.lights) {
    shd_light_desc desc = shd_light_desc_default();
    desc.kind = option.directional ? SHD_LIGHT_DIRECTIONAL : SHD_LIGHT_POINT;
    for (size_t c = 0; c < 3; ++c) {
      desc.direction[c] = -option.place[c];
      desc.position[c] = bounds.center[c] + bounds.radius * option.place[c];
      desc.intensity[c] = option.color[c] * (option.directional ? 1.0f : bounds.radius * bounds.radius);
    }
    if (!option.directional) {
      for (float& c : desc.direction) c = 1.0f;  // unused, but must not be 0
    }
    add_light(context, desc, lights);
  }
  shd_light_desc ambient = shd_light_desc_default();
  ambient.kind = SHD_LIGHT_AMBIENT;
  for (size_t c = 0; c < 3; ++c) ambient.intensity[c] = options.ambient[c];
  add_light(context, ambient, lights);
  return lights;
}
