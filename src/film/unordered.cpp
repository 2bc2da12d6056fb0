// SPDX-License-Identifier: MIT
#include "film/unordered.h"

#include <algorithm>

namespace shd::film {
namespace {

using raster::kTilePixels;

/// Plane i of the sums of a sample.
float* sums_of(Unordered* unordered, uint32_t sample, size_t i) {
  return unordered->sums.data() + (sample * kSums + i) * kTilePixels;
}
const float* sums_of(const Unordered& unordered, uint32_t sample, size_t i) {
  return unordered.sums.data() + (sample * kSums + i) * kTilePixels;
}

/// McGuire and Bavoil (2013), equation 10, without its factor a, which premultiplied colours already contain.
float weight_at(float depth) {
  const float near = 1.0f - depth;
  const float weight = 3000.0f * (near * near * near);
  return weight > 0.01f ? weight : 0.01f;
}

/// A total order: by position, then from far to near, then by order of arrival.
bool comes_before(const SortedNode& a, const SortedNode& b) {
  if (a.position != b.position) return a.position < b.position;
  if (a.distance != b.distance) return a.distance > b.distance;
  return a.order < b.order;
}

}  // namespace

void clear_weighted(const core::Allocator& allocator, uint32_t samples, Unordered* unordered) {
  if (unordered->sums.size() == 0) unordered->sums = core::Array<float>(allocator, samples * kSums * kTilePixels);
  for (uint32_t s = 0; s < samples; ++s) {
    for (size_t i = 0; i < kSums; ++i) {
      std::fill_n(sums_of(unordered, s, i), kTilePixels, i + 1 == kSums ? 1.0f : 0.0f);
    }
  }
}

void add_weighted(uint32_t sample, uint32_t pixel, float depth, const FragmentColor& color, Unordered* unordered) {
  const float weight = weight_at(depth);
  for (size_t i = 0; i < 4; ++i) sums_of(unordered, sample, i)[pixel] += weight * color.channel[i];
  sums_of(unordered, sample, 4)[pixel] *= 1.0f - color.channel[3];
}

void blend_weighted(uint32_t samples, const Unordered& unordered, TileColor* color) {
  for (uint32_t s = 0; s < samples; ++s) {
    const float *weights = sums_of(unordered, s, 3), *rests = sums_of(unordered, s, 4);
    for (uint32_t pixel = 0; pixel < kTilePixels; ++pixel) {
      if (weights[pixel] == 0.0f) continue;
      const float cover = 1.0f - rests[pixel], share = cover / weights[pixel];
      const Destination destination = color->sample(pixel, s);
      for (size_t i = 0; i < 3; ++i) {
        float& d = *destination.channel[i];
        d = share * sums_of(unordered, s, i)[pixel] + rests[pixel] * d;
      }
      float& a = *destination.channel[3];
      a = cover + rests[pixel] * a;
    }
  }
}

void blend_sorted(Unordered* unordered, TileColor* color) {
  SortedNode* nodes = unordered->nodes.data();
  std::sort(nodes, nodes + unordered->nodes.size(), comes_before);
  for (size_t i = 0; i < unordered->nodes.size(); ++i) {
    const Destination destination = color->sample(nodes[i].position % kTilePixels, nodes[i].position / kTilePixels);
    blend(SHD_BLEND_PREMULTIPLIED, nodes[i].color, destination);
  }
}

}  // namespace shd::film
