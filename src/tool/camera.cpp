// SPDX-License-Identifier: MIT
#include "tool/camera.h"

#include <algorithm>
#include <cmath>

#include "command/failure.h"

namespace {

constexpr float kMargin = 1.06f;

float dot(const std::array<float, 3>& a, const float* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Position of the eye for which the picture just contains every vertex.
struct Fit {
  float right = 0.0f, up = 0.0f;  // target point, relative to the centre
  float distance = 0.0f;
};

/// A vertex at (x, y) in the view, with z towards the eye, is inside if |x - right| <= tan_x (distance - z), and
/// correspondingly upwards. Each side of the picture bounds right +- tan_x distance by an extreme of x +- tan_x z.
Fit fit_view(const Camera& camera, const Model& model, const Bounds& bounds, float tan_x, float tan_y) {
  float left = HUGE_VALF, right = -HUGE_VALF, bottom = HUGE_VALF, top = -HUGE_VALF;
  for (const Instance& instance : model.instances) {
    const float* m = instance.object_to_world.data();
    const Geometry& geometry = model.geometries[instance.geometry];
    for (const uint32_t vertex : geometry.indices) {
      const float* p = &geometry.position[size_t{3} * vertex];
      float q[3];
      for (int c = 0; c < 3; ++c) q[c] = m[c] * p[0] + m[4 + c] * p[1] + m[8 + c] * p[2] + m[12 + c] - bounds.center[c];
      const float x = dot(camera.right, q), y = dot(camera.up, q), z = dot(camera.back, q);
      if (!std::isfinite(x + y + z)) continue;
      left = std::min(left, x - tan_x * z);
      right = std::max(right, x + tan_x * z);
      bottom = std::min(bottom, y - tan_y * z);
      top = std::max(top, y + tan_y * z);
    }
  }
  Fit fit;
  if (left > right) return fit;
  if (!model.geometries[0].mesh) {  // corners of a box are empty: the centre stays in the middle
    right = std::max(right, -left);
    top = std::max(top, -bottom);
    left = -right;
    bottom = -top;
  }
  fit.right = 0.5f * (left + right);
  fit.up = 0.5f * (bottom + top);
  fit.distance = kMargin * std::max((right - left) / (2.0f * tan_x), (top - bottom) / (2.0f * tan_y));
  return fit;
}

/// A camera of the file, with the axes of its view.
Camera file_camera(const Options& options, uint32_t number, const Model& model) {
  shd_camera desc = shd_camera_default();
  if (!model.scene.get() || shd_scene_get_camera(model.scene.get(), number, &desc) != SHD_OK) {
    throw Failure(kExitInput, "--camera " + std::to_string(number) + ": the model has no such camera");
  }
  desc.aspect = static_cast<float>(options.width) / static_cast<float>(options.height);
  Camera camera{};
  check(shd_view_from_camera(&desc, &camera.view), "camera");
  const float* m = camera.view.world_to_view;
  for (size_t c = 0; c < 3; ++c) {
    camera.right[c] = m[4 * c];
    camera.up[c] = m[4 * c + 1];
    camera.back[c] = m[4 * c + 2];
  }
  return camera;
}

}  // namespace

Camera make_camera(const Options& options, const Shot& shot, float turn, const Model& model, const Model& shown,
                   const Bounds& bounds) {
  if (shot.camera) return file_camera(options, *shot.camera, model);
  const float az = (shot.azimuth + turn) * kDegree, el = shot.elevation * kDegree;
  Camera camera{};
  camera.right = {std::cos(az), 0.0f, -std::sin(az)};
  camera.up = {-std::sin(el) * std::sin(az), std::cos(el), -std::sin(el) * std::cos(az)};
  camera.back = {std::cos(el) * std::sin(az), std::sin(el), std::cos(el) * std::cos(az)};

  shd_camera desc = shd_camera_default();
  desc.fov_y = options.fov * kDegree;
  desc.aspect = static_cast<float>(options.width) / static_cast<float>(options.height);
  const float tan_y = std::tan(0.5f * desc.fov_y);
  Fit fit;
  if (shot.distance > 0.0f) {
    fit.distance = shot.distance * bounds.radius;
  } else {
    fit = fit_view(camera, shown, bounds, tan_y * desc.aspect, tan_y);
    fit.distance = std::max(fit.distance, 1.05f * bounds.radius);
  }
  const float depth = (options.floor ? 7.0f : 1.01f) * bounds.radius;  // the floor reaches beyond the model
  desc.near_plane = std::max(fit.distance - depth, 0.01f * bounds.radius);
  desc.far_plane = fit.distance + depth;
  for (size_t c = 0; c < 3; ++c) {
    desc.target[c] = bounds.center[c] + fit.right * camera.right[c] + fit.up * camera.up[c];
    desc.eye[c] = desc.target[c] + fit.distance * camera.back[c];
    desc.up[c] = camera.up[c];
  }
  check(shd_view_from_camera(&desc, &camera.view), "camera");
  return camera;
}
