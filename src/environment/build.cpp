// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "core/executor.h"
#include "data/trig.h"
#include "environment/cells.h"
#include "environment/convolve.h"
#include "environment/environment.h"
#include "environment/lobe_table.h"
#include "environment/radiance.h"
#include "environment/source.h"
#include "projection/projection.h"

namespace shd::environment {
namespace {

constexpr uint32_t kMinBase = 64, kMaxBase = 2048, kMaxLobeMap = 256, kMinLobeMap = 64, kIrradianceMap = 96;

/// log2 of a power of two.
uint32_t log2_of(uint32_t size) {
  return 31 - static_cast<uint32_t>(__builtin_clz(size));
}

/// Size of a map with at least as many texels as the image: a power of two.
uint32_t base_size(const Source& source) {
  uint32_t size = kMinBase;
  while (size < kMaxBase && uint64_t{size} * size < source.texels()) size *= 2;
  return size;
}

/// The irradiance of order-2 harmonics (Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance
/// Environment Maps", 2001): each integral times its normalisation squared and pi, 2 pi / 3 or pi / 4.
void build_harmonics(const Source& source, Environment* out) {
  constexpr double kFactor[kHarmonics] = {1.0 / 4,   1.0 / 2,   1.0 / 2,  1.0 / 2,  15.0 / 16,
                                          15.0 / 16, 15.0 / 16, 5.0 / 64, 15.0 / 64};
  for (int c = 0; c < 3; ++c) {
    for (int k = 0; k < kHarmonics; ++k) out->harmonics[c][k] = static_cast<float>(kFactor[k] * source.moments[c][k]);
    out->mean[c] = static_cast<float>(source.moments[c][0] / (4.0 * data::kPi));
  }
}

/// The light of the texels in a quadtree.
CellTree build_cells(const core::Context& context, const Source& source) {
  double light = 0.0;
  for (const auto& channel : source.moments) light += channel[0];
  const auto floor = static_cast<float>(light > 0.0 ? 1e-3 * light : 1.0);
  CellTree tree = make_cells(context.allocator, cell_size(source), floor);
  RowDirections row(context.allocator, source);
  core::Array<float> points(context.allocator, 2 * row.width);
  float *const u = points.data(), *const v = u + row.width;
  const auto scale = static_cast<float>(source.scale);
  for (uint32_t y = 0; y < source.image.height * source.faces(); ++y) {
    for (uint32_t part = 0; part < source.down; ++part) {
      find_directions(context.simd, source, y * source.down + part, &row);
      projection::project(SHD_PROJECTION_OCTAHEDRAL, context.simd, {row.width, {row.x, row.y, row.z}, {}},
                          {u, v, nullptr, {}, {}});
      const float* texel = source.row(y);
      for (size_t x = 0; x < row.width; ++x) {
        const float direction[3] = {row.x[x], row.y[x], row.z[x]};
        if (row.solid_angle[x] > 0.0f) add_light(&tree, u[x], v[x], direction, texel, row.solid_angle[x] * scale);
        if ((x + 1) % source.across == 0) texel += 4;
      }
    }
  }
  finish_cells(context.simd, &tree);
  return tree;
}

/// Assigns texels to maps.
struct Layout {
  size_t count = 0;  // texels

  Level add(uint32_t size) {
    const Level level = {size, static_cast<uint32_t>(count)};
    count += texel_count(size);
    return level;
  }

  /// Levels of the radiance, from 4 x 4 to the base.
  Chain radiance(uint32_t base) {
    Chain chain = {};
    for (uint32_t size = 4; size <= base; size *= 2) chain.level[chain.count++] = add(size);
    chain.offset = 2.0f;  // a level of 2^j texels a side blurs like a GGX lobe of precision 4^j
    return chain;
  }

  /// `first` = 0 for GGX. Phong lobes of precision 2^k are as wide as GGX lobes of precision 2^(k + 1): first = 1.
  Chain lobes(uint32_t first, uint32_t cells, const Chain& radiance) {
    Chain chain = {};
    const uint32_t last = std::min(12u, 2 * log2_of(cells) - 4);  // an even number, of GGX
    for (uint32_t k = first; k <= last; ++k) {
      const uint32_t size = std::max(kMinLobeMap, 32u << k / 2);
      chain.level[chain.count++] = add(std::min({kMaxLobeMap, cells, size}));
    }
    chain.lobes = chain.count;
    chain.knee = static_cast<float>(chain.count - 1);
    for (uint32_t l = 0; l < radiance.count; ++l) {
      if (2 * log2_of(radiance.level[l].size) > last) chain.level[chain.count++] = radiance.level[l];
    }
    return chain;
  }
};

/// Fills the texels of all maps.
void build_maps(const core::Context& context, const Source& source, const Environment* out, float* texels) {
  if (out->radiance.count) build_radiance(context, source, out->radiance, texels);
  const bool is_convolved = out->irradiance.size != 0;
  if (!out->ggx.count && !out->phong.count && !is_convolved) return;
  const CellTree cells = build_cells(context, source);
  Convolver lobes(context, cells);
  for (uint32_t k = 0; k < out->ggx.lobes; ++k) {
    lobes.fill(LobeKind::kGgx, k, out->ggx.level[k], texels);
  }
  for (uint32_t k = 0; k < out->phong.lobes; ++k) {
    lobes.fill(LobeKind::kPhong, k, out->phong.level[k], texels);
  }
  // The irradiance is pi times the mean over the Phong lobe with p = 1, which is the cosine.
  if (!is_convolved) return;
  lobes.fill(LobeKind::kPhong, 1, out->irradiance, texels);
  float* texel = texels + 4 * size_t{out->irradiance.first};
  for (size_t i = 0; i < 4 * texel_count(out->irradiance.size); ++i) texel[i] *= static_cast<float>(data::kPi);
}

}  // namespace

void build(const core::Context& context, const shd_environment_desc& desc, Environment* out) {
  Source source = {};
  read_source(context, desc.projection, *desc.image, &source);
  build_harmonics(source, out);
  out->projection = desc.projection;
  out->replaced = source.replaced;
  const bool has_ggx = (desc.tables & SHD_ENVIRONMENT_TABLE_GGX) != 0,
             has_phong = (desc.tables & SHD_ENVIRONMENT_TABLE_PHONG) != 0;
  const bool is_convolved = desc.irradiance == SHD_IRRADIANCE_CONVOLVED;
  const uint32_t base = base_size(source);
  if (desc.tables) lobe_table();
  Layout layout;
  if (desc.tables) out->radiance = layout.radiance(base);
  if (has_ggx) out->ggx = layout.lobes(0, cell_size(source), out->radiance);
  if (has_phong) out->phong = layout.lobes(1, cell_size(source), out->radiance);
  if (is_convolved) out->irradiance = layout.add(kIrradianceMap);
  core::Array<float> texels(context.allocator, 4 * layout.count);
  out->texels = core::Array<PackedTexel>(context.allocator, layout.count);
  build_maps(context, source, out, texels.data());
  constexpr size_t kPiece = 4096;
  core::parallel_for(context, static_cast<uint32_t>((layout.count + kPiece - 1) / kPiece),
                     [&](uint32_t piece, uint32_t) {
                       const size_t end = std::min(layout.count, (piece + size_t{1}) * kPiece);
                       for (size_t i = piece * kPiece; i < end; ++i) out->texels[i] = pack(&texels[4 * i]);
                     });
}

}  // namespace shd::environment
