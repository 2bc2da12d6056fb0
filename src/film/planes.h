// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <shd/framebuffer.h>

#include "raster/fragments.h"

namespace shd::film {

constexpr uint32_t kPlaneCount = SHD_PLANE_TARGET3_A + 1;
constexpr uint32_t kNoTriangle = 0xffffffffu;
constexpr uint32_t kNoDraw = 0xffffffffu;

/// Columns of a shaded batch from which planes are written.
struct AovColumns {
  const raster::Fragments& fragments;
  const float* lod;
  const uint32_t* level;
  const uint32_t* draw;
};

/// Properties of one plane.
struct PlaneInfo {
  uint32_t aov;     // shd_aov bit; 0 = every framebuffer has it
  bool is_integer;  // uint32_t, not float
  double empty;     // value where nothing was drawn; the frame's clear values replace it for colour and depth
  const void* (*column)(const AovColumns& batch);  // null: not written from a column
};

/// [shd_plane]
constexpr PlaneInfo kPlanes[kPlaneCount] = {
    {0, false, 0.0, nullptr},
    {0, false, 0.0, nullptr},
    {0, false, 0.0, nullptr},
    {0, false, 0.0, nullptr},
    {0, false, 1.0, nullptr},
    {SHD_AOV_UV, false, 0.0, [](const AovColumns& batch) -> const void* { return batch.fragments.u; }},
    {SHD_AOV_UV, false, 0.0, [](const AovColumns& batch) -> const void* { return batch.fragments.v; }},
    {SHD_AOV_NORMAL, false, 0.0, [](const AovColumns& batch) -> const void* { return batch.fragments.nx; }},
    {SHD_AOV_NORMAL, false, 0.0, [](const AovColumns& batch) -> const void* { return batch.fragments.ny; }},
    {SHD_AOV_NORMAL, false, 0.0, [](const AovColumns& batch) -> const void* { return batch.fragments.nz; }},
    {SHD_AOV_TRIANGLE, true, kNoTriangle,
     [](const AovColumns& batch) -> const void* { return batch.fragments.triangle; }},
    {SHD_AOV_POSITION, false, 0.0, [](const AovColumns& batch) -> const void* { return batch.fragments.px; }},
    {SHD_AOV_POSITION, false, 0.0, [](const AovColumns& batch) -> const void* { return batch.fragments.py; }},
    {SHD_AOV_POSITION, false, 0.0, [](const AovColumns& batch) -> const void* { return batch.fragments.pz; }},
    {SHD_AOV_DERIVATIVES, false, 0.0, [](const AovColumns& batch) -> const void* { return batch.fragments.dudx; }},
    {SHD_AOV_DERIVATIVES, false, 0.0, [](const AovColumns& batch) -> const void* { return batch.fragments.dvdx; }},
    {SHD_AOV_DERIVATIVES, false, 0.0, [](const AovColumns& batch) -> const void* { return batch.fragments.dudy; }},
    {SHD_AOV_DERIVATIVES, false, 0.0, [](const AovColumns& batch) -> const void* { return batch.fragments.dvdy; }},
    {SHD_AOV_BARYCENTRICS, false, 0.0, [](const AovColumns& batch) -> const void* { return batch.fragments.bary[0]; }},
    {SHD_AOV_BARYCENTRICS, false, 0.0, [](const AovColumns& batch) -> const void* { return batch.fragments.bary[1]; }},
    {SHD_AOV_BARYCENTRICS, false, 0.0, [](const AovColumns& batch) -> const void* { return batch.fragments.bary[2]; }},
    {SHD_AOV_LEVEL, false, 0.0, [](const AovColumns& batch) -> const void* { return batch.lod; }},
    {SHD_AOV_LEVEL, true, 0, [](const AovColumns& batch) -> const void* { return batch.level; }},
    {SHD_AOV_DRAW, true, kNoDraw, [](const AovColumns& batch) -> const void* { return batch.draw; }},
    {SHD_AOV_OVERDRAW, true, 0, nullptr},
    {SHD_AOV_TARGET1, false, 0.0, nullptr},
    {SHD_AOV_TARGET1, false, 0.0, nullptr},
    {SHD_AOV_TARGET1, false, 0.0, nullptr},
    {SHD_AOV_TARGET1, false, 0.0, nullptr},
    {SHD_AOV_TARGET2, false, 0.0, nullptr},
    {SHD_AOV_TARGET2, false, 0.0, nullptr},
    {SHD_AOV_TARGET2, false, 0.0, nullptr},
    {SHD_AOV_TARGET2, false, 0.0, nullptr},
    {SHD_AOV_TARGET3, false, 0.0, nullptr},
    {SHD_AOV_TARGET3, false, 0.0, nullptr},
    {SHD_AOV_TARGET3, false, 0.0, nullptr},
    {SHD_AOV_TARGET3, false, 0.0, nullptr},
};

/// Whether a framebuffer with these shd_aov bits has the plane.
constexpr bool wants_plane(uint32_t aovs, uint32_t plane) {
  return plane < kPlaneCount && (!kPlanes[plane].aov || (aovs & kPlanes[plane].aov));
}

/// First plane of a target; target 0 is colour.
constexpr uint32_t target_plane(uint32_t target) {
  return target == 0 ? 0 : static_cast<uint32_t>(SHD_PLANE_TARGET1_R) + 4 * (target - 1);
}

/// Every shd_aov bit.
constexpr uint32_t all_aovs() {
  uint32_t aovs = 0;
  for (const PlaneInfo& plane : kPlanes) aovs |= plane.aov;
  return aovs;
}

}  // namespace shd::film
