// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: light, (Fragments -> incident light).
///
/// Input:      checked descs; positions and normals of points.
/// Output:     one Light per desc, which shade/ gathers into the table of a frame; direction and falloff of the light
///             at points; shadow maps, and the visibility of points in them.
/// Units:      intensity scene-linear RGB; positions in world space.
/// Invariants: a Light is immutable.
///
/// A cookie is a texture that a light projects onto the scene and that multiplies its intensity.
///
/// | file                    | contents                                                                  |
/// |-------------------------|---------------------------------------------------------------------------|
/// | light.h                 | Light: the data of a light that kernels read                              |
/// | incident-inl.h          | direction, distance, cone and range of a light at points                  |
/// | projector.h             | kernel: coordinates of points in a cookie                                 |
/// | shadow.h                | Shadow: maps of depths, and the visibility of points                      |
/// | shadow_fit.h            | placement of the maps that cover a scene                                  |
/// | shadow_receiver-inl.h   | points and the planes of their surfaces on a map                          |
/// | shadow_hard.cpp         | kernel: one comparison                                                    |
/// | shadow_pcf.cpp          | kernel: mean of comparisons over a fixed width                            |
/// | shadow_pcss.cpp         | kernel: mean of comparisons over the width of the penumbra                |
/// | shadow_variance.cpp     | kernel: bound from blurred moments of depths                              |
/// | shadow_summed_area.cpp  | kernel: bound from summed moments of depths                               |
/// | shadow_tables.cpp       | blurred and summed moments of a map                                       |
/// | shadow_sums.h           | quantisation of depths that makes their sums exact                        |
#pragma once

#include <shd/light.h>

#include "core/object.h"
#include "texture/texture.h"

namespace shd::light {

/// The data of a light that kernels read. Fields that its kind does not use are 0.
struct Light {
  shd_light_kind kind;
  float intensity[3];
  float position[3];               // world space
  float to_light[3];               // scale from lengths along right and up to -1..1 across the cookie; for spots after
                                   // division by the distance
  float right[3], up[3];           // directional lights and spots: unit, perpendicular; right = up x to_light
  float range;                     // 0 = none
  float inverse_range_squared;     // 0 without a range
  float cone_scale, cone_start;    // spots: t = cone_scale (cos a - cone_start)
  float outer_tangent;             // spots: tan(outer_angle)
  float cookie_scale[2];           // from lengths along right and up to -1..1 across the cookie; spots: over distance
  const texture::Texture* cookie;  // null = none
  const texture::Sampler* cookie_sampler;  // never null with a cookie
};

/// Body of a light's handle. Owns its references.
struct LightBody {
  Light light;
  texture::Sampler default_sampler;        // target of light.cookie_sampler if the desc has none
  core::Object* texture_object = nullptr;  // retained, or null
  core::Object* sampler_object = nullptr;  // retained, or null

  LightBody() = default;
  LightBody(const LightBody&) = delete;
  LightBody& operator=(const LightBody&) = delete;
  ~LightBody();  // releases the two objects
};

/// Builds a light from a checked desc and the objects behind its handles; both objects may be null.
Light make_light(const shd_light_desc& desc, const texture::Texture* cookie, const texture::Sampler* cookie_sampler);

/// Sampler of cookies without a sampler: bilinear, black outside.
texture::Sampler default_sampler();

}  // namespace shd::light
