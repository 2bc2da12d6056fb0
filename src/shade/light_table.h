// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/allocator.h"
#include "light/light.h"
#include "light/shadow.h"

namespace shd::shade {

/// Lights of a frame, in the caller's order; ambient ones are summed apart.
struct LightTable {
  float ambient[3];                           // I_a
  size_t count;                               // of the others
  core::Array<light::Light> lights;           // [count]
  core::Array<float> x, y, z;                 // [padded] positions
  core::Array<float> reach;                   // [padded] square of the range and a bit more; infinity without
  bool any_range;                             // some light ends
  core::Array<const light::Shadow*> shadows;  // [count], null = none; read if any_shadow
  bool any_shadow;
};

/// A light that may reach some row of a batch.
struct ActiveLight {
  const light::Light* light;
  const float* factor[3];  // by row, by channel; null = 1
};

/// Gathers `count` lights with their shadows; `shadows`, or elements of it, null = none. Throws std::bad_alloc.
LightTable make_light_table(const core::Allocator& allocator, const light::Light* const* lights, size_t count,
                            const light::Shadow* const* shadows = nullptr);

}  // namespace shd::shade
