// SPDX-License-Identifier: MIT
#include "light/light.h"

#include "data/vec3.h"

namespace shd::light {

Light make_light(const shd_light_desc& desc) {
  Light light = {};
  light.kind = desc.kind;
  for (int c = 0; c < 3; ++c) light.intensity[c] = desc.intensity[c];
  if (desc.kind == SHD_LIGHT_POINT) {
    for (int c = 0; c < 3; ++c) light.position[c] = desc.position[c];
  } else if (desc.kind == SHD_LIGHT_DIRECTIONAL) {
    const data::Vec3 way = data::normalized({desc.direction[0], desc.direction[1], desc.direction[2]});
    light.to_light[0] = 0.0f - way.x;
    light.to_light[1] = 0.0f - way.y;
    light.to_light[2] = 0.0f - way.z;
  }
  return light;
}

}  // namespace shd::light
