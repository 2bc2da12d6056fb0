// SPDX-License-Identifier: MIT
#include "volume/march.h"

#include <algorithm>
#include <cmath>

#include "texture/lookup/sample.h"

namespace shd::volume {
namespace {

constexpr float kOpaque = 0.999f;

/// Blocks of a volume along a ray.
struct Blocks {
  const Volume& volume;
  double per_box[3];  // blocks in the box, with fractions

  explicit Blocks(const Volume& of_volume) : volume(of_volume) {
    const texture::Texture& texture = *volume.texture;
    const uint32_t size[3] = {texture.width, texture.height, texture.depth};
    for (int c = 0; c < 3; ++c) per_box[c] = static_cast<double>(size[c]) / kBlockEdge;
  }

  /// Moves `*step` to the next step of a ray in a visible block. Returns the end of the steps in this block, or the
  /// end of the ray.
  uint32_t find_visible(const Ray& ray, uint32_t* step) const {
    while (*step < ray.count) {
      const double t = static_cast<double>(*step) + static_cast<double>(ray.offset);
      double exit = ray.count;  // [steps]
      uint32_t block[3];
      for (int c = 0; c < 3; ++c) {
        const double at = (static_cast<double>(ray.origin[c]) + t * static_cast<double>(ray.step[c])) * per_box[c];
        block[c] = static_cast<uint32_t>(std::min(std::max(at, 0.0), static_cast<double>(volume.blocks[c] - 1)));
      }
      const uint32_t distance =
          volume.distance[(size_t{block[2]} * volume.blocks[1] + block[1]) * volume.blocks[0] + block[0]];
      // Blocks closer than the distance are invisible, too.
      const uint32_t reach = distance == 0 ? 0 : distance - 1;
      for (int c = 0; c < 3; ++c) {
        const double along = static_cast<double>(ray.step[c]), origin = static_cast<double>(ray.origin[c]);
        if (along == 0.0) continue;
        const double face =
            along > 0.0 ? static_cast<double>(block[c]) + reach + 1.0 : static_cast<double>(block[c]) - reach;
        exit = std::min(exit, (face / per_box[c] - origin) / along);
      }
      const double next = std::floor(exit - static_cast<double>(ray.offset)) + 1.0;
      const uint32_t end =
          std::max(*step + 1, next < ray.count ? static_cast<uint32_t>(std::max(next, 0.0)) : ray.count);
      if (distance == 0) return end;
      *step = end;
    }
    return ray.count;
  }
};

/// Takes the next steps of the active rays. Drops rays that have none. Returns the number of steps.
size_t take_steps(const Blocks& blocks, March* m, size_t* active_count) {
  RoundSamples& s = m->samples;
  size_t count = 0, kept = 0;
  for (size_t i = 0; i < *active_count; ++i) {
    const uint16_t r = m->active[i];
    const Ray& ray = m->ray[r];
    const size_t first = count;
    while (count - first < kRoundSteps && m->next[r] < ray.count) {
      const uint32_t end = blocks.find_visible(ray, &m->next[r]);
      for (; m->next[r] < end && count - first < kRoundSteps; ++m->next[r], ++count) {
        const float t = static_cast<float>(m->next[r]) + ray.offset;
        s.u[count] = ray.origin[0] + t * ray.step[0];
        s.v[count] = ray.origin[1] + t * ray.step[1];
        s.w[count] = ray.origin[2] + t * ray.step[2];
        s.dt[count] = ray.dt;
        s.ray[count] = r;
        s.step[count] = m->next[r];
      }
    }
    if (count > first) m->active[kept++] = r;
  }
  *active_count = kept;
  return count;
}

/// Looks up the densities of a round.
void look_up(const core::SimdTarget& simd, const Volume& volume, size_t count, RoundSamples* s) {
  texture::Lookups lookups = {};
  lookups.count = count;
  lookups.u = s->u;
  lookups.v = s->v;
  lookups.w = s->w;
  texture::Texels texels = {};
  texels.channel[0] = s->density;
  texture::sample(*volume.texture, volume.sampler, simd, lookups, texels);
}

/// Adds the steps of a round to their rays, and drops rays that are opaque.
void accumulate(size_t count, March* m, size_t* active_count) {
  const RoundSamples& s = m->samples;
  size_t i = 0, kept = 0;
  for (size_t a = 0; a < *active_count; ++a) {
    const uint16_t r = m->active[a];
    float* color = m->color[r];
    for (; i < count && s.ray[i] == r; ++i) {
      if (color[3] > kOpaque) continue;
      const float share = (1.0f - color[3]) * s.opacity[i];
      for (int c = 0; c < 3; ++c) color[c] += share * s.color[c][i];
      color[3] = std::min(color[3] + share, 1.0f);
    }
    if (!(color[3] > kOpaque)) m->active[kept++] = r;
  }
  *active_count = kept;
}

}  // namespace

void march(const core::SimdTarget& simd, const Volume& volume, const PointShading* shading, March* m) {
  const Blocks blocks(volume);
  size_t active_count = m->count;
  for (size_t r = 0; r < m->count; ++r) {
    std::fill_n(m->color[r], 4, 0.0f);
    m->next[r] = 0;
    m->active[r] = static_cast<uint16_t>(r);
  }
  RoundSamples& s = m->samples;
  while (const size_t count = take_steps(blocks, m, &active_count)) {
    look_up(simd, volume, count, &s);
    std::fill(s.density + count, s.density + std::min(count + 16, kRoundSamples), 0.0f);
    std::fill(s.dt + count, s.dt + std::min(count + 16, kRoundSamples), 0.0f);
    transfer(simd, volume.transfer, s.density, s.dt, count, {s.opacity, {s.color[0], s.color[1], s.color[2]}});
    if (shading) {
      const Points points = {
          count, s.u, s.v, s.w, s.opacity, s.ray, s.step, m->ray, {s.color[0], s.color[1], s.color[2]}};
      shade(simd, volume, *shading, points, &m->gradient);
    }
    accumulate(count, m, &active_count);
  }
}

}  // namespace shd::volume
