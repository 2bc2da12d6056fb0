// SPDX-License-Identifier: MIT
/// @file
/// Shadow maps (Williams, "Casting Curved Shadows on Curved Surfaces", 1978): what a light sees of the scene, as
/// depths, and the filters that tell from them how much of the light reaches a point.
///
/// A map has one face, or six around a point (cube). A face looks from `origin` along its forward axis; a point at
/// q = p - origin has the depth z = forward.q and lies at the texel coordinates
///   x = size / 2 + scale right.q / w,  y = size / 2 + scale down.q / w,  w = 1 (orthographic) or z,
/// texel centres at (i + 1/2). Depths are those of surfaces at the texels' centres, in world lengths; empty ones are
/// +infinity.
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/shadow.h>

#include "core/allocator.h"
#include "core/context.h"
#include "core/simd_target.h"

namespace shd::light {

/// How points come to lie on a map.
enum class ShadowProjection : uint32_t { kOrthographic, kPerspective, kCube };

/// A checked shd_shadow_desc.
struct ShadowOptions {
  uint32_t size;
  shd_shadow_filter filter;
  uint32_t taps;
  shd_cull casters;
  float filter_size, light_size;
  float bias, bias_slope, normal_offset;
  float bleed, min_variance;
};

/// Unit vectors of a face, right x down = forward. Those of a cube follow from the face's number: faces 2 k and
/// 2 k + 1 look along the positive and the negative axis k; with a and b the axes after it, in cyclic order, right and
/// down are (a, b) and (b, a).
struct ShadowAxes {
  float right[3], down[3], forward[3];
};

/// Where a map lies.
struct ShadowPlacement {
  shd_light_kind kind;
  ShadowProjection projection;
  uint32_t face_count;
  ShadowAxes axes;     // of the only face
  float origin[3];     // world space
  float scale;         // texels a world length, or a unit of the tangent
  float near, far;     // depths that are drawn, near < far; near > 0 unless orthographic
  float guard;         // error of depths: guard + guard_square z^2
  float guard_square;  // 0 if orthographic
};

/// Axes of face `face` of a cube.
ShadowAxes cube_axes(uint32_t face);

/// What was rendered. Texels lie in rows of `pitch`, the first of a face `pad` rows and columns after its start; the
/// padding is empty.
struct ShadowMap {
  ShadowPlacement placement;
  uint32_t size, pad;
  size_t pitch, face_stride;
  core::Array<float> depth;    // [face_count][face_stride]; of HARD, PCF and PCSS
  core::Array<float> moments;  // [face_count][face_stride][2] mean and variance; of VARIANCE
  core::Array<double> sums;    // [face_count][size + 1][size + 1][2]; of SUMMED_AREA_VARIANCE
};

struct Shadow {
  ShadowOptions options;
  bool is_rendered = false;
  ShadowMap map;
};

/// No filter reaches farther than size / kReachPart texels from a point, and none farther over the edge of a face that
/// has no neighbour on its own plane; PCF up to size / kPcfReachPart.
constexpr uint32_t kReachPart = 8, kPcfReachPart = 4;
/// Slopes of surfaces against a face count up to this.
constexpr float kMaxSlope = 64.0f;

/// What facets may be steeper than their normals say, added to |slope| across and along the map.
constexpr float kLeastSteepness = 0.25f;

/// |slope| across and along the map, added up, of surfaces whose normal is not known: 1 each, over the texels that a
/// filter of a fixed width compares.
inline float unknown_steepness(const ShadowOptions& options) {
  return options.filter == SHD_SHADOW_PCF ? static_cast<float>(options.taps + 1) : 2.0f;
}

/// Texels around a face that points of its inside may look up.
uint32_t reach_of(const ShadowOptions& options);
/// Empty texels that a map has around each face.
uint32_t pad_of(const ShadowOptions& options);

/// Makes room for the depths of a placement: all empty. Throws std::bad_alloc.
void allocate(const core::Allocator& allocator, const ShadowOptions& options, const ShadowPlacement& placement,
              ShadowMap* out);

/// Replaces the depths of a drawn map by the moments or sums that its filter reads. Throws.
/// @param allocator  of what stays
void build_tables(const core::Context& context, const core::Allocator& allocator, const ShadowOptions& options,
                  ShadowMap* map);

/// Points that a surface is lit at, packed.
struct ShadowLookups {
  size_t count;
  const float* position[3];  // world space
  const float* normal[3];    // unit, world space; all null = not known
};

/// Part of the light that reaches each point, 0..1, by the filter of a rendered shadow: 1 where a position is not
/// finite or lies outside the map. Lanes do not depend on each other.
void sample_shadow(const core::SimdTarget& simd, const Shadow& shadow, const ShadowLookups& in, float* visibility);

/// The filters behind it.
void sample_hard(const core::SimdTarget& simd, const Shadow& shadow, const ShadowLookups& in, float* visibility);
void sample_pcf(const core::SimdTarget& simd, const Shadow& shadow, const ShadowLookups& in, float* visibility);
void sample_variance(const core::SimdTarget& simd, const Shadow& shadow, const ShadowLookups& in, float* visibility);
void sample_summed_area_variance(const core::SimdTarget& simd, const Shadow& shadow, const ShadowLookups& in,
                                 float* visibility);
void sample_pcss(const core::SimdTarget& simd, const Shadow& shadow, const ShadowLookups& in, float* visibility);

}  // namespace shd::light
