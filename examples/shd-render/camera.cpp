// SPDX-License-Identifier: MIT
#include "camera.h"

#include <algorithm>
#include <cmath>

#include "failure.h"

namespace {

constexpr float kDegree = 3.14159265f / 180.0f;
constexpr float kMargin = 1.06f;

float dot(const std::array<float, 3>& a, const float* b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Smallest distance of the eye from the centre that keeps a vertex inside the field of view, over all vertices.
float fit_distance(const Camera& camera, const Model& model, const Bounds& bounds, float tan_x, float tan_y) {
  float distance = 0.0f;
  for (const Instance& instance : model.instances) {
    const float* m = instance.object_to_world.data();
    const Geometry& geometry = model.geometries[instance.geometry];
    for (const uint32_t vertex : geometry.indices) {
      const float* p = &geometry.position[size_t{3} * vertex];
      float q[3];
      for (int c = 0; c < 3; ++c) q[c] = m[c] * p[0] + m[4 + c] * p[1] + m[8 + c] * p[2] + m[12 + c] - bounds.center[c];
      const float aside = std::max(std::fabs(dot(camera.right, q)) / tan_x, std::fabs(dot(camera.up, q)) / tan_y);
      const float needed = aside * kMargin + dot(camera.back, q);
      if (needed > distance) distance = needed;  // false for NaN
    }
  }
  return std::max(distance, 1.05f * bounds.radius);
}

}  // namespace

Camera make_camera(const Options& options, const Model& model, const Bounds& bounds) {
  const float az = options.azimuth * kDegree, el = options.elevation * kDegree;
  Camera camera{};
  camera.right = {std::cos(az), 0.0f, -std::sin(az)};
  camera.up = {-std::sin(el) * std::sin(az), std::cos(el), -std::sin(el) * std::cos(az)};
  camera.back = {std::cos(el) * std::sin(az), std::sin(el), std::cos(el) * std::cos(az)};

  shd_camera desc = shd_camera_default();
  desc.fov_y = options.fov * kDegree;
  desc.aspect = static_cast<float>(options.width) / static_cast<float>(options.height);
  const float tan_y = std::tan(0.5f * desc.fov_y);
  const float distance = options.distance > 0.0f ? options.distance * bounds.radius
                                                 : fit_distance(camera, model, bounds, tan_y * desc.aspect, tan_y);
  desc.near_plane = std::max(distance - 1.01f * bounds.radius, 0.01f * bounds.radius);
  desc.far_plane = distance + 1.01f * bounds.radius;
  for (size_t c = 0; c < 3; ++c) {
    desc.target[c] = bounds.center[c];
    desc.eye[c] = bounds.center[c] + distance * camera.back[c];
    desc.up[c] = camera.up[c];
  }
  check(shd_view_from_camera(&desc, &camera.view), "camera");
  return camera;
}
