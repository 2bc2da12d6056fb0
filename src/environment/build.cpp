// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "core/executor.h"
#include "data/trig.h"
#include "environment/cells.h"
#include "environment/convolve.h"
#include "environment/environment.h"
#include "environment/lobe_table.h"
#include "environment/source.h"
#include "projection/projection.h"

namespace shd::environment {
namespace {

constexpr uint32_t kMinBase = 64, kMaxBase = 2048, kMaxLobeMap = 256, kMinLobeMap = 64, kIrradianceMap = 64;

/// log2 of a power of two.
uint32_t log2_of(uint32_t size) {
  return 31 - static_cast<uint32_t>(__builtin_clz(size));
}

/// Size of a map with at least as many texels as the image: a power of two.
uint32_t base_size(const Source& source) {
  const uint64_t texels = uint64_t{source.width} * source.height;
  uint32_t size = kMinBase;
  while (size < kMaxBase && uint64_t{size} * size < texels) size *= 2;
  return size;
}

/// Size of a map whose texels are at least as large as those of the image, so that lobes are wider than the distances
/// of its lights.
uint32_t cell_size(const Source& source) {
  const uint64_t texels = uint64_t{source.width} * source.height;
  uint32_t size = kMinBase;
  while (size < kRootCells << (kMaxCellLevels - 1) && 2 * uint64_t{size} * size < texels) size *= 2;
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

/// Mean of the bilinear lookups of points of the source, weighted by the texels that show directions.
struct Mean {
  float sum[4];

  void add(const Source& source, uint32_t face, float u, float v) {
    const uint32_t height = source.height / projection::face_count(source.projection);
    const float x = u * static_cast<float>(source.width) - 0.5f, y = v * static_cast<float>(height) - 0.5f;
    const float left = std::floor(x), top = std::floor(y);
    const auto i = static_cast<int32_t>(left), j = static_cast<int32_t>(top);
    for (int32_t k = 0; k < 4; ++k) {
      const float wx = k % 2 ? x - left : 1.0f - (x - left), wy = k / 2 ? y - top : 1.0f - (y - top);
      const int32_t row = std::clamp(j + k / 2, 0, static_cast<int32_t>(height) - 1);
      const float* texel =
          source.texels.data() +
          4 * ((size_t{face} * height + static_cast<size_t>(row)) * source.width + column(source, i + k % 2));
      const float weight = wx * wy * texel[3];
      for (int c = 0; c < 3; ++c) sum[c] += weight * texel[c];
      sum[3] += weight;
    }
  }

 private:
  /// LAT_LONG repeats, the other projections end at their edge.
  static size_t column(const Source& source, int32_t i) {
    const auto width = static_cast<int32_t>(source.width);
    if (source.projection == SHD_PROJECTION_LAT_LONG) return static_cast<size_t>(i < 0 ? i + width : i % width);
    return static_cast<size_t>(std::clamp(i, 0, width - 1));
  }
};

/// Fills one row of the base map with means of `parts` x `parts` lookups a texel.
void resample_row(const core::SimdTarget& simd, const Source& source, uint32_t parts, const Level& base, uint32_t row,
                  float* texels) {
  constexpr uint32_t kPart = 256;
  float direction[3][kPart], u[kPart], v[kPart];
  uint32_t face[kPart];
  const uint32_t lookups = parts * parts, group = kPart / lookups;
  const float step = 1.0f / static_cast<float>(parts);
  for (uint32_t x = 0; x < base.size; x += group) {
    const uint32_t count = std::min(group, base.size - x);
    for (uint32_t i = 0; i < count * lookups; ++i) {
      const uint32_t part = i % lookups;
      const MapDirection n = map_direction(
          base.size, static_cast<float>(x + i / lookups) + (static_cast<float>(part % parts) + 0.5f) * step,
          static_cast<float>(row) + (static_cast<float>(part / parts) + 0.5f) * step);
      direction[0][i] = n.x, direction[1][i] = n.y, direction[2][i] = n.z;
    }
    projection::project(source.projection, simd, {count * lookups, {direction[0], direction[1], direction[2]}, {}},
                        {u, v, face, {}, {}});
    for (uint32_t i = 0; i < count; ++i) {
      Mean mean = {};
      for (uint32_t k = i * lookups; k < (i + 1) * lookups; ++k) mean.add(source, face[k], u[k], v[k]);
      float* texel = texels + 4 * texel_index(base, static_cast<int32_t>(x + i), static_cast<int32_t>(row));
      for (int c = 0; c < 3; ++c) texel[c] = mean.sum[3] > 0.0f ? mean.sum[c] / mean.sum[3] : 0.0f;
      texel[3] = 0.0f;
    }
  }
}

/// Scales the base map, so that its integral is the integral of the source.
void keep_energy(const Source& source, const Level& base, float* texels) {
  double sum[3] = {};
  const double area = 4.0 / (static_cast<double>(base.size) * base.size);
  for (uint32_t y = 0; y < base.size; ++y) {
    float row[3] = {};
    for (uint32_t x = 0; x < base.size; ++x) {
      const float norm = map_direction(base.size, static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f).norm;
      const float* texel = texels + 4 * texel_index(base, static_cast<int32_t>(x), static_cast<int32_t>(y));
      for (int c = 0; c < 3; ++c) row[c] += norm * norm * norm * texel[c];
    }
    for (int c = 0; c < 3; ++c) sum[c] += area * static_cast<double>(row[c]);
  }
  float factor[3];
  for (int c = 0; c < 3; ++c) {
    const double ratio = sum[c] > 0.0 ? source.moments[c][0] / sum[c] : 1.0;
    factor[c] = static_cast<float>(std::clamp(ratio, 0.5, 2.0));
  }
  for (uint32_t y = 0; y < base.size; ++y) {
    float* texel = texels + 4 * texel_index(base, 0, static_cast<int32_t>(y));
    for (uint32_t x = 0; x < base.size; ++x, texel += 4) {
      for (int c = 0; c < 3; ++c) texel[c] *= factor[c];
    }
  }
}

/// Fills the levels of the radiance.
void build_radiance(const core::Context& context, const Source& source, const Chain& chain, float* texels) {
  const Level& base = chain.level[chain.count - 1];
  const double density = std::sqrt(static_cast<double>(source.width) * source.height) / base.size;
  const auto parts = static_cast<uint32_t>(std::clamp(std::ceil(2.0 * density), 2.0, 8.0));
  core::parallel_for(context, base.size,
                     [&](uint32_t row, uint32_t) { resample_row(context.simd, source, parts, base, row, texels); });
  keep_energy(source, base, texels);
  fill_border(base, texels);
  for (uint32_t l = chain.count - 1; l > 0; --l) halve(context, chain.level[l], chain.level[l - 1], texels);
}

/// The light of the texels in a quadtree.
CellTree build_cells(const core::Context& context, const Source& source) {
  double light = 0.0;
  for (const auto& channel : source.moments) light += channel[0];
  const auto floor = static_cast<float>(light > 0.0 ? 1e-3 * light : 1.0);
  CellTree tree = make_cells(context.allocator, cell_size(source), floor);
  RowDirections row(context.allocator, source.width);
  const auto scale = static_cast<float>(source.scale);
  for (uint32_t y = 0; y < source.height; ++y) {
    find_directions(context.simd, source, y, &row);
    const float* texel = source.texels.data() + 4 * size_t{y} * source.width;
    for (uint32_t x = 0; x < source.width; ++x, texel += 4) {
      const float direction[3] = {row.x[x], row.y[x], row.z[x]};
      if (row.solid_angle[x] > 0.0f) add_light(&tree, direction, texel, row.solid_angle[x] * scale);
    }
  }
  finish_cells(&tree);
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
  constexpr size_t kPart = 4096;
  core::parallel_for(context, static_cast<uint32_t>((layout.count + kPart - 1) / kPart), [&](uint32_t part, uint32_t) {
    const size_t end = std::min(layout.count, (part + size_t{1}) * kPart);
    for (size_t i = part * kPart; i < end; ++i) out->texels[i] = pack(&texels[4 * i]);
  });
}

}  // namespace shd::environment
