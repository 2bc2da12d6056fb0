// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: light, (Fragments -> incident light).
///
/// Input:      checked descs; positions and normals of fragments; the depths that a light sees.
/// Output:     one Light each; shade/ gathers those of a frame into a table. What arrives at a point, by direction and
///             factor on the intensity.
/// Units:      intensity scene-linear RGB; positions in world space.
///
/// | file                                             | what |
/// |--------------------------------------------------|------------------------------------------------------------------|
/// | incident-inl.h                                   | direction, distance, cone and range of points, spots,
/// directions | | projector.h                                      | textures of lights at points | | shadow.h |
/// Shadow: maps of depths, and visibility of points                 | | shadow_fit.h | where maps must lie to hold a
/// scene                              | | shadow_hard.cpp, shadow_pcf.cpp, shadow_pcss.cpp | kernels: comparisons with
/// depths                                 | | shadow_variance.cpp, shadow_summed_area.cpp      | kernels: bounds from
/// moments of depths                           | | shadow_tables.cpp, shadow_sums.h                 | those moments,
/// and their sums                                    | | shadow_receiver-inl.h                            | points and
/// the planes of their surfaces on a map                 |
#pragma once

#include <shd/light.h>

#include "core/object.h"
#include "texture/texture.h"

namespace shd::light {

/// What the kernels read; fields that its kind does not use are 0.
struct Light {
  shd_light_kind kind;
  float intensity[3];
  float position[3];             // world space
  float to_light[3];             // of directional lights and spots: unit, against the way the light travels
  float right[3], up[3];         // of the same: unit, at right angles to that and to each other; right = up x to_light
  float range;                   // 0 = none
  float inverse_range_squared;   // 0 without
  float cone_scale, cone_start;  // of spots: t = cone_scale (cos a - cone_start)
  float outer_tangent;           // of spots: tan(outer_angle)
  float slide_scale[2];          // with a texture: of right and up components, to -1..1 across it; of spots by distance
  const texture::Texture* texture;  // null = none
  const texture::Sampler* sampler;  // never null with a texture
};

/// Body of a light's handle. Owns its references.
struct LightBody {
  Light light;
  texture::Sampler default_sampler;        // what light.sampler points at when the desc gave none
  core::Object* texture_object = nullptr;  // retained, or null
  core::Object* sampler_object = nullptr;  // retained, or null

  LightBody() = default;
  LightBody(const LightBody&) = delete;
  LightBody& operator=(const LightBody&) = delete;
  ~LightBody();  // releases the two objects
};

/// A checked desc with what its handles stand for; `sampler` null = the default of shd_light_desc.
Light make_light(const shd_light_desc& desc, const texture::Texture* texture, const texture::Sampler* sampler);

/// Bilinear, black outside.
texture::Sampler default_sampler();

}  // namespace shd::light
