// SPDX-License-Identifier: MIT
#include "tool/lights.h"

#include <algorithm>
#include <cmath>

#include "command/failure.h"
#include "tool/materials.h"
#include "tool/textures.h"

namespace {

void add_light(shd_context* context, const shd_light_desc& desc, std::vector<StageLight>& out, bool casts = true) {
  StageLight light;
  check(shd_light_create(context, &desc, light.light.out()), "light");
  light.casts = casts;
  light.kind = desc.kind;
  out.push_back(std::move(light));
}

void add_ambient(shd_context* context, const Options& options, std::vector<StageLight>& out) {
  shd_light_desc ambient = shd_light_desc_default();
  ambient.kind = SHD_LIGHT_KIND_AMBIENT;
  for (size_t c = 0; c < 3; ++c) ambient.intensity[c] = (*options.ambient)[c];
  add_light(context, ambient, out, false);
}

/// State that the lights of one frame share.
struct Lighting {
  shd_context* context;
  const Options& options;
  const Bounds& bounds;
  const Camera& camera;
  float exposure;
};

/// Adds a light at `from` in the camera's frame: right, up, back.
void add_view_light(const Lighting& lighting, const float from[3], const float color[3], std::vector<StageLight>& out) {
  const Camera& camera = lighting.camera;
  shd_light_desc desc = shd_light_desc_default();
  desc.kind = SHD_LIGHT_KIND_DIRECTIONAL;
  for (size_t c = 0; c < 3; ++c) {
    desc.direction[c] = -(from[0] * camera.right[c] + from[1] * camera.up[c] + from[2] * camera.back[c]);
    desc.intensity[c] = lighting.exposure * color[c];
  }
  add_light(lighting.context, desc, out);
}

struct PresetLight {
  float from[3], color[3];
};

// A warm key light from the upper left, a cool fill light from the right, a white rim light from behind.
constexpr PresetLight kStudio[] = {{{-0.6f, 0.8f, 0.7f}, {1.5f, 1.42f, 1.3f}},
                                   {{0.9f, 0.1f, 0.5f}, {0.3f, 0.34f, 0.42f}},
                                   {{0.4f, 0.7f, -0.8f}, {0.5f, 0.5f, 0.5f}}};
constexpr PresetLight kHeadlight[] = {{{0.0f, 0.0f, 1.0f}, {1.5f, 1.5f, 1.5f}}};

/// The two points of `examples/course --lights notes`, which are placed around a model of radius 3.
constexpr float kCourseLights[2][3] = {{30.0f, 50.0f, 20.0f}, {-30.0f, 50.0f, 0.0f}};
constexpr float kCourseIntensity = 500.0f;

void add_course_lights(const Lighting& lighting, std::vector<StageLight>& out) {
  const float unit = lighting.bounds.radius / 3.0f;
  for (const auto& position : kCourseLights) {
    shd_light_desc desc = shd_light_desc_default();
    for (size_t c = 0; c < 3; ++c) {
      desc.position[c] = lighting.bounds.center[c] + unit * position[c];
      desc.intensity[c] = kCourseIntensity * (lighting.exposure * unit * unit);
    }
    add_light(lighting.context, desc, out);
  }
}

void add_option_light(const Lighting& lighting, const LightOption& option, shd_texture* cookie,
                      std::vector<StageLight>& out) {
  const Bounds& bounds = lighting.bounds;
  const float falloff = option.kind == SHD_LIGHT_KIND_DIRECTIONAL ? 1.0f : bounds.radius * bounds.radius;
  shd_light_desc desc = shd_light_desc_default();
  desc.kind = option.kind;
  for (size_t c = 0; c < 3; ++c) {
    if (option.kind != SHD_LIGHT_KIND_POINT) desc.direction[c] = -option.place[c];
    desc.position[c] = bounds.center[c] + bounds.radius * option.place[c];
    desc.intensity[c] = lighting.exposure * falloff * option.color[c];
  }
  if (option.kind == SHD_LIGHT_KIND_SPOT) {
    desc.inner_angle = lighting.options.inner_cone * kDegree;
    desc.outer_angle = lighting.options.cone * kDegree;
    desc.texture = cookie;
  }
  add_light(lighting.context, desc, out);
}

/// Adds small lights of all colours on a spiral around the model, from the floor to its top.
void add_lamps(const Lighting& lighting, std::vector<StageLight>& out) {
  const auto count = static_cast<float>(lighting.options.lamps);
  const Bounds& bounds = lighting.bounds;
  for (uint32_t i = 0; i < lighting.options.lamps; ++i) {
    const float part = (static_cast<float>(i) + 0.5f) / count, turn = 2.39996f * static_cast<float>(i);
    const float away = bounds.radius * (0.25f + 2.5f * std::sqrt(part));
    shd_light_desc desc = shd_light_desc_default();
    desc.position[0] = bounds.center[0] + away * std::cos(turn);
    desc.position[1] = bounds.bottom + 0.12f * bounds.radius;
    desc.position[2] = bounds.center[2] + away * std::sin(turn);
    desc.range = 0.9f * bounds.radius;
    for (size_t c = 0; c < 3; ++c) {
      const float wave = 0.5f + 0.5f * std::cos(1.7f * turn + 2.0944f * static_cast<float>(c));
      desc.intensity[c] = lighting.exposure * 0.06f * bounds.radius * bounds.radius * wave * wave;
    }
    add_light(lighting.context, desc, out, false);
  }
}

Texture make_cookie(shd_context* context, const std::string& name) {
  if (name.empty()) return Texture();
  return name == "window" ? make_window(context) : load_texture(context, name, false);
}

/// Adds the lights of the model's file, with the intensities of the file.
void add_file_lights(const Lighting& lighting, const shd_scene* scene, std::vector<StageLight>& out) {
  shd_scene_info info = shd_scene_info_default();
  if (!scene || shd_scene_get_info(scene, &info) != SHD_OK || info.light_count == 0) {
    throw Failure(kExitInput, "--lights file: the model has no lights");
  }
  for (uint32_t i = 0; i < info.light_count; ++i) {
    shd_light_desc desc = shd_light_desc_default();
    check(shd_scene_get_light_desc(scene, i, &desc), "light");
    for (float& c : desc.intensity) c *= lighting.options.exposure;
    add_light(lighting.context, desc, out, desc.kind != SHD_LIGHT_KIND_AMBIENT);
  }
}

}  // namespace

std::vector<StageLight> make_lights(shd_context* context, const Options& options, const Model& scene,
                                    const Bounds& bounds, const Camera& camera) {
  const shd_model model = model_of(options, scene);
  // Energy-conserving models reflect E / pi where the other models reflect E.
  const bool over_pi = model == SHD_MODEL_METALLIC_ROUGHNESS || model == SHD_MODEL_BLINN_PHONG_NORMALIZED;
  const Lighting lighting{context, options, bounds, camera, options.exposure * (over_pi ? 3.14159265f : 1.0f)};
  std::vector<StageLight> lights;
  if (options.preset == LightPreset::kStudio) {
    for (const PresetLight& light : kStudio) add_view_light(lighting, light.from, light.color, lights);
  } else if (options.preset == LightPreset::kHeadlight) {
    for (const PresetLight& light : kHeadlight) add_view_light(lighting, light.from, light.color, lights);
  } else if (options.preset == LightPreset::kCourse) {
    add_course_lights(lighting, lights);
  }
  if (options.preset == LightPreset::kFile) add_file_lights(lighting, scene.scene.get(), lights);
  add_ambient(context, options, lights);
  const Texture cookie = make_cookie(context, options.cookie);
  for (const LightOption& option : options.lights) add_option_light(lighting, option, cookie.get(), lights);
  add_lamps(lighting, lights);
  if (options.term == Term::kAll) return lights;
  const auto is_other = [&options](const StageLight& light) {
    return (light.kind == SHD_LIGHT_KIND_AMBIENT) != (options.term == Term::kAmbient);
  };
  lights.erase(std::remove_if(lights.begin(), lights.end(), is_other), lights.end());
  return lights;
}
