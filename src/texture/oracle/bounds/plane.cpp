// SPDX-License-Identifier: MIT
#include "texture/oracle/bounds/plane.h"

#include "texture/domain/wrap.h"
#include "texture/format/formats.h"
#include "texture/oracle/bounds/cube.h"
#include "texture/store/reader.h"
#include "texture/store/storage.h"

namespace shd::texture {
namespace {

Color stored_range(const Plane& plane, uint32_t layer, int64_t x, int64_t y) {
  const Texture& texture = *plane.texture;
  TexelReader reader(texture);
  const uint8_t* texel = reader.at(first_unit(texture, layer, plane.level), static_cast<uint32_t>(plane.width),
                                   static_cast<uint32_t>(x), static_cast<uint32_t>(y));
  Color color;
  if (texture.component == image::Component::kSrgb8) {
    for (uint32_t c = 0; c < texture.channels; ++c) {
      const double alpha = texel[c] / 255.0;
      color.channel[c] = c == 3 ? Range{alpha, alpha} : plane.model->srgb[texel[c]];
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

Color border_range(const Plane& plane) {
  Color color;
  for (uint32_t c = 0; c < plane.texture->channels; ++c) {
    color.channel[c].add(static_cast<double>(plane.sampler->border[c]));
  }
  return color;
}

/// The texel beside an edge of a face, on the adjacent face. Centres are odd or even numbers 1 - n..n - 1 on a cube of
/// half width n; a texel beyond an edge is the first one beside the edge.
Color beside_edge(const Plane& plane, int64_t i, int64_t j) {
  const int64_t n = plane.width, s = 2 * i + 1 - n, t = 2 * j + 1 - n;
  const CubeFace& from = kCubeFaces[plane.layer];
  const bool across = s < -n || s > n;
  int64_t vector[3];
  set_component(from.axis, n - 1, vector);
  set_component(from.right, across ? (s < 0 ? -n : n) : s, vector);
  set_component(from.down, across ? t : (t < 0 ? -n : n), vector);
  const int side = across ? (s < 0 ? -from.right : from.right) : (t < 0 ? -from.down : from.down);
  const uint32_t face = face_at(side);
  const int64_t x = (component(vector, kCubeFaces[face].right) + n - 1) / 2;
  const int64_t y = (component(vector, kCubeFaces[face].down) + n - 1) / 2;
  return stored_range(plane, face, x, y);
}

/// The missing texel beyond a corner: the average of the three texels around it.
Color beyond_corner(const Plane& plane, int64_t i, int64_t j) {
  const int64_t x = i < 0 ? 0 : plane.width - 1, y = j < 0 ? 0 : plane.height - 1;
  const Color three[3] = {stored_range(plane, plane.layer, x, y), beside_edge(plane, i, y), beside_edge(plane, x, j)};
  Color average;
  for (int c = 0; c < 4; ++c) {
    Range& to = average.channel[c] = {0.0, 0.0};
    for (const Color& color : three) to.low += color.channel[c].low / 3.0, to.high += color.channel[c].high / 3.0;
  }
  return average;
}

}  // namespace

Plane plane_of(const Texture& texture, const Sampler& sampler, const BoundsModel& model, uint32_t layer,
               uint32_t level) {
  return {
      &texture, &sampler, &model, layer, level, level_size(texture.width, level), level_size(texture.height, level)};
}

Color texel_range(const Plane& plane, int64_t i, int64_t j) {
  if (plane.texture->projection == SHD_PROJECTION_CUBE) {
    const bool across = i < 0 || i >= plane.width, down = j < 0 || j >= plane.height;
    if (across && down) return beyond_corner(plane, i, j);
    return across || down ? beside_edge(plane, i, j) : stored_range(plane, plane.layer, i, j);
  }
  const int64_t x = wrap_index(plane.sampler->wrap_u, i, plane.width);
  const int64_t y = wrap_index(plane.sampler->wrap_v, j, plane.height);
  return x < 0 || y < 0 ? border_range(plane) : stored_range(plane, plane.layer, x, y);
}

Color format_range(const Texture& texture, const Sampler& sampler) {
  Color color;
  for (uint32_t c = 0; c < texture.channels; ++c) {
    color.channel[c] = is_float(texture.component) ? unbounded() : Range{0.0, largest_of(texture.component, c)};
    if (has_border(texture, sampler)) color.channel[c].add(static_cast<double>(sampler.border[c]));
  }
  return color;
}

}  // namespace shd::texture
