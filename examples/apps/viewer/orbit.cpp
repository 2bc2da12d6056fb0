// SPDX-License-Identifier: MIT
#include "orbit.h"

#include <algorithm>
#include <cmath>

#include <shd.hpp>

namespace viewer {
namespace {

constexpr float kDegree = 3.14159265f / 180.0f;
constexpr float kDegreesPerPixel = 0.35f;
constexpr float kZoomStep = 0.88f;
constexpr float kNearest = 0.05f, kFarthest = 60.0f;  // [radii]
constexpr float kFloorReach = 80.0f;                  // the far plane lies behind the floor [radii]

}  // namespace

float fit_distance(float fov, float aspect) {
  const float tan_y = std::tan(0.5f * fov * kDegree);
  const float narrow = std::atan(tan_y * std::min(aspect, 1.0f));
  return 0.92f / std::sin(narrow);
}

float distance_of(const Orbit& orbit, float aspect) {
  return orbit.distance > 0.0f ? orbit.distance : fit_distance(orbit.fov, aspect);
}

Axes axes_of(const Orbit& orbit) {
  const float az = orbit.azimuth * kDegree, el = orbit.elevation * kDegree;
  Axes axes;
  axes.right = {std::cos(az), 0.0f, -std::sin(az)};
  axes.up = {-std::sin(el) * std::sin(az), std::cos(el), -std::sin(el) * std::cos(az)};
  axes.back = {std::cos(el) * std::sin(az), std::sin(el), std::cos(el) * std::cos(az)};
  return axes;
}

void turn(Orbit& orbit, float dx, float dy) {
  orbit.azimuth = std::remainder(orbit.azimuth - kDegreesPerPixel * dx, 360.0f);
  orbit.elevation = std::clamp(orbit.elevation + kDegreesPerPixel * dy, -89.0f, 89.0f);
}

void pan(Orbit& orbit, float dx, float dy, float width, float height) {
  const float distance = distance_of(orbit, width / height);
  const float unit = 2.0f * std::tan(0.5f * orbit.fov * kDegree) * distance / height;  // radii a pixel
  const Axes axes = axes_of(orbit);
  for (size_t c = 0; c < 3; ++c) orbit.shift[c] += unit * (dy * axes.up[c] - dx * axes.right[c]);
}

void zoom(Orbit& orbit, float steps, float aspect) {
  orbit.distance = std::clamp(distance_of(orbit, aspect) * std::pow(kZoomStep, steps), kNearest, kFarthest);
}

shd_camera camera_of(const Orbit& orbit, const Bounds& bounds, float aspect) {
  const Axes axes = axes_of(orbit);
  const float distance = distance_of(orbit, aspect) * bounds.radius;
  shd::camera camera;
  camera.fov_y = orbit.fov * kDegree;
  camera.aspect = aspect;
  camera.near_plane = 0.02f * distance;
  camera.far_plane = distance + kFloorReach * bounds.radius;
  for (size_t c = 0; c < 3; ++c) {
    camera.target[c] = bounds.center[c] + bounds.radius * orbit.shift[c];
    camera.eye[c] = camera.target[c] + distance * axes.back[c];
    camera.up[c] = axes.up[c];
  }
  return camera;
}

}  // namespace viewer
