// SPDX-License-Identifier: MIT
// Common state of the tests of interpolation: vertices, a batch, and a copy of its columns.
#pragma once

#include "support/check.h"

#include <algorithm>

#include "core/allocator.h"
#include "data/data.h"
#include "raster/interpolate.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {
namespace {

using raster::kBatch;

const core::Allocator g_allocator = {core::default_allocator()};
constexpr size_t kVertices = 3 * kBatch;
constexpr uint32_t kTile = raster::kTile;

/// State of every test.
struct Fixture {
  geometry::Vertices vertices;
  uint32_t indices[kVertices];  // vertices of the triangles
  raster::Fragments fragments, first;
};
Fixture* g;

int set_up(void**) {
  g = new Fixture;
  g->vertices.raster = core::Array<float>(g_allocator, 4 * kVertices);
  g->vertices.world = core::Array<float>(g_allocator, 4 * kVertices);
  g->vertices.normal = core::Array<float>(g_allocator, 4 * kVertices);
  g->vertices.indices = g->indices;
  for (uint32_t i = 0; i < kVertices; ++i) g->indices[i] = i;
  raster::allocate(g_allocator, &g->fragments);
  raster::allocate(g_allocator, &g->first);
  return 0;
}

int tear_down(void**) {
  delete g;
  return 0;
}

constexpr float kEye[3] = {0.5f, 2.0f, 7.0f};

float* row(core::Array<float>& rows, size_t vertex) {
  return &rows[4 * vertex];
}

/// Row k of the vertices of triangle t.
inline uint32_t vertex_of(uint32_t t, size_t k) {
  return g->indices[3 * t + k];
}

/// Chooses the tile of the batch, in a picture of 2048^2 pixels.
inline void choose_tile(Random* random) {
  g->fragments.left = random->whole(0, 31) * raster::kTile;
  g->fragments.top = random->whole(0, 31) * raster::kTile;
}

/// The centre of a pixel of the tile.
struct Centre {
  float x, y;
};
inline Centre centre_of(uint32_t pixel) {
  return {static_cast<float>(g->fragments.left) + 0.5f + static_cast<float>(pixel % kTile),
          static_cast<float>(g->fragments.top) + 0.5f + static_cast<float>(pixel / kTile % kTile)};
}

/// Fragment `i` of triangle `t`, at the centre of a pixel of the tile.
void set_fragment(size_t i, uint32_t t, uint32_t pixel) {
  raster::Fragments& f = g->fragments;
  f.pixel[i] = pixel % (kTile * kTile);
  f.x[i] = centre_of(pixel).x;
  f.y[i] = centre_of(pixel).y;
  f.triangle[i] = t;
}

/// Sets count and repeats the last row, as the contract requires.
void finish(size_t count) {
  raster::Fragments& f = g->fragments;
  f.count = count;
  for (size_t i = count; i < data::padded(count); ++i) set_fragment(i, f.triangle[count - 1], f.pixel[count - 1]);
}

/// The interpolated columns.
constexpr size_t kColumns = 18;
struct ColumnList {
  float* column[kColumns];
};
inline ColumnList columns_of(const raster::Fragments& f) {
  return {{f.bary[0], f.bary[1], f.bary[2], f.px, f.py, f.pz, f.nx, f.ny, f.nz, f.ox, f.oy, f.oz, f.u, f.v, f.dudx,
           f.dvdx, f.dudy, f.dvdy}};
}

/// Fails unless the rows of the batch equal those of `first`.
inline void compare_rows(const char* name) {
  const ColumnList got = columns_of(g->fragments), want = columns_of(g->first);
  for (size_t c = 0; c < kColumns; ++c) {
    if (memcmp(got.column[c], want.column[c], g->fragments.count * sizeof(float)) != 0)
      fail_msg("%s: other bits in column %zu", name, c);
  }
}
/// Fails unless the columns that most lit materials read have the bits of `first` if they alone are wanted.
inline void compare_lit(const core::SimdTarget& target) {
  const ColumnList columns = columns_of(g->fragments);
  for (size_t c = 3; c < kColumns; ++c) std::fill_n(columns.column[c], kBatch, -77.0f);
  const uint32_t lit = raster::kPosition | raster::kNormal | raster::kToEye | raster::kTexture;
  raster::interpolate(target, g->vertices, kEye, lit, &g->fragments);
  compare_rows(target.name);
}
inline void keep_rows() {
  memcpy(g->first.block.data(), g->fragments.block.data(), g->fragments.block.size() * sizeof(float));
}

}  // namespace
}  // namespace shd::tests
