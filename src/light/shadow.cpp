// SPDX-License-Identifier: MIT
#include "light/shadow.h"

#include <algorithm>
#include <limits>

#include "data/column.h"

namespace shd::light {

ShadowAxes cube_axes(uint32_t face) {
  const uint32_t axis = face / 2, next = (axis + 1) % 3, last = (axis + 2) % 3;
  const bool negative = face % 2 != 0;
  ShadowAxes axes = {};
  axes.forward[axis] = negative ? -1.0f : 1.0f;
  axes.right[negative ? last : next] = 1.0f;
  axes.down[negative ? next : last] = 1.0f;
  return axes;
}

uint32_t filter_radius(const ShadowOptions& options) {
  const uint32_t taps = options.taps;
  switch (options.filter) {
    case SHD_SHADOW_FILTER_PCF:
    case SHD_SHADOW_FILTER_VARIANCE: return std::min(taps / 2 + 1, options.size / kMaxPcfRadiusPart);
    case SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE:
    case SHD_SHADOW_FILTER_PCSS: return options.size / kMaxRadiusPart;
    default: return 1;
  }
}

uint32_t padding_of(const ShadowOptions& options) {
  switch (options.filter) {
    case SHD_SHADOW_FILTER_PCF: return options.taps / 2 + 1;
    case SHD_SHADOW_FILTER_VARIANCE: return 1;
    case SHD_SHADOW_FILTER_PCSS: return 2;
    default: return 0;
  }
}

void allocate(const core::Allocator& allocator, const ShadowOptions& options, const ShadowPlacement& placement,
              ShadowMap* out) {
  ShadowMap map = {};
  map.placement = placement;
  map.size = options.size;
  map.pad = padding_of(options);
  map.pitch = size_t{map.size} + 2 * map.pad;
  map.face_stride = map.pitch * map.pitch;
  map.depth = core::Array<float>(allocator, map.face_stride * placement.face_count);
  std::fill(map.depth.begin(), map.depth.end(), std::numeric_limits<float>::infinity());
  *out = std::move(map);
}

double origin_depth(const ShadowPlacement& placement) {
  double depth = 0;
  if (placement.projection != ShadowProjection::kOrthographic) return depth;
  for (size_t c = 0; c < 3; ++c) {
    depth += static_cast<double>(placement.axes.forward[c]) * static_cast<double>(placement.origin[c]);
  }
  return depth;
}

void read_face(const Shadow& shadow, uint32_t face, const shd_f32_out* out) {
  const ShadowMap& map = shadow.map;
  const size_t size = face_size(shadow.options);
  const double offset = map.sums.size() ? 0.0 : origin_depth(map.placement);
  const auto copy_row = [&](size_t y, const auto* row, size_t columns) {
    for (size_t c = 0; c < columns; ++c) {
      if (!out[c].data) continue;
      for (size_t x = 0; x < size; ++x) {
        const auto value = static_cast<double>(row[x * columns + c]);
        data::store(out[c], y * size + x, static_cast<float>(c == 0 ? value + offset : value));
      }
    }
  };
  for (size_t y = 0; y < size; ++y) {
    const size_t texel = face * map.face_stride + (y + map.pad) * map.pitch + map.pad;
    if (map.sums.size()) {
      copy_row(y, map.sums.data() + 2 * size * (face * size + y), 2);
    } else if (map.moments.size()) {
      copy_row(y, map.moments.data() + 2 * texel, 2);
    } else {
      copy_row(y, map.depth.data() + texel, 1);
    }
  }
}

void sample_shadow(const core::SimdTarget& simd, const Shadow& shadow, const ShadowLookups& in, float* visibility) {
  switch (shadow.options.filter) {
    case SHD_SHADOW_FILTER_PCF: return sample_pcf(simd, shadow, in, visibility);
    case SHD_SHADOW_FILTER_VARIANCE: return sample_variance(simd, shadow, in, visibility);
    case SHD_SHADOW_FILTER_SUMMED_AREA_VARIANCE: return sample_summed_area_variance(simd, shadow, in, visibility);
    case SHD_SHADOW_FILTER_PCSS: return sample_pcss(simd, shadow, in, visibility);
    default: return sample_hard(simd, shadow, in, visibility);
  }
}

}  // namespace shd::light
