// SPDX-License-Identifier: MIT
#include "environment/convolve.h"

#include <algorithm>
#include <cmath>

#include "core/executor.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "environment/convolve.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "simd/vec3-inl.h"

#ifndef SHD_ENVIRONMENT_CONVOLVE_CPP_
#define SHD_ENVIRONMENT_CONVOLVE_CPP_
namespace shd::environment {
namespace {

constexpr uint32_t kTile = 8;  // texels a side of a tile, which shares one list of cells
constexpr uint32_t kTexels = kTile * kTile;

using CellList = core::Buffer<CellLight>;  // cells whose light reaches a tile

/// The texels of a tile, and their sums.
struct Tile {
  MapPoints texels;
  alignas(64) float sum[3][kTexels];
};
static_assert(kTexels <= MapPoints::kMost);

}  // namespace
}  // namespace shd::environment
#endif  // SHD_ENVIRONMENT_CONVOLVE_CPP_

HWY_BEFORE_NAMESPACE();
namespace shd::environment::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

namespace {

/// Lobe at the squared distance s of two unit vectors: r.l = 1 - s / 2.
struct Ggx {
  float alpha_squared;
  template <class D, class V>
  HWY_INLINE V operator()(D d, V s) const {
    const V one = hn::Set(d, 1.0f), a = hn::Set(d, alpha_squared);
    const V cosine = hn::Max(one - hn::Set(d, 0.5f) * s, hn::Zero(d));
    const V spread = a + (one - a) * (hn::Set(d, 0.25f) * s);  // (n.h)^2 (alpha^2 - 1) + 1
    return cosine / (spread * spread);
  }
};

struct Phong {
  uint32_t exponent;
  template <class D, class V>
  HWY_INLINE V operator()(D d, V s) const {
    const V one = hn::Set(d, 1.0f);
    V power = hn::Max(one - hn::Set(d, 0.5f) * s, hn::Zero(d));
    V result = hn::IfThenElseZero(hn::Gt(power, hn::Zero(d)), one);
    for (uint32_t k = 0; k < exponent; ++k) {
      result = result * power;
      power = power * power;
    }
    return result;
  }
};

template <class Lobe>
HWY_NOINLINE void Accumulate(const Lobe& lobe, const CellLight* cells, size_t count, Tile* tile) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  for (size_t i = 0; i < kTexels; i += hn::Lanes(d)) {
    const auto n = simd::HWY_NAMESPACE::Load3(d, tile->texels.x, tile->texels.y, tile->texels.z, i);
    V sum[3] = {hn::Zero(d), hn::Zero(d), hn::Zero(d)}, total = hn::Zero(d);
    for (size_t k = 0; k < count; ++k) {
      const CellLight& cell = cells[k];
      const V dx = n.x - hn::Set(d, cell.x), dy = n.y - hn::Set(d, cell.y), dz = n.z - hn::Set(d, cell.z);
      const V weight = lobe(d, dx * dx + dy * dy + dz * dz);
      for (int c = 0; c < 3; ++c) sum[c] = sum[c] + weight * hn::Set(d, cell.flux[c]);
      total = total + weight * hn::Set(d, cell.solid_angle);
    }
    const V inverse = hn::Set(d, 1.0f) / hn::Max(total, hn::Set(d, 1e-30f));
    for (int c = 0; c < 3; ++c) hn::Store(sum[c] * inverse, d, tile->sum[c] + i);
  }
}

}  // namespace

void AccumulateLobe(LobeKind kind, uint32_t exponent, const CellLight* cells, size_t count, Tile* tile) {
  if (kind == LobeKind::kPhong) return Accumulate(Phong{exponent}, cells, count, tile);
  Accumulate(Ggx{1.0f / static_cast<float>(1u << exponent)}, cells, count, tile);
}

}  // namespace shd::environment::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace shd::environment {
namespace {

HWY_EXPORT(AccumulateLobe);

/// Finds the cells of a lobe for the texels of one tile.
class CellFinder {
 public:
  CellFinder(LobeKind kind, uint32_t exponent, const CellTree& cells, const MapPoints& texels, CellList* out)
      : cells_(cells), out_(out) {
    const float precision = static_cast<float>(1u << exponent);
    // The squared width of both lobes at half of their height, about.
    width2_ = std::min(kind == LobeKind::kGgx ? 4.0f / precision : 2.0f / precision, 0.25f);
    // Phong lobes are below e^-20 beyond this squared distance, and all lobes are 0 beyond a right angle.
    limit2_ = kind == LobeKind::kPhong && exponent > 0 ? std::min(2.0f, 40.0f / precision) : 2.0f;
    float sum[3] = {};
    for (size_t i = 0; i < texels.count; ++i) sum[0] += texels.x[i], sum[1] += texels.y[i], sum[2] += texels.z[i];
    const float length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    for (int c = 0; c < 3; ++c) axis_[c] = length > 0.0f ? sum[c] / length : 0.0f;
    for (size_t i = 0; i < texels.count; ++i) {
      radius_ = std::max(radius_, distance(texels.x[i], texels.y[i], texels.z[i]));
    }
  }

  void find() {
    const uint32_t side = cells_.side(0);
    for (uint32_t j = 0; j < side; ++j) {
      for (uint32_t i = 0; i < side; ++i) visit(0, i, j);
    }
  }

 private:
  float distance(float x, float y, float z) const {
    const float dx = x - axis_[0], dy = y - axis_[1], dz = z - axis_[2];
    return std::sqrt(dx * dx + dy * dy + dz * dz);
  }

  void visit(uint32_t level, uint32_t i, uint32_t j) {
    const Cell& cell = cells_.cells[cells_.first[level] + size_t{j} * cells_.side(level) + i];
    if (cell.solid_angle == 0.0f) return;
    const float away = std::max(0.0f, distance(cell.x, cell.y, cell.z) - radius_ - cell.radius);
    if (away * away >= limit2_) return;
    const bool is_small = cell.radius * cell.radius <= kAccept * (width2_ + away * away);
    if (is_small || level + 1 == cells_.levels) {
      return out_->push_back({cell.x, cell.y, cell.z, {cell.flux[0], cell.flux[1], cell.flux[2]}, cell.solid_angle});
    }
    for (uint32_t k = 0; k < 4; ++k) visit(level + 1, 2 * i + k % 2, 2 * j + k / 2);
  }

  static constexpr float kAccept = 0.1f;  // largest ratio of squares

  const CellTree& cells_;
  CellList* out_;
  float axis_[3];
  float radius_ = 0.0f, width2_, limit2_;
};

}  // namespace

Convolver::Convolver(const core::Context& context, const CellTree& cells)
    : context_(context), cells_(cells), lists_(context.allocator, context.executor.worker_count) {
  for (size_t i = 0; i < lists_.size(); ++i) lists_[i].attach(context.allocator);
}

void Convolver::fill(LobeKind kind, uint32_t exponent, const Level& to, float* texels) {
  const uint32_t tiles = (to.size + kTile - 1) / kTile;
  core::parallel_for(context_, tiles * tiles, [&](uint32_t index, uint32_t worker) {
    const uint32_t left = index % tiles * kTile, top = index / tiles * kTile;
    Tile tile;
    for (uint32_t i = 0; i < kTexels; ++i) {
      tile.texels.add(to.size, static_cast<float>(left + i % kTile) + 0.5f, static_cast<float>(top + i / kTile) + 0.5f);
    }
    tile.texels.find(context_.simd);
    CellList& list = lists_[worker];
    list.clear();
    CellFinder(kind, exponent, cells_, tile.texels, &list).find();
    SHD_DISPATCH(AccumulateLobe, context_.simd)(kind, exponent, list.data(), list.size(), &tile);
    for (uint32_t i = 0; i < kTexels; ++i) {
      float* texel =
          texels + 4 * texel_index(to, static_cast<int32_t>(left + i % kTile), static_cast<int32_t>(top + i / kTile));
      for (int c = 0; c < 3; ++c) texel[c] = tile.sum[c][i];
      texel[3] = 0.0f;
    }
  });
  fill_border(to, texels);
}

}  // namespace shd::environment
#endif  // HWY_ONCE
