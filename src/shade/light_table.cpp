// SPDX-License-Identifier: MIT
#include "shade/light_table.h"

#include <limits>
#include <utility>

#include "data/data.h"

namespace shd::shade {

LightTable make_light_table(const core::Allocator& allocator, const light::Light* const* lights, size_t count,
                            const light::Shadow* const* shadows) {
  LightTable table = {};
  table.lights = core::Array<light::Light>(allocator, count);
  table.shadows = core::Array<const light::Shadow*>(allocator, count);
  for (core::Array<float>* column : {&table.x, &table.y, &table.z, &table.max_squared_distance}) {
    *column = core::Array<float>(allocator, data::padded(count));
    column->fill_zero();
  }
  for (size_t i = 0; i < count; ++i) {
    const light::Light& light = *lights[i];
    if (light.kind == SHD_LIGHT_KIND_AMBIENT) {
      for (int c = 0; c < 3; ++c) table.ambient[c] += light.intensity[c];
      continue;
    }
    const size_t k = table.count++;
    table.lights[k] = light;
    table.shadows[k] = shadows ? shadows[i] : nullptr;
    table.any_shadow |= table.shadows[k] != nullptr;
    table.x[k] = light.position[0];
    table.y[k] = light.position[1];
    table.z[k] = light.position[2];
    // The margin exceeds the rounding of distances. Beyond the range the falloff is 0.
    table.max_squared_distance[k] = light.range > 0.0f ? static_cast<float>(1.0001 * light.range * light.range)
                                                       : std::numeric_limits<float>::infinity();
    table.any_range |= light.range > 0.0f;
  }
  return table;
}

}  // namespace shd::shade
