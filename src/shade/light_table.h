// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/allocator.h"
#include "environment/environment.h"
#include "light/light.h"
#include "light/shadow.h"

namespace shd::shade {

/// The environment of a frame.
struct EnvironmentLight {
  const environment::Environment* map;  // null = none
  float intensity;
  float world_to_map[9];  // column-major rotation
};

/// Lights of a frame in the caller's order, except ambient lights, which are summed.
struct LightTable {
  float ambient[3];                           // I_a
  size_t count;                               // number of lights that are not ambient
  core::Array<light::Light> lights;           // [count]
  core::Array<float> x, y, z;                 // [padded] positions
  core::Array<float> max_squared_distance;    // [padded] slightly above the squared range; infinity without a range
  bool any_range;                             // some light has a range
  core::Array<const light::Shadow*> shadows;  // [count], null = none; read if any_shadow
  bool any_shadow;
  EnvironmentLight environment;
};

/// A light that may affect some point of a batch.
struct ActiveLight {
  const light::Light* light;
  const float* factor[3];  // [channel] factor by point; null = 1
};

/// Builds the table of `count` lights and their shadows. `shadows` and its elements may be null. Throws std::bad_alloc.
LightTable make_light_table(const core::Allocator& allocator, const light::Light* const* lights, size_t count,
                            const light::Shadow* const* shadows = nullptr);

}  // namespace shd::shade
