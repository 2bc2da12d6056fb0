// SPDX-License-Identifier: MIT
#include "texture/oracle/explain.h"

#include <cmath>
#include <cstring>

#include "core/read_desc.h"
#include "texture/domain/lod.h"
#include "texture/format/formats.h"
#include "texture/format/record.h"
#include "texture/lookup/magnify.h"
#include "texture/lookup/sample.h"
#include "texture/store/bc/levels.h"
#include "texture/store/storage.h"

namespace shd::texture {

namespace {

CodeScale scale_of(image::Component component, size_t channel) {
  CodeScale scale = {1.0f, 0.0f};
  visit_codec(component, 4, [&](auto codec) { scale = codec.scale(channel); });
  return scale;
}

float finish(CodeScale scale, float value) {
  return scale.low == 0.0f ? value : value * scale.high + value * scale.low;
}

/// Returns a channel of a stored texel in the lerp domain of its format, or as a result if `finished`.
float lerp_value(const Texture& texture, const uint8_t* texel, size_t channel, bool finished) {
  double value[4] = {};
  visit_stored(texture.component, texture.channels, [&](auto codec) { codec.load(texel, value); });
  const auto number = static_cast<float>(value[channel]);
  return finished ? finish(scale_of(texture.component, channel), number) : number;
}

/// Level of a texel, and the first texel of this level in the layer.
struct Place {
  uint32_t level_u, level_v, first;
};

Place mip_place(const Texture& texture, uint32_t texel) {
  uint32_t level = 0;
  while (level + 1 < texture.level_count && texel >= texture.offset[level + 1]) ++level;
  return {level, level, texture.offset[level]};
}

Place ripmap_place(const Texture& texture, uint32_t texel) {
  for (uint32_t j = 0; j < texture.ripmap_rows; ++j) {
    for (uint32_t i = 0; i < texture.ripmap_columns; ++i) {
      const uint32_t first = texture.ripmap_offset[j * kMaxLevels + i];
      const uint32_t count = level_size(texture.width, i) * level_size(texture.height, j);
      if (texel >= first && texel - first < count) return {i, j, first};
    }
  }
  return {0, 0, 0};
}

shd_tap describe(const Texture& texture, const Sampler& sampler, const Recording& recording, const RecordedTap& tap) {
  shd_tap out = {};
  out.layer = tap.index / texture.layer_texels;  // 0 for 3D textures
  const uint32_t in_layer = tap.index % texture.layer_texels;
  const Place place =
      sampler.filter == SHD_FILTER_RIPMAP ? ripmap_place(texture, in_layer) : mip_place(texture, in_layer);
  const uint32_t width = level_size(texture.width, place.level_u);
  out.level_u = place.level_u;
  out.level_v = place.level_v;
  out.x = (in_layer - place.first) % width;
  const uint32_t row = (in_layer - place.first) / width, height = level_size(texture.height, place.level_v);
  out.y = texture.depth != 0 ? row % height : row;
  out.z = texture.depth != 0 ? row / height : 0;
  out.border = tap.border;
  DecodedBlock decoded;
  const uint8_t* texel = texel_of(texture, tap.index, &decoded);
  for (size_t c = 0; c < texture.channels; ++c) {
    out.value[c] = tap.border ? sampler.border[c] : lerp_value(texture, texel, c, recording.finished_taps);
  }
  return out;
}

uint32_t node_number(const Recording& recording, uint32_t node) {
  if (!(node & kBlendNode)) return node;
  return static_cast<uint32_t>(recording.tap_count) + (node & ~kBlendNode);
}

/// Returns the weights of all nodes. The last node has weight 1; each blend distributes its weight to its two operands,
/// in reverse order.
core::Array<float> weights(const core::Allocator& allocator, const Recording& recording) {
  const size_t count = recording.tap_count + recording.blend_count;
  core::Array<float> weight(allocator, count);
  std::memset(weight.data(), 0, count * sizeof(float));
  weight[count - 1] = 1.0f;
  for (size_t k = recording.blend_count; k-- > 0;) {
    const RecordedBlend& blend = recording.blends[k];
    const float own = weight[recording.tap_count + k];
    weight[node_number(recording, blend.a)] += own * (1.0f - blend.s);
    weight[node_number(recording, blend.b)] += own * blend.s;
  }
  return weight;
}

/// Writes element i of the caller's array, whose elements are `size` bytes apart.
template <class Element>
void store_element(const Element& element, Element* elements, size_t i, size_t size) {
  core::write_element_bytes(&element, sizeof element, reinterpret_cast<unsigned char*>(elements) + i * size, size);
}

void write_tree(const core::Context& context, const Texture& texture, const Sampler& sampler,
                const Recording& recording, shd_explanation* out) {
  const core::Array<float> weight = weights(context.allocator, recording);
  for (size_t i = 0; i < recording.tap_count && i < out->tap_capacity; ++i) {
    shd_tap tap = describe(texture, sampler, recording, recording.taps[i]);
    tap.weight = weight[i];
    store_element(tap, out->taps, i, out->tap_size);
  }
  for (size_t k = 0; k < recording.blend_count && k < out->blend_capacity; ++k) {
    const RecordedBlend& blend = recording.blends[k];
    const shd_blend_step step = {node_number(recording, blend.a), node_number(recording, blend.b), blend.s};
    store_element(step, out->blends, k, out->blend_size);
  }
  out->tap_count = static_cast<uint32_t>(recording.tap_count);
  out->blend_count = static_cast<uint32_t>(recording.blend_count);
  for (size_t c = 0; c < 4; ++c) {
    const CodeScale scale = recording.finished_taps ? CodeScale{1.0f, 0.0f} : scale_of(texture.component, c);
    out->scale_high[c] = scale.high;
    out->scale_low[c] = scale.low;
  }
}

}  // namespace

void explain(const core::Context& context, const Texture& texture, const Sampler& sampler, const Lookups& lookups,
             shd_explanation* out) {
  const Sampler taken = sampler_of(texture, sampler, context.simd, lookups);
  Recording recording(context.allocator);
  recording.finished_taps = has_border(texture, taken);
  sample(texture, taken, context.simd, lookups, {}, &recording);
  write_tree(context, texture, taken, recording, out);
  out->filter = taken.filter;
  for (size_t c = 0; c < 4; ++c) out->channel_source[c] = texture.channel_source[c];
  const Texels result = {{&out->result[0], &out->result[1], &out->result[2], &out->result[3]}, {}, {}};
  Sampler full = sampler;  // the tree of blends has no other precision
  full.precision = SHD_PRECISION_FULL;
  sample(texture, full, context.simd, lookups, result);
  find_lods(texture, sampler, lod_range(texture, sampler), LodAxis::kLonger, context.simd, lookups, &out->lod);
  float axes[4];
  find_axes(texture, sampler, context.simd, lookups, axes);
  std::memcpy(out->longer_axis, axes, sizeof out->longer_axis);
  std::memcpy(out->shorter_axis, axes + 2, sizeof out->shorter_axis);
}

}  // namespace shd::texture
