// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: light, (Fragments -> incident light).
///
/// Input:      checked descs.
/// Output:     one Light each; shade/ gathers those of a frame into columns.
/// Units:      intensity scene-linear RGB; positions in world space.
#pragma once

#include <shd/light.h>

namespace shd::light {

struct Light {
  shd_light_kind kind;
  float intensity[3];
  float position[3];  // world space
  float to_light[3];  // directional lights: unit, against the way the light travels
};

/// A checked desc as a Light; what its kind does not use is 0.
Light make_light(const shd_light_desc& desc);

}  // namespace shd::light
