// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "scene/read/gltf_document.h"

namespace shd::scene::gltf {
namespace {

/// KHR_lights_punctual. Candela and lux count as intensities of shd.
void read_light(const Part& from, shd_light_desc& desc) {
  const std::string type = from.text("type");
  if (type == "directional") {
    desc.kind = SHD_LIGHT_KIND_DIRECTIONAL;
  } else if (type == "point") {
    desc.kind = SHD_LIGHT_KIND_POINT;
  } else if (type == "spot") {
    desc.kind = SHD_LIGHT_KIND_SPOT;
  } else {
    from.refuse("type \"" + type + "\" is not supported", SHD_ERROR_UNSUPPORTED);
  }
  std::array<float, 3> color = {1, 1, 1};
  from.numbers("color", color);
  const double intensity = from.number("intensity", 1.0, 0.0, 1e12);
  for (size_t c = 0; c < 3; ++c) {
    desc.intensity[c] = static_cast<float>(static_cast<double>(color[c]) * intensity);
    if (!(desc.intensity[c] >= 0.0f && desc.intensity[c] <= 1e12f)) from["color"].refuse("is out of range");
  }
  desc.direction[0] = desc.direction[1] = 0.0f;
  desc.direction[2] = -1.0f;
  if (desc.kind != SHD_LIGHT_KIND_DIRECTIONAL) desc.range = from.number_f("range", 0.0f, 0.0);
  if (desc.kind != SHD_LIGHT_KIND_SPOT) return;
  const Part spot = from["spot"];
  constexpr float kRight = 1.57079633f;
  desc.outer_angle = std::clamp(spot.number_f("outerConeAngle", 0.785398163f), 0.001f, kRight);
  desc.inner_angle = std::clamp(spot.number_f("innerConeAngle", 0.0f), 0.0f, desc.outer_angle);
}

/// Section 5.13: a camera looks along -z.
void read_camera(const Part& from, shd_camera& camera) {
  const Part perspective = from["perspective"];
  if (from.text("type") != "perspective" || !perspective) {
    from.refuse("it has no perspective", SHD_ERROR_UNSUPPORTED);
  }
  camera.fov_y = perspective.number_f("yfov", 0.0f, 1e-3, 3.14);
  if (!(camera.fov_y > 0.0f)) perspective.refuse("has no yfov");
  camera.aspect = perspective.number_f("aspectRatio", 0.0f);
  if (!(camera.aspect > 1e-3f && camera.aspect < 1e3f)) camera.aspect = 0.0f;
  camera.near_plane = perspective.number_f("znear", 0.0f, 0.0);
  camera.far_plane = perspective.number_f("zfar", 0.0f, 0.0);
  camera.eye[2] = 0.0f;
  camera.target[2] = -1.0f;
}

/// The name of a part, or of the node at which it stands.
std::string name_at(Document& document, const Part& part, uint32_t node) {
  const bool named = part["name"] && part["name"].json()->is_string();
  const std::string& other = document.model.nodes[node].name;
  return named || other.empty() ? name_of(part) : other;
}

struct Path {
  const char* name;
  Target target;
  uint32_t components;  // 0: weights, one for each morph target
};

constexpr Path kPaths[] = {{"translation", Target::kTranslation, 3},
                           {"rotation", Target::kRotation, 4},
                           {"scale", Target::kScale, 3},
                           {"weights", Target::kWeights, 0}};

Interpolation interpolation_of(const Part& sampler) {
  const std::string text = sampler["interpolation"] ? sampler.text("interpolation") : "LINEAR";
  if (text == "STEP") return Interpolation::kStep;
  if (text == "LINEAR") return Interpolation::kLinear;
  if (text == "CUBICSPLINE") return Interpolation::kCubicSpline;
  sampler.refuse("interpolation \"" + text + "\" is not supported", SHD_ERROR_UNSUPPORTED);
}

std::vector<float> read_keys(Document& document, const Part& reference, uint32_t components, bool normalized) {
  Accessor accessor = open_accessor(document, reference);
  if (accessor.components != components) {
    reference.refuse("its elements have " + std::to_string(accessor.components) + " components, not " +
                     std::to_string(components));
  }
  if (normalized) accessor.normalized = accessor.component_type != kFloat;
  spend_bytes(document, uint64_t{accessor.count} * components * sizeof(float));
  std::vector<float> out = read_floats(accessor);
  for (const float number : out) {
    if (!std::isfinite(number)) reference.refuse("has numbers that are not finite");
  }
  return out;
}

/// Appendix C. Integers of rotations and weights are normalised (section 3.11).
void read_channel(Document& document, const Part& sampler, const Path& path, Channel& channel) {
  channel.target = path.target;
  channel.interpolation = interpolation_of(sampler);
  const Part input = sampler["input"], output = sampler["output"];
  channel.times = read_keys(document, input, 1, false);
  const bool unit = path.target == Target::kRotation || path.target == Target::kWeights;
  channel.values = read_keys(document, output, std::max(path.components, 1u), unit);
  const size_t each = channel.interpolation == Interpolation::kCubicSpline ? 3 : 1;
  const size_t keys = channel.times.size() * each;
  if (keys == 0) input.refuse("has no keys");
  const bool fits = path.components ? channel.values.size() == keys * path.components
                                    : !channel.values.empty() && channel.values.size() % keys == 0;
  if (!fits) output.refuse("has another number of keys than its input");
  for (size_t i = 1; i < channel.times.size(); ++i) {
    if (!(channel.times[i] > channel.times[i - 1])) input.refuse("its times do not increase");
  }
}

void add_channel(Document& document, const Part& from, const Part& samplers, const std::vector<int32_t>& node_of,
                 Animation& animation) {
  const Part target = from["target"];
  const std::optional<uint32_t> node = target.index("node", node_of.size());
  const std::optional<uint32_t> sampler = from.index("sampler", samplers.size());
  if (!node || node_of[*node] < 0) return;
  const std::string text = target.text("path");
  const auto path = std::find_if(std::begin(kPaths), std::end(kPaths), [&](const Path& p) { return text == p.name; });
  if (path == std::end(kPaths)) target.refuse("path \"" + text + "\" is not supported", SHD_ERROR_UNSUPPORTED);
  if (!sampler) from.refuse("has no sampler");
  Channel channel;
  channel.node = static_cast<uint32_t>(node_of[*node]);
  read_channel(document, samplers.at(*sampler), *path, channel);
  animation.channels.push_back(std::move(channel));
}

}  // namespace

void add_light(Document& document, const Part& light, uint32_t node) {
  NamedLight made = {name_at(document, light, node), shd_light_desc_default(), static_cast<int32_t>(node)};
  const bool good = attempt(document, "light \"" + made.name + "\"", [&] { read_light(light, made.desc); });
  if (good) document.model.lights.push_back(std::move(made));
}

void add_camera(Document& document, const Part& camera, uint32_t node) {
  NamedCamera made = {name_at(document, camera, node), shd_camera_default(), static_cast<int32_t>(node)};
  const bool good = attempt(document, "camera \"" + made.name + "\"", [&] { read_camera(camera, made.camera); });
  if (good) document.model.cameras.push_back(std::move(made));
}

void add_animations(Document& document, const std::vector<int32_t>& node_of) {
  const Part animations = document.root["animations"];
  for (size_t i = 0; i < animations.size(); ++i) {
    const Part from = animations.at(i), channels = from["channels"];
    Animation animation;
    animation.name = name_of(from);
    for (size_t k = 0; k < channels.size(); ++k) {
      document.source.deadline.check();
      attempt(document, title_of("animation", from),
              [&] { add_channel(document, channels.at(k), from["samplers"], node_of, animation); });
    }
    if (animation.channels.empty()) document.warnings.add(title_of("animation", from) + ": it moves no node; left out");
    if (!animation.channels.empty()) document.model.animations.push_back(std::move(animation));
  }
}

}  // namespace shd::scene::gltf
