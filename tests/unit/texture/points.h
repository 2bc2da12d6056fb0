// SPDX-License-Identifier: MIT
// The points at which every filter is tested.
#pragma once

#include "fixture.h"

namespace fixture {

constexpr size_t kPoints = 160;
constexpr size_t kNonfinitePoints = 6;  // points with a non-finite coordinate

/// Coordinates: random ones, multiples of 2^-10 (exact in the kernel up to 1024 texels), and special values.
inline void make_points(Batch* batch) {
  const float special[] = {0.0f,      -0.0f,      1.0f,        -1.0f,    2.0f,          -2.0f, 0.5f,   0.99999994f,
                           -1e-45f,   -1e-30f,    1e-40f,      -1e-8f,   1.0000001f,    1e30f, -1e30f, 3.40282347e38f,
                           -1e10f,    8388607.5f, -8388607.5f, 16777216, 2147483648.0f, 1e-3f, NAN,    INFINITY,
                           -INFINITY, 3.0f,       0.25f,       -0.25f,   0.49999997f};
  constexpr size_t kSpecial = sizeof special / sizeof special[0];
  Random random{12345};
  batch->count = kPoints;
  for (size_t i = 0; i < kPoints; ++i) {
    const bool exact = i % 2 == 0;
    batch->u[i] = exact ? floorf(random.real(-2048, 3072)) / 1024 : random.real(-2, 3);
    batch->v[i] = exact ? floorf(random.real(-2048, 3072)) / 1024 : random.real(-2, 3);
    if (i >= kPoints - 2 * kSpecial) {
      const size_t k = (i - (kPoints - 2 * kSpecial)) / 2;
      (i % 2 ? batch->u : batch->v)[i] = special[k];
    }
    const float scale = ldexpf(1, static_cast<int>(random.next() >> 28) - 13);  // footprints from 2^-13 to 4 textures
    batch->dudx[i] = scale * random.real(-1, 1);
    batch->dvdx[i] = scale * random.real(-1, 1);
    batch->dudy[i] = scale * random.real(-1, 1);
    batch->dvdy[i] = scale * random.real(-1, 1);
    batch->lod[i] = random.real(-3, 14);
  }
  // A run of lanes that share a level, and a run without blending.
  for (size_t i = 0; i < 32; ++i) {
    batch->dudx[i] = batch->dvdy[i] = ldexpf(1, -4);
    batch->dvdx[i] = batch->dudy[i] = 0;
    batch->lod[i] = 1.25f;
  }
  for (size_t i = 32; i < 64; ++i) {
    batch->dudx[i] = batch->dvdx[i] = batch->dudy[i] = batch->dvdy[i] = 0;
    batch->lod[i] = 2;
  }
}

}  // namespace fixture
