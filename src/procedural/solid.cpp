// SPDX-License-Identifier: MIT
#include "procedural/solid.h"

#include <algorithm>
#include <cmath>

#include "data/hash.h"

namespace shd::procedural {
namespace {

using Evaluate = size_t(const Solid&, const core::SimdTarget&, const Places&, const Values&);

/// Kernels by shd_solid. PERLIN with a table has its own.
constexpr Evaluate* kKernels[] = {evaluate_stripes, evaluate_checker, evaluate_perlin, evaluate_value,
                                  evaluate_simplex, evaluate_worley,  evaluate_marble, evaluate_wood};
static_assert(sizeof kKernels / sizeof kKernels[0] == SHD_SOLID_WOOD + 1);

/// Properties of the noise of one octave.
struct NoiseInfo {
  float normalizer;
  float mean_absolute;  // mean of |n| over space and seeds, for turbulence
};
/// By shd_solid_fade. The normalizers are just below the inverse of the largest sum over the lattice points:
/// unit.procedural.solid_range. The means are measured over 2^24 places.
constexpr NoiseInfo kHashedPerlin[] = {{0.9649f, 0.2125f}, {0.957f, 0.2f}, {0.9391f, 0.1838f}};
constexpr NoiseInfo kTablePerlin[] = {{1.0f, 0.1561f}, {1.0f, 0.1478f}, {1.0f, 0.1385f}};
constexpr NoiseInfo kValue[] = {{1.0f, 0.3301f}, {1.0f, 0.3028f}, {1.0f, 0.2553f}};
constexpr NoiseInfo kSimplex = {76.88f, 0.314f};
/// 1 / sqrt(3), and the means of the normalised distances.
constexpr float kWorleyNormalizer = 0.57735026f;
constexpr float kWorleyMean[3] = {0.3005f, 0.4139f, 0.1135f};

NoiseInfo noise_info(const shd_solid_desc& desc) {
  switch (desc.kind) {
    case SHD_SOLID_PERLIN:
      return desc.gradients == SHD_SOLID_GRADIENTS_TABLE ? kTablePerlin[desc.fade] : kHashedPerlin[desc.fade];
    case SHD_SOLID_VALUE: return kValue[desc.fade];
    case SHD_SOLID_SIMPLEX: return kSimplex;
    default: return kHashedPerlin[desc.fade];
  }
}

void build_octaves(const shd_solid_desc& desc, Solid* out) {
  double frequency = 1.0, amplitude = 1.0, sum = 0.0;
  for (uint32_t i = 0; i < desc.octaves; ++i, amplitude *= double{desc.gain}) sum += amplitude;
  amplitude = 1.0;
  for (uint32_t i = 0; i < desc.octaves; ++i) {
    // The step of a Weyl sequence; hashes mix the seed further.
    out->octave[i] = {static_cast<float>(frequency), static_cast<float>(amplitude / sum),
                      desc.seed + i * data::kHashStep};
    frequency *= double{desc.lacunarity};
    amplitude *= double{desc.gain};
  }
  out->octave_count = desc.octaves;
}

void build_colors(const shd_solid_desc& desc, Solid* out) {
  const bool is_signed = desc.kind >= SHD_SOLID_PERLIN && desc.kind <= SHD_SOLID_SIMPLEX && !out->is_turbulence;
  const bool is_default = desc.range[0] == desc.range[1];
  const double low = is_default ? (is_signed ? -1.0 : 0.0) : double{desc.range[0]};
  const double high = is_default ? 1.0 : double{desc.range[1]};
  out->low = static_cast<float>(low);
  constexpr double kSteepest = 1e38;  // a product with 0 is 0
  const double scale = (desc.color_count - 1.0) / (high - low);
  out->color_scale = static_cast<float>(std::min(std::max(scale, -kSteepest), kSteepest));
  out->color_count = desc.color_count;
  for (uint32_t k = 0; k < desc.color_count; ++k) {
    for (int c = 0; c < 4; ++c) out->color[c][k] = desc.colors[k][c];
  }
}

}  // namespace

void build(const shd_solid_desc& desc, Solid* out) noexcept {
  out->kind = desc.kind;
  out->size = desc.size;
  out->inverse_size = 1.0f / desc.size;
  out->fade = desc.fade;
  out->distance = desc.distance;
  out->distortion = desc.distortion;
  const NoiseInfo info = noise_info(desc);
  const bool can_fold = desc.kind >= SHD_SOLID_PERLIN && desc.kind <= SHD_SOLID_SIMPLEX;
  out->is_turbulence = can_fold && desc.sum == SHD_SOLID_SUM_TURBULENCE;
  out->normalizer = desc.kind == SHD_SOLID_WORLEY ? kWorleyNormalizer : info.normalizer;
  out->mean = desc.kind == SHD_SOLID_WORLEY                         ? kWorleyMean[desc.distance]
              : out->is_turbulence || desc.kind == SHD_SOLID_MARBLE ? info.mean_absolute
                                                                    : 0.0f;
  build_octaves(desc, out);
  build_colors(desc, out);
  out->has_table = desc.kind == SHD_SOLID_PERLIN && desc.gradients == SHD_SOLID_GRADIENTS_TABLE;
  if (out->has_table) fill(desc.seed, &out->table);
}

size_t evaluate(const Solid& solid, const core::SimdTarget& simd, const Places& places, const Values& out) {
  if (solid.has_table) return evaluate_perlin_table(solid, simd, places, out);
  return kKernels[solid.kind](solid, simd, places, out);
}

void evaluate_colors(const Solid& solid, const core::SimdTarget& simd, const Places& places, float* const out[4]) {
  constexpr size_t kRows = 256;
  alignas(64) float values[kRows];
  for (size_t begin = 0; begin < places.count; begin += kRows) {
    const auto at = [&](const float* column) { return column ? column + begin : nullptr; };
    const size_t count = std::min(kRows, places.count - begin);
    evaluate(solid, simd, {count, at(places.x), at(places.y), at(places.z), at(places.width)}, {values, {}});
    float* to[4];
    for (int c = 0; c < 4; ++c) to[c] = out[c] ? out[c] + begin : nullptr;
    find_colors(solid, simd, values, count, to);
  }
}

}  // namespace shd::procedural
