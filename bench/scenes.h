// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "supersample.h"
#include "workload.h"

/// Scenes that show a texture under many footprints, with their truth under two pixel filters.
namespace shd::bench {

/// A map from the frame to the texture.
enum class Shape {
  kFloor,        // a plane that recedes to twelve times the distance of its nearest row
  kTurnedFloor,  // the floor with the texture turned by 45 degrees
  kSphere,       // a square of a sphere seen from afar, up to 77 degrees from the line of sight
  kTunnel,       // the inside of a pipe
  kZoom,         // the conformal map z^2: circles of 1.3 to 8 texels
  kPlane         // a plane that faces the eye
};
constexpr Shape kStills[] = {Shape::kFloor, Shape::kTurnedFloor, Shape::kSphere, Shape::kTunnel, Shape::kZoom};

struct Scene {
  Shape shape;
  uint32_t frame;     // edge of the frame [pixels]
  double zoom = 1.0;  // factor of the footprint
  double move = 0.0;  // translation of the texture along v
};

const char* name_of(Shape shape);

/// A point of a texture; one repetition is 1 x 1.
struct Point {
  double u, v;
};

/// The point of the texture at (x, y) in pixels from the top left corner of the frame.
Point point_of(const Scene& scene, double x, double y);

/// Appends the lookup of a pixel; point(dx, dy) is the point of the texture at (dx, dy) pixels from the pixel's centre.
/// Derivatives are central differences of doubles.
void add_lookup(const std::function<Point(double dx, double dy)>& point, Lookups* out);

/// Columns of one lookup per pixel.
Lookups scene_lookups(const Scene& scene);

/// Frames as RGBA, filtered from samples x samples points per pixel of the bilinear reconstruction, in doubles.
struct Truth {
  std::vector<float> box;   // a box of one pixel
  std::vector<float> tent;  // a tent of two pixels, the product of one tent along each axis
};
Truth supersample(const Scene& scene, const Picture& picture, int samples);

/// Circles whose frequency grows to a quarter cycle per texel at the middle of each side.
Picture make_zone_plate(uint32_t edge);

/// Mean squared difference of r, g, b clamped to [0, 1].
double mean_square_error(const std::vector<float>& rgba, const std::vector<float>& truth);

}  // namespace shd::bench
