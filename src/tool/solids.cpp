// SPDX-License-Identifier: MIT
#include "tool/solids.h"

#include <algorithm>

namespace {

struct Look {
  uint32_t octaves;
  float distortion;
  float low, high;  // range of the colours; equal = that of the kind
  shd_solid_sum sum;
  shd_solid_distance distance;
  uint32_t color_count;
  float color[3][3];
};
constexpr shd_solid_sum kFbm = SHD_SOLID_SUM_FBM, kTurbulence = SHD_SOLID_SUM_TURBULENCE;
constexpr shd_solid_distance kF1 = SHD_SOLID_DISTANCE_F1, kBorders = SHD_SOLID_DISTANCE_F2_F1;

/// By shd_solid.
constexpr Look kLooks[] = {
    {1, 1.0f, 0.0f, 0.0f, kFbm, kF1, 2, {{0.8f, 0.1f, 0.08f}, {0.9f, 0.85f, 0.8f}}},
    {1, 1.0f, 0.0f, 0.0f, kFbm, kF1, 2, {{0.02f, 0.02f, 0.03f}, {0.8f, 0.8f, 0.75f}}},
    {6, 1.0f, -0.6f, 0.6f, kFbm, kF1, 2, {{0.1f, 0.25f, 0.7f}, {0.9f, 0.9f, 0.95f}}},
    {6, 1.0f, -0.6f, 0.6f, kFbm, kF1, 2, {{0.02f, 0.1f, 0.02f}, {0.3f, 0.55f, 0.1f}}},
    {6, 1.0f, 0.0f, 0.7f, kTurbulence, kF1, 3, {{0.02f, 0.005f, 0.0f}, {0.9f, 0.2f, 0.01f}, {1.0f, 0.9f, 0.3f}}},
    {1, 1.0f, 0.0f, 0.25f, kFbm, kBorders, 2, {{0.6f, 0.9f, 0.85f}, {0.02f, 0.2f, 0.3f}}},
    {6, 3.0f, 0.0f, 0.0f, kFbm, kF1, 3, {{0.03f, 0.05f, 0.06f}, {0.45f, 0.5f, 0.5f}, {0.9f, 0.9f, 0.85f}}},
    {6, 0.8f, 0.0f, 0.0f, kFbm, kF1, 2, {{0.55f, 0.28f, 0.1f}, {0.2f, 0.07f, 0.02f}}},
};
static_assert(sizeof kLooks / sizeof kLooks[0] == SHD_SOLID_WOOD + 1);

}  // namespace

shd_solid_desc make_solid(const SolidOptions& options) {
  const Look& look = kLooks[*options.kind];
  shd_solid_desc desc = shd_solid_desc_default();
  desc.kind = *options.kind;
  desc.size = options.size;
  desc.octaves = options.octaves.value_or(look.octaves);
  desc.distortion = look.distortion;
  desc.range[0] = look.low;
  desc.range[1] = look.high;
  desc.sum = look.sum;
  if (options.turbulence) {
    desc.sum = kTurbulence;
    desc.range[0] = std::max(look.low, 0.0f);  // absolute values
  }
  if (options.table) desc.gradients = SHD_SOLID_GRADIENTS_TABLE;
  desc.fade = options.fade.value_or(desc.fade);
  desc.distance = look.distance;
  desc.color_count = look.color_count;
  for (uint32_t k = 0; k < look.color_count; ++k) {
    std::copy_n(look.color[k], 3, desc.colors[k]);
    desc.colors[k][3] = 1.0f;
  }
  return desc;
}
