// SPDX-License-Identifier: MIT
#include "environment/radiance.h"

#include <algorithm>
#include <cmath>

#include "core/executor.h"
#include "core/status.h"
#include "data/trig.h"
#include "projection/projection.h"
#include "texture/lookup/sample.h"

namespace shd::environment {
namespace {

constexpr size_t kBlock = 256;  // points of the map that are looked up together

/// Directions where texels of the image are narrow.
struct NarrowTexels {
  uint32_t rows = 0;    // LAT_LONG: from each pole
  double radius = 2.0;  // discs: texels with their centres beyond it
  float height = 2.0f;  // directions with |y| above it
  float depth = -2.0f;  // directions with z below it
  bool includes_all = false;

  bool contains(const float* const* n, size_t i) const { return std::fabs(n[1][i]) > height || n[2][i] < depth; }
  bool any() const { return rows > 0 || radius < 1.0; }
};

/// sin(pi t) and cos(pi t) for t in [0, 1].
double sine_pi(double t) {
  return data::sin(data::kPi * std::min(t, 1.0 - t));
}
double cosine_pi(double t) {
  return t > 0.5 ? -data::cos(data::kPi * (1.0 - t)) : data::cos(data::kPi * t);
}

/// Rows of LAT_LONG from a pole whose texels are narrower than `distance`.
uint32_t narrow_rows(const texture::DirectionFloats& image, double distance) {
  const uint32_t half = (image.height + 1) / 2;
  if (data::kPi / image.height < distance) return half;
  uint32_t rows = 0;
  while (rows < half && 2.0 * data::kPi / image.width * sine_pi((rows + 0.5) / image.height) < distance) ++rows;
  return rows;
}

/// Distance from the centre at which the texels of a disc are `distance` wide.
double narrow_radius(const texture::DirectionFloats& image, double distance) {
  const double wanted = 0.5 * distance * image.width;
  double low = 0.0, high = 1.0;
  for (int k = 0; k < 40; ++k) {
    const double r = 0.5 * (low + high);
    const double width = image.projection == SHD_PROJECTION_ANGULAR ? sine_pi(r) / r : 2.0 * std::sqrt(1.0 - r * r);
    (width < wanted ? high : low) = r;
  }
  return low;
}

/// Finds the texels narrower than `distance`. Texels of CUBE and OCTAHEDRAL are wider.
NarrowTexels find_narrow(const texture::DirectionFloats& image, double distance) {
  NarrowTexels narrow;
  switch (image.projection) {
    case SHD_PROJECTION_LAT_LONG:
      narrow.rows = narrow_rows(image, distance);
      narrow.includes_all = 2 * narrow.rows >= image.height;
      narrow.height =
          narrow.includes_all ? -1.0f : static_cast<float>(cosine_pi(static_cast<double>(narrow.rows) / image.height));
      return narrow;
    case SHD_PROJECTION_MIRROR_BALL:
      narrow.radius = narrow_radius(image, distance);
      narrow.depth = static_cast<float>(1.0 - 2.0 * narrow.radius * narrow.radius);
      return narrow;
    case SHD_PROJECTION_ANGULAR:
      narrow.radius = narrow_radius(image, distance);
      narrow.depth = static_cast<float>(cosine_pi(narrow.radius));
      return narrow;
    case SHD_PROJECTION_CUBE:
    case SHD_PROJECTION_OCTAHEDRAL: return narrow;
    case SHD_PROJECTION_NONE:
    case SHD_PROJECTION_MAX_ENUM: break;
  }
  SHD_UNREACHABLE();
}

/// A block of directions and their radiance.
struct Block {
  size_t count = 0;
  float u[kBlock], v[kBlock], weight[kBlock];
  uint32_t face[kBlock];
  float direction[3][kBlock], value[3][kBlock];
};

/// The finest level while it is made: sums of radiance times solid angle, and of solid angles.
class BaseMap {
 public:
  BaseMap(const core::Context& context, const Source& source, const Level& level, float* texels)
      : context_(context), source_(source), level_(level), texels_(texels) {
    const double density = std::sqrt(static_cast<double>(source.texels())) / level.size;
    parts_ = static_cast<uint32_t>(std::clamp(std::ceil(2.0 * density), 2.0, 8.0));
    narrow_ = find_narrow(source.image, std::sqrt(4.0 * data::kPi) / (level.size * parts_));
    const double h = data::kPi / source.image.height;
    shift_ = static_cast<float>(h * h / 24.0);
    texture::borrow(context, source.image, &texture_);
  }

  void fill() {
    if (!narrow_.includes_all) {
      core::parallel_for(context_, level_.size, [&](uint32_t row, uint32_t) { gather_row(row); });
    } else {
      std::fill_n(texels_ + 4 * size_t{level_.first}, 4 * texel_count(level_.size), 0.0f);
    }
    if (narrow_.any()) splat();
    core::parallel_for(context_, level_.size, [&](uint32_t row, uint32_t) { finish_row(row); });
  }

 private:
  float* texel(uint32_t x, uint32_t y) const {
    return texels_ + 4 * texel_index(level_, static_cast<int32_t>(x), static_cast<int32_t>(y));
  }

  /// Looks up the image. In LAT_LONG, bilinear lookups would give a texel of row 0 13/12 of its light, because the
  /// width of rows grows from the pole. With h = pi / height, every row keeps its light up to h^4 if lookups at the
  /// angle t from a pole move away from it by h^2 / 24 cot t: y becomes y (1 - h^2 / 24). In row 0 they move less, so
  /// that the pole stays in its place: y becomes y (1 - k) with k = h^2 / 24 s^2 / (s^2 + h^2 / 6), s = sin t.
  void look_up(Block* block) const {
    texture::Lookups in = {};
    float x[kBlock], y[kBlock], z[kBlock];
    for (size_t i = 0; i < block->count; ++i) {
      x[i] = block->direction[0][i], y[i] = block->direction[1][i], z[i] = block->direction[2][i];
      if (source_.image.projection != SHD_PROJECTION_LAT_LONG) continue;
      const float s2 = x[i] * x[i] + z[i] * z[i], part = shift_ / (s2 + 4.0f * shift_), k = part * s2;
      const float longer = std::sqrt(1.0f + std::max(0.0f, 1.0f - s2) * (2.0f - k) * part);  // ratio of sines
      x[i] *= longer, y[i] -= y[i] * k, z[i] *= longer;
    }
    in.count = block->count;
    in.u = x, in.v = y, in.w = z;
    texture::sample(texture_, sampler_, context_.simd, in,
                    {{block->value[0], block->value[1], block->value[2], nullptr}, {}, {}});
  }

  /// Sets one row to sums over parts_ x parts_ lookups a texel, without those in narrow texels.
  void gather_row(uint32_t row) const {
    const uint32_t lookups = parts_ * parts_, group = static_cast<uint32_t>(kBlock) / lookups;
    const float step = 1.0f / static_cast<float>(parts_), inverse = 1.0f / static_cast<float>(level_.size);
    Block block;
    for (uint32_t x = 0; x < level_.size; x += group) {
      const uint32_t count = std::min(group, level_.size - x);
      block.count = size_t{count} * lookups;
      for (uint32_t i = 0; i < block.count; ++i) {
        const uint32_t part = i % lookups;
        block.u[i] =
            (static_cast<float>(x + i / lookups) + (static_cast<float>(part % parts_) + 0.5f) * step) * inverse;
        block.v[i] = (static_cast<float>(row) + (static_cast<float>(part / parts_) + 0.5f) * step) * inverse;
      }
      float* const n[3] = {block.direction[0], block.direction[1], block.direction[2]};
      projection::unproject(SHD_PROJECTION_OCTAHEDRAL, context_.simd, {block.count, block.u, block.v, nullptr},
                            {{n[0], n[1], n[2]}, block.weight});
      look_up(&block);
      for (uint32_t i = 0; i < count; ++i) {
        float sum[4] = {};
        for (uint32_t k = i * lookups; k < (i + 1) * lookups; ++k) {
          if (narrow_.contains(n, k)) continue;
          for (int c = 0; c < 3; ++c) sum[c] += block.weight[k] * block.value[c][k];
          sum[3] += block.weight[k];
        }
        const float scale = inverse * inverse / static_cast<float>(lookups);
        for (int c = 0; c < 4; ++c) texel(x + i, row)[c] = scale * sum[c];
      }
    }
  }

  bool is_narrow(uint32_t x, uint32_t y) const {
    const uint32_t size = source_.image.height;
    if (narrow_.rows > 0) return std::min(y, size - 1 - y) < narrow_.rows;
    const double p = (2.0 * x + 1.0) / size - 1.0, q = (2.0 * y + 1.0) / size - 1.0;
    return p * p + q * q > narrow_.radius * narrow_.radius;
  }

  /// Adds narrow texels to the texels of the map that they cover.
  void splat() {
    Block block;
    std::fill_n(block.face, kBlock, 0);
    for (uint32_t y = 0; y < source_.image.height; ++y) {
      for (uint32_t x = 0; x < source_.image.width; ++x) {
        if (is_narrow(x, y)) splat_texel(x, y, &block);
      }
    }
    flush(&block);
  }

  /// Adds lookups in a texel of the image, no farther apart than a quarter of a texel of the map. If many texels of
  /// the image lie in one texel of the map, they share its lookups: each has its own places.
  void splat_texel(uint32_t x, uint32_t y, Block* block) {
    const texture::DirectionFloats& image = source_.image;
    const auto extent = projection::texel_extent(image.projection, image.width, image.height, x, y);
    const double u = 2.0 * extent.along_u * level_.size, v = 2.0 * extent.along_v * level_.size;
    const Places across = places_along(u, v, y), down = places_along(v, u, x);
    const float weight = 1.0f / (static_cast<float>(image.width) * static_cast<float>(image.height) *
                                 static_cast<float>(across.count) * static_cast<float>(down.count));
    for (uint32_t j = 0; j < down.count; ++j) {
      for (uint32_t i = 0; i < across.count; ++i) {
        if (block->count == kBlock) flush(block);
        const size_t k = block->count++;
        block->u[k] = static_cast<float>((x + (i + across.shift) / across.count) / image.width);
        block->v[k] = static_cast<float>((y + (j + down.shift) / down.count) / image.height);
        block->weight[k] = weight;
      }
    }
  }

  /// Lookups along a side: at (i + shift) / count.
  struct Places {
    uint32_t count;
    double shift;
  };

  /// The length of the side and of the other side are given in quarters of a texel of the map; `neighbour` counts
  /// texels along the other side.
  static Places places_along(double length, double other, uint32_t neighbour) {
    const double all = std::max(1.0, std::ceil(length));
    const double shared = std::max(32.0, std::ceil(4.0 * length * other));
    if (shared >= all) return {static_cast<uint32_t>(all), 0.5};
    const double golden = 0.6180339887498949 * neighbour;
    return {static_cast<uint32_t>(shared), golden - std::floor(golden)};
  }

  /// Looks up the points of a block and adds them to the map.
  void flush(Block* block) {
    float* const n[3] = {block->direction[0], block->direction[1], block->direction[2]};
    float density[kBlock], u[kBlock], v[kBlock];
    projection::unproject(source_.image.projection, context_.simd, {block->count, block->u, block->v, block->face},
                          {{n[0], n[1], n[2]}, density});
    projection::project(SHD_PROJECTION_OCTAHEDRAL, context_.simd, {block->count, {n[0], n[1], n[2]}, {}},
                        {u, v, nullptr, {}, {}});
    look_up(block);
    const auto size = static_cast<float>(level_.size);
    for (size_t i = 0; i < block->count; ++i) {
      const float weight = block->weight[i] * density[i];
      float* sum = texel(std::min(static_cast<uint32_t>(u[i] * size), level_.size - 1),
                         std::min(static_cast<uint32_t>(v[i] * size), level_.size - 1));
      for (int c = 0; c < 3; ++c) sum[c] += weight * block->value[c][i];
      sum[3] += weight;
    }
    block->count = 0;
  }

  /// Divides sums by their weights. A texel without a lookup takes the radiance at its centre.
  void finish_row(uint32_t row) const {
    for (uint32_t x = 0; x < level_.size; ++x) {
      float* sum = texel(x, row);
      if (!(sum[3] > 0.0f)) {
        MapPoints centre;
        centre.add(level_.size, static_cast<float>(x) + 0.5f, static_cast<float>(row) + 0.5f);
        centre.find(context_.simd);
        Block block;
        block.count = 1;
        block.direction[0][0] = centre.x[0], block.direction[1][0] = centre.y[0], block.direction[2][0] = centre.z[0];
        look_up(&block);
        for (int c = 0; c < 3; ++c) sum[c] = block.value[c][0];
        sum[3] = 1.0f;
      }
      for (int c = 0; c < 3; ++c) sum[c] /= sum[3];
      sum[3] = 0.0f;
    }
  }

  const core::Context& context_;
  const Source& source_;
  const Level& level_;
  float* texels_;
  uint32_t parts_;
  NarrowTexels narrow_;
  float shift_;
  texture::Texture texture_ = {};
  const texture::Sampler sampler_ = texture::sampler_of(SHD_FILTER_BILINEAR);
};

}  // namespace

void build_radiance(const core::Context& context, const Source& source, const Chain& chain, float* texels) {
  const Level& base = chain.level[chain.count - 1];
  BaseMap(context, source, base, texels).fill();
  fill_border(base, texels);
  for (uint32_t l = chain.count - 1; l > 0; --l) halve(context, chain.level[l], chain.level[l - 1], texels);
}

}  // namespace shd::environment
