// SPDX-License-Identifier: MIT
#pragma once

#include "light/light.h"
#include "light/shadow.h"

namespace shd::light {

/// Collects the bounds that the maps of a light must cover. All arithmetic is in double.
class ShadowFit {
 public:
  explicit ShadowFit(const Light& light);

  /// Adds the corners of a box that casts shadows, in world space.
  void add(const double (&corners)[8][3]);
  /// Directional lights: sets the part of the world that needs shadows, instead of the boxes.
  void limit(const float low[3], const float high[3]);
  /// Sets the range of depths, instead of a fitted range.
  void set_planes(float near, float far);

  /// Throws Failure if bounds exceed 1e18.
  ShadowPlacement place(const ShadowOptions& options) const;

 private:
  struct Interval {
    double low, high;
    void add(double value);
    bool is_empty() const { return !(low <= high); }
  };

  void place_directional(const ShadowOptions& options, ShadowPlacement* out) const;
  void place_around(const ShadowOptions& options, ShadowPlacement* out) const;
  double along(const float (&axis)[3], const double corner[3]) const;

  const Light& light_;
  ShadowAxes axes_;  // directional lights and spots
  bool is_cube_;
  Interval across_[2];  // along right and down
  Interval depth_;      // along forward, from the origin of depths; for cubes the maximum norm
  double largest_ = 0;  // largest magnitude of a coordinate
  bool is_limited_ = false, has_planes_ = false;
  double near_ = 0, far_ = 0;
};

/// Tangent of the half angle above which a spot uses the six faces of a point light.
constexpr double kMaxSpotTangent = 1.9647596572486523;  // tan(1.1 rad)

}  // namespace shd::light
