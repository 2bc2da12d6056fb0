// SPDX-License-Identifier: MIT
#include "scene/stage.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "extension/error.h"

namespace shd::scene {
namespace {

using extension::require;

/// The matrix of a node to the world of shd; -1 is the world of the file.
Matrix matrix_of(const Parts& parts, const Pose& pose, int32_t node) {
  Matrix out = node < 0 ? kIdentity : pose.worlds[static_cast<size_t>(node)];
  for (size_t c = 0; c < 3; ++c) out[12 + c] -= parts.origin[c];
  return out;
}

std::array<double, 3> wide(const float* v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// A vector through a matrix, without its translation.
std::array<double, 3> turn(Matrix m, const std::array<double, 3>& v) {
  for (size_t c = 0; c < 3; ++c) m[12 + c] = 0.0;
  return transform(m, v);
}

/// The unit vector; 0 if there is none.
std::array<double, 3> unit(std::array<double, 3> v) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  for (double& c : v) c = length > 0.0 ? c / length : 0.0;
  return v;
}

void narrow(const std::array<double, 3>& from, float* to) {
  for (size_t c = 0; c < 3; ++c) to[c] = static_cast<float>(from[c]);
}

shd_light_desc move_light(shd_light_desc desc, const Matrix& m, bool turns) {
  narrow(transform(m, wide(desc.position)), desc.position);
  if (!turns) return desc;
  narrow(unit(turn(m, wide(desc.direction))), desc.direction);
  narrow(unit(turn(m, wide(desc.up))), desc.up);
  return desc;
}

shd_camera move_camera(shd_camera camera, const Matrix& m, bool turns) {
  const std::array<double, 3> from = wide(camera.eye), target = wide(camera.target);
  const std::array<double, 3> eye = transform(m, from);
  const std::array<double, 3> ahead = turn(m, {target[0] - from[0], target[1] - from[1], target[2] - from[2]});
  const double away = std::max({std::fabs(eye[0]), std::fabs(eye[1]), std::fabs(eye[2])});
  const double length = std::max(1.0, away / 1024);  // the direction survives the rounding of far eyes
  const std::array<double, 3> step = unit(ahead);
  narrow(eye, camera.eye);
  for (size_t c = 0; c < 3; ++c) camera.target[c] = static_cast<float>(eye[c] + length * step[c]);
  if (turns) narrow(unit(turn(m, wide(camera.up))), camera.up);
  return camera;
}

void set_planes(const Bounds& box, shd_camera* camera) {
  const std::array<double, 3> eye = wide(camera->eye), center = box.center();
  double square = 0.0;
  for (size_t c = 0; c < 3; ++c) square += (eye[c] - center[c]) * (eye[c] - center[c]);
  const auto far_plane = static_cast<float>(std::min(std::sqrt(square) + 2.0 * box.radius(), 1e30));
  if (!(camera->near_plane > 0.0f)) camera->near_plane = 1e-3f * far_plane;
  if (!(camera->far_plane > camera->near_plane)) camera->far_plane = std::max(far_plane, 2.0f * camera->near_plane);
}

}  // namespace

void add_lights(const Parts& parts, const Pose& pose, Objects* out) {
  for (const NamedLight& named : parts.model.lights) {
    const shd_light_desc desc = move_light(named.desc, matrix_of(parts, pose, named.node), named.node >= 0);
    Light light;
    const shd_result result = shd_light_create(parts.context, &desc, light.out());
    if (result == SHD_ERROR_INVALID_ARGUMENT) {
      out->warnings.push_back("light \"" + named.name + "\": " + shd_last_error());
      continue;
    }
    require(result);
    out->light_list.push_back(light.get());
    out->lights.push_back(std::move(light));
    out->light_descs.push_back(desc);
    out->light_names.push_back(named.name);
  }
}

void add_cameras(const Parts& parts, const Pose& pose, Objects* out) {
  const bool moved = parts.origin != std::array<double, 3>{0, 0, 0};
  for (const NamedCamera& named : parts.model.cameras) {
    shd_camera camera = named.camera;
    if (moved || named.node >= 0) camera = move_camera(camera, matrix_of(parts, pose, named.node), named.node >= 0);
    set_planes(out->bounds, &camera);
    shd_view view;
    if (shd_view_from_camera(&camera, &view) != SHD_OK) {
      out->warnings.push_back("camera \"" + named.name + "\": " + shd_last_error());
      continue;
    }
    out->cameras.push_back(camera);
    out->camera_names.push_back(named.name);
  }
}

}  // namespace shd::scene
