// SPDX-License-Identifier: MIT
#include "texture/oracle/bounds/plane.h"

#include <algorithm>

#include "texture/domain/wrap.h"
#include "texture/format/formats.h"
#include "texture/oracle/bounds/compare.h"
#include "texture/oracle/bounds/fold.h"
#include "texture/store/reader.h"
#include "texture/store/storage.h"

namespace shd::texture {
namespace {

Color texel_of_store(const Plane& plane, uint32_t image, int64_t x, int64_t y) {
  const Texture& texture = plane.call->texture;
  const uint8_t* texel =
      plane.call->reader.at(first_unit(texture, image, plane.level), static_cast<uint32_t>(plane.size[0]),
                            static_cast<uint32_t>(x), static_cast<uint32_t>(y));
  Color color;
  if (texture.component == image::Component::kSrgb8) {
    for (uint32_t c = 0; c < texture.channels; ++c) {
      const double alpha = texel[c] / 255.0;
      color.channel[c] = c == 3 ? Range{alpha, alpha} : plane.call->model.srgb[texel[c]];
    }
    return color;
  }
  double value[4] = {};
  visit_stored(texture.component, texture.channels, [&](auto codec) {
    codec.load(texel, value);
    for (uint32_t c = 0; c < texture.channels; ++c) value[c] /= codec.one(c);
  });
  for (uint32_t c = 0; c < texture.channels; ++c) {
    color.channel[c] = std::isfinite(value[c]) ? Range{value[c], value[c]} : unbounded();
  }
  return color;
}

/// Returns a texel as the filter reads it: comparison lookups compare its channel of r.
Color as_read(const Plane& plane, Color texel) {
  const BoundsCall& call = *plane.call;
  const uint32_t source = call.texture.channel_source[0];
  if (!call.sampler.compares || source == kFill) return texel;
  texel.channel[source] = compared_range(call.sampler, call.reference, texel.channel[source]);
  return texel;
}

Color border_range(const Plane& plane) {
  Color color;
  for (uint32_t c = 0; c < plane.call->texture.channels; ++c) {
    color.channel[c].add(static_cast<double>(plane.call->sampler.border[c]));
  }
  return as_read(plane, color);
}

}  // namespace

Plane plane_of(const BoundsCall& call, uint32_t layer, uint32_t level) {
  const Texture& texture = call.texture;
  return {&call,
          layer,
          level,
          {level_size(texture.width, level), level_size(texture.height, level), level_size(texture.depth, level)}};
}

Color stored_range(const Plane& plane, uint32_t image, int64_t x, int64_t y) {
  return as_read(plane, texel_of_store(plane, image, x, y));
}

Color texel_range(const Plane& plane, int64_t i, int64_t j, int64_t k) {
  const BoundsCall& call = *plane.call;
  if (call.texture.projection != SHD_PROJECTION_NONE) return folded_range(plane, i, j);
  const int64_t x = wrap_index(wrap_of(call, 0), i, plane.size[0]);
  const int64_t y = wrap_index(wrap_of(call, 1), j, plane.size[1]);
  const int64_t z = call.texture.depth != 0 ? wrap_index(wrap_of(call, 2), k, plane.size[2]) : plane.layer;
  return x < 0 || y < 0 || z < 0 ? border_range(plane) : stored_range(plane, static_cast<uint32_t>(z), x, y);
}

Color format_range(const Texture& texture, const Sampler& sampler) {
  Color color;
  for (uint32_t c = 0; c < texture.channels; ++c) {
    color.channel[c] = is_float(texture.component) ? unbounded() : Range{0.0, largest_of(texture.component, c)};
    if (has_border(texture, sampler)) color.channel[c].add(static_cast<double>(sampler.border[c]));
    if (sampler.compares) color.channel[c] = compared_range(sampler, unbounded(), unbounded());
  }
  return color;
}

}  // namespace shd::texture
