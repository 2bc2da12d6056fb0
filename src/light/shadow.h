// SPDX-License-Identifier: MIT
/// @file
/// Shadow maps (Williams, "Casting Curved Shadows on Curved Surfaces", 1978): depths of a scene from a light, and the
/// filters that derive from them the fraction of the light that reaches a point.
///
/// A map has one face, or the six faces of a cube around a point. A face is projected from `origin` along its forward
/// axis. A point at q = p - origin has the depth z = forward.q and the texel coordinates
///   x = size / 2 + scale right.q / w,  y = size / 2 + scale down.q / w,  w = 1 (orthographic) or z,
/// with texel centres at (i + 1/2). A texel stores the depth of the surface at its centre, as a world length; empty
/// texels store +infinity.
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/shadow.h>

#include "core/allocator.h"
#include "core/context.h"
#include "core/simd_target.h"

namespace shd::light {

/// Projection of points onto a map.
enum class ShadowProjection : uint32_t { kOrthographic, kPerspective, kCube };

/// A checked shd_shadow_desc.
struct ShadowOptions {
  uint32_t size;
  shd_shadow_filter filter;
  uint32_t taps;
  shd_cull caster_cull;
  float filter_size, light_size;
  float bias, bias_slope, normal_offset;
  float bleed, min_variance;
};

/// Unit vectors of a face, with right x down = forward. The forward axes of faces 2 k and 2 k + 1 of a cube are the
/// positive and the negative axis k. With a and b the next axes in cyclic order, right and down are (a, b) and (b, a).
struct ShadowAxes {
  float right[3], down[3], forward[3];
};

/// Placement of a map in the world.
struct ShadowPlacement {
  shd_light_kind kind;
  ShadowProjection projection;
  uint32_t face_count;
  ShadowAxes axes;     // a single face; unused for a cube
  float origin[3];     // world space
  float scale;         // texels per world length, or per unit of the tangent
  float near, far;     // range of depths, near < far; near > 0 unless orthographic
  float guard;         // error of depths: guard + guard_square z^2
  float guard_square;  // 0 if orthographic
};

/// Axes of face `face` of a cube.
ShadowAxes cube_axes(uint32_t face);

/// A rendered map. Texels are stored in rows of `pitch` elements. The first texel of a face lies `pad` rows and columns
/// after the start of the face. The padding is empty.
struct ShadowMap {
  ShadowPlacement placement;
  uint32_t size, pad;
  size_t pitch, face_stride;
  core::Array<float> depth;    // [face_count][face_stride]; HARD, PCF and PCSS
  core::Array<float> moments;  // [face_count][face_stride][2] mean and variance; VARIANCE
  core::Array<double> sums;    // [face_count][size + 1][size + 1][2]; SUMMED_AREA_VARIANCE
};

struct Shadow {
  ShadowOptions options;
  bool is_rendered = false;
  ShadowMap map;
};

/// Filters read texels at most size / kMaxRadiusPart from a point; PCF and VARIANCE at most size / kMaxPcfRadiusPart.
constexpr uint32_t kMaxRadiusPart = 8, kMaxPcfRadiusPart = 4;
/// Largest shd_shadow_desc.taps.
constexpr uint32_t kMaxTaps = 15;
/// Bound to which slopes of surfaces against a face are clamped.
constexpr float kMaxSlope = 64.0f;

/// Depth bias of surfaces with a normal, in texels: kSteepnessSlack + |slope| across the map + |slope| along it. The
/// sum of both slopes is limited to kMaxSteepness. Comparisons use the plane of the surface at each texel
/// (receiver-plane depth bias: Isidoro, "Shadow Mapping: GPU-based Tips and Techniques", GDC 2006), so the bias covers
/// only what differs from this plane: curvature, interpolated normals and rounding. The bound is the clamp of
/// slope-scaled biases in Direct3D and OpenGL. Without it, light that grazes a surface entered gaps of up to 128
/// texels. Rejected: a bound of 4, and half the slopes; both keep more light out of contacts, but spheres of 32 x 16
/// parts and fewer had stripes of shadow.
constexpr float kSteepnessSlack = 0.25f, kMaxSteepness = 8.0f;

/// Sum of |slope| across and along the map that is assumed for surfaces without a normal: 1 each, over the width of a
/// fixed filter.
inline float unknown_steepness(const ShadowOptions& options) {
  return options.filter == SHD_SHADOW_FILTER_PCF ? static_cast<float>(options.taps + 1) : 2.0f;
}

/// Largest distance [texels] beyond the edge of a face at which filters read.
uint32_t filter_radius(const ShadowOptions& options);
/// Number of empty texels around each face.
uint32_t padding_of(const ShadowOptions& options);

/// Allocates the depths of a placement, all empty. Throws std::bad_alloc.
void allocate(const core::Allocator& allocator, const ShadowOptions& options, const ShadowPlacement& placement,
              ShadowMap* out);

/// Replaces the depths of a rendered map by the moments or sums that its filter reads. Throws Failure and
/// std::bad_alloc.
/// @param allocator  allocates the moments and sums
void build_tables(const core::Context& context, const core::Allocator& allocator, const ShadowOptions& options,
                  ShadowMap* map);

/// Returns the elements of a row of what read_face() copies, and the number of its rows.
inline uint32_t face_size(const ShadowOptions& options) {
  return options.size + (options.filter == SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE ? 1 : 0);
}

/// Returns the size of a map [bytes].
inline size_t byte_size(const ShadowMap& map) {
  return (map.depth.size() + map.moments.size()) * sizeof(float) + map.sums.size() * sizeof(double);
}

/// Returns the depth of the origin of a map: what depths of a map lack to those from the origin of the world along the
/// direction of a directional light. Other lights are the origin.
double origin_depth(const ShadowPlacement& placement);

/// Copies the depths of a face, or its moments or sums to two columns. Depths include origin_depth(). Columns without
/// data are left out.
void read_face(const Shadow& shadow, uint32_t face, const shd_f32_out* out);

/// Points on surfaces, packed columns.
struct ShadowLookups {
  size_t count;
  const float* position[3];  // world space
  const float* normal[3];    // unit, world space; all null = unknown
};

/// Fraction of the light that reaches each point, 0..1, with the filter of a rendered shadow; 1 if a position is not
/// finite or lies outside the map. The result of a point does not depend on the other points.
void sample_shadow(const core::SimdTarget& simd, const Shadow& shadow, const ShadowLookups& in, float* visibility);

/// The filters. The shadow must use the filter.
void sample_hard(const core::SimdTarget& simd, const Shadow& shadow, const ShadowLookups& in, float* visibility);
void sample_pcf(const core::SimdTarget& simd, const Shadow& shadow, const ShadowLookups& in, float* visibility);
void sample_variance(const core::SimdTarget& simd, const Shadow& shadow, const ShadowLookups& in, float* visibility);
void sample_summed_area_variance(const core::SimdTarget& simd, const Shadow& shadow, const ShadowLookups& in,
                                 float* visibility);
void sample_pcss(const core::SimdTarget& simd, const Shadow& shadow, const ShadowLookups& in, float* visibility);

}  // namespace shd::light
