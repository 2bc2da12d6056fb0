// SPDX-License-Identifier: MIT
#include "texture/oracle/explain.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/read_desc.h"
#include "data/compare.h"
#include "texture/domain/lod.h"
#include "texture/format/formats.h"
#include "texture/format/record.h"
#include "texture/lookup/magnify.h"
#include "texture/lookup/sample.h"
#include "texture/store/reader.h"
#include "texture/store/storage.h"
#include "texture/table/decoded.h"

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

/// The image and the level whose first unit is `first`.
struct Place {
  uint32_t image, level_u, level_v;
};

Place mip_place(const UnitPlace& unit) {
  return {unit.image, unit.level, unit.level};
}

Place ripmap_place(const Texture& texture, uint32_t first) {
  const uint32_t in_layer = first % texture.layout.layer_units;
  for (uint32_t j = 0; j < texture.ripmap_rows; ++j) {
    for (uint32_t i = 0; i < texture.ripmap_columns; ++i) {
      if (texture.ripmap_offset[j * kMaxLevels + i] == in_layer) return {first / texture.layout.layer_units, i, j};
    }
  }
  return {};
}

shd_tap describe(const Texture& texture, const Sampler& sampler, const Recording& recording, const RecordedTap& tap,
                 TexelReader* reader) {
  shd_tap out = {};
  const bool ripmap = sampler.filter == SHD_FILTER_RIPMAP;
  const Place place = ripmap ? ripmap_place(texture, tap.first) : mip_place(place_of_unit(texture, tap.first));
  (texture.depth != 0 ? out.z : out.layer) = place.image;
  out.level_u = place.level_u;
  out.level_v = place.level_v;
  out.x = tap.x;
  out.y = tap.y;
  out.border = tap.border;
  if (tap.border) {
    std::copy_n(sampler.border, texture.channels, out.value);
  } else {
    const uint8_t* const texel = reader->at(tap.first, level_size(texture.width, place.level_u), tap.x, tap.y);
    for (size_t c = 0; c < texture.channels; ++c) out.value[c] = lerp_value(texture, texel, c, recording.finished_taps);
  }
  if (sampler.compares && texture.channel_source[0] != kFill) {
    float& value = out.value[texture.channel_source[0]];
    value = passes(data::comparison_of(sampler.compare), recording.reference, value) ? 1.0f : 0.0f;
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
  TexelReader reader(texture);
  for (size_t i = 0; i < recording.tap_count && i < out->tap_capacity; ++i) {
    shd_tap tap = describe(texture, sampler, recording, recording.taps[i], &reader);
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

void explain(const core::Context& context, const Texture& given, const Sampler& sampler, const Lookups& lookups,
             shd_explanation* out) {
  const Sampler taken = sampler_of(given, sampler, context.simd, lookups);
  const Texture& texture = read_by(given, taken.filter);
  Recording recording(context.allocator);
  recording.finished_taps = has_border(texture, taken) || taken.compares;
  recording.reference = clamped_reference(texture.component, lookups.reference ? lookups.reference[0] : 0.0f);
  sample(texture, taken, context.simd, lookups, {}, &recording);
  write_tree(context, texture, taken, recording, out);
  out->filter = taken.filter;
  for (size_t c = 0; c < 4; ++c) {
    out->channel_source[c] = taken.compares && c > 0 ? kFill : given.channel_source[c];
  }
  const Texels result = {{&out->result[0], &out->result[1], &out->result[2], &out->result[3]}, {}, {}};
  Sampler full = sampler;  // the tree of blends has no other precision
  full.precision = SHD_PRECISION_FULL;
  sample(given, full, context.simd, lookups, result);
  find_lods(texture, sampler, lod_range(texture, sampler), LodAxis::kLonger, context.simd, lookups, &out->lod);
  float axes[4];
  find_axes(texture, sampler, context.simd, lookups, axes);
  std::memcpy(out->longer_axis, axes, sizeof out->longer_axis);
  std::memcpy(out->shorter_axis, axes + 2, sizeof out->shorter_axis);
}

}  // namespace shd::texture
