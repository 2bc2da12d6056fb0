// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "core/allocator.h"
#include "light/light.h"

namespace shd::shade {

/// Lights of a frame, in the caller's order; ambient ones are summed apart.
struct LightTable {
  float ambient[3];                  // I_a
  size_t count;                      // point and directional lights
  core::Array<light::Light> lights;  // [count]
};

/// Gathers `count` lights. Throws std::bad_alloc.
inline LightTable make_light_table(const core::Allocator& allocator, const light::Light* const* lights, size_t count) {
  LightTable table = {{0.0f, 0.0f, 0.0f}, 0, core::Array<light::Light>(allocator, count)};
  for (size_t i = 0; i < count; ++i) {
    if (lights[i]->kind == SHD_LIGHT_AMBIENT) {
      for (int c = 0; c < 3; ++c) table.ambient[c] += lights[i]->intensity[c];
    } else {
      table.lights[table.count++] = *lights[i];
    }
  }
  return table;
}

}  // namespace shd::shade
