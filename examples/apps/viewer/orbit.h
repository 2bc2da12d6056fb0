// SPDX-License-Identifier: MIT
/// A camera that circles a point of interest. No window is needed.
#pragma once
#include <array>
#include <tuple>

#include <shd/view.h>

namespace viewer {

/// Sphere around the model, world space.
struct Bounds {
  std::array<float, 3> center = {0, 0, 0};
  float radius = 1.0f;
  float bottom = -1.0f;  // lowest y
};

/// Direction and distance of the eye as seen from the target.
struct Orbit {
  float azimuth = 28.0f, elevation = 15.0f;  // [deg]; azimuth 0 looks along -Z, elevation is -89..89
  float distance = 0.0f;                     // [radii of the model]; 0 = the model fits
  std::array<float, 3> shift = {0, 0, 0};    // target less the centre of the model [radii]
  float fov = 32.0f;                         // vertical [deg], 5..120
  auto tie() const { return std::tie(azimuth, elevation, distance, shift, fov); }
};

/// Distance in radii at which the sphere around the model fits into a picture of that aspect.
float fit_distance(float fov, float aspect);

/// Distance in radii: the orbit's own, or the fitted one.
float distance_of(const Orbit& orbit, float aspect);

/// Axes of the view in world space, unit: right, up, back.
struct Axes {
  std::array<float, 3> right, up, back;
};
Axes axes_of(const Orbit& orbit);

/// Turns the eye with a drag of dx, dy pixels to the right and down: the model follows the pointer.
void turn(Orbit& orbit, float dx, float dy);

/// Moves the target so that the point below the pointer follows a drag of dx, dy pixels.
void pan(Orbit& orbit, float dx, float dy, float width, float height);

/// Moves the eye nearer by `steps` of the wheel.
void zoom(Orbit& orbit, float steps, float aspect);

/// The camera for a model with these bounds.
shd_camera camera_of(const Orbit& orbit, const Bounds& bounds, float aspect);

}  // namespace viewer
