// SPDX-License-Identifier: MIT
#include "volume/blocks.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/executor.h"
#include "texture/format/formats.h"
#include "texture/store/reader.h"
#include "texture/store/storage.h"
#include "volume/volume.h"

namespace shd::volume {
namespace {

constexpr uint32_t kApron = 2;
constexpr uint8_t kFarthest = 255;

/// Densities of some texels: the smallest and the largest, and whether some are infinite or NaN.
struct Range {
  double low = INFINITY, high = -INFINITY;
  bool is_finite = true;

  void add(double value) {
    low = value < low ? value : low;
    high = value > high ? value : high;
    is_finite = is_finite && std::isfinite(value);
  }
};

struct Span {
  uint32_t first, end;
};

Span texels_of(uint32_t block, uint32_t size) {
  const uint32_t begin = block * kBlockEdge;
  return {begin < kApron ? 0 : begin - kApron, std::min(begin + kBlockEdge + kApron, size)};
}

/// Returns the range of stored numbers of a channel over a block.
template <class Codec>
Range range_of(const texture::Texture& texture, uint32_t channel, const Span& x, const Span& y, const Span& z) {
  texture::TexelReader reader(texture);
  Range range;
  for (uint32_t k = z.first; k < z.end; ++k) {
    const uint32_t slice = texture::first_unit(texture, k, 0);
    for (uint32_t j = y.first; j < y.end; ++j) {
      for (uint32_t i = x.first; i < x.end; ++i) {
        double value[Codec::kChannels];
        Codec::load(reader.at(slice, texture.width, i, j), value);
        range.add(value[channel]);
      }
    }
  }
  return range;
}

/// Whether a block may have extinction. Lookups of its densities may exceed the range by their rounding.
bool is_visible_in(const Volume& volume, const Range& range, double scale) {
  if (!range.is_finite) return true;
  const double low = range.low * scale, high = range.high * scale;
  const double slack = 4e-6 * (std::fabs(low) + std::fabs(high));
  return is_visible(volume.transfer, static_cast<float>(low - slack), static_cast<float>(high + slack));
}

/// Sets the distance of visible blocks to 0 and of the others to the largest.
void find_visible(const core::Context& context, Volume* volume) {
  const texture::Texture& texture = *volume->texture;
  const uint32_t channel = texture.channel_source[0];
  const uint32_t* blocks = volume->blocks;
  core::parallel_for(context, blocks[2], [&](uint32_t bz, uint32_t) {
    for (uint32_t by = 0; by < blocks[1]; ++by) {
      for (uint32_t bx = 0; bx < blocks[0]; ++bx) {
        bool visible = true;
        if (channel == texture::kFill) {
          visible = is_visible(volume->transfer, texture.fill[0], texture.fill[0]);
        } else {
          texture::visit_stored(texture.component, texture.channels, [&](auto codec) {
            using Codec = decltype(codec);
            const texture::CodeScale scale = codec.scale(channel);
            const double factor = static_cast<double>(scale.high) + static_cast<double>(scale.low);
            visible = is_visible_in(*volume,
                                    range_of<Codec>(texture, channel, texels_of(bx, texture.width),
                                                    texels_of(by, texture.height), texels_of(bz, texture.depth)),
                                    Codec::kFloat ? 1.0 : factor);
          });
        }
        volume->distance[(size_t{bz} * blocks[1] + by) * blocks[0] + bx] = visible ? 0 : kFarthest;
      }
    }
  });
}

/// Distances of the blocks around a block.
struct Neighbours {
  uint8_t* distance;
  const uint32_t* blocks;

  /// Returns the smallest distance among the neighbours of a block, at most kFarthest - 1.
  uint8_t smallest(uint32_t x, uint32_t y, uint32_t z) const {
    uint8_t least = kFarthest - 1;
    for (uint32_t k = z == 0 ? 0 : z - 1; k <= std::min(z + 1, blocks[2] - 1); ++k) {
      for (uint32_t j = y == 0 ? 0 : y - 1; j <= std::min(y + 1, blocks[1] - 1); ++j) {
        for (uint32_t i = x == 0 ? 0 : x - 1; i <= std::min(x + 1, blocks[0] - 1); ++i) {
          least = std::min(least, distance[(size_t{k} * blocks[1] + j) * blocks[0] + i]);
        }
      }
    }
    return least;
  }

  void lower(uint32_t x, uint32_t y, uint32_t z) const {
    uint8_t& own = distance[(size_t{z} * blocks[1] + y) * blocks[0] + x];
    own = std::min(own, static_cast<uint8_t>(smallest(x, y, z) + 1));
  }
};

/// Distances in the norm of the largest component: two passes over the 26 neighbours are exact (Rosenfeld and Pfaltz,
/// "Sequential Operations in Digital Picture Processing", Journal of the ACM 13(4), 1966).
void spread_distances(Volume* volume) {
  const uint32_t* blocks = volume->blocks;
  const Neighbours neighbours = {volume->distance.data(), blocks};
  for (uint32_t z = 0; z < blocks[2]; ++z) {
    for (uint32_t y = 0; y < blocks[1]; ++y) {
      for (uint32_t x = 0; x < blocks[0]; ++x) neighbours.lower(x, y, z);
    }
  }
  for (uint32_t z = blocks[2]; z-- > 0;) {
    for (uint32_t y = blocks[1]; y-- > 0;) {
      for (uint32_t x = blocks[0]; x-- > 0;) neighbours.lower(x, y, z);
    }
  }
}

}  // namespace

void find_distances(const core::Context& context, Volume* volume) {
  const uint32_t size[3] = {volume->texture->width, volume->texture->height, volume->texture->depth};
  size_t count = 1;
  for (int c = 0; c < 3; ++c) {
    volume->blocks[c] = (size[c] + kBlockEdge - 1) / kBlockEdge;
    count *= volume->blocks[c];
  }
  volume->distance = core::Array<uint8_t>(context.allocator, count);
  find_visible(context, volume);
  spread_distances(volume);
}

}  // namespace shd::volume
