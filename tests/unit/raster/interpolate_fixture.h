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

/// State of every test; the columns are compared as one block.
struct Fixture {
  geometry::Vertices vertices;
  raster::Fragments fragments, first;
};
Fixture* g;

int set_up(void**) {
  g = new Fixture;
  g->vertices.raster = core::Array<float>(g_allocator, 4 * kVertices);
  g->vertices.world = core::Array<float>(g_allocator, 4 * kVertices);
  g->vertices.normal = core::Array<float>(g_allocator, 4 * kVertices);
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

/// Fragment `i` of triangle `t`, whose vertices are 3t, 3t + 1 and 3t + 2.
void set_fragment(size_t i, uint32_t t, float x, float y) {
  raster::Fragments& f = g->fragments;
  f.x[i] = x;
  f.y[i] = y;
  f.triangle[i] = t;
  for (uint32_t k = 0; k < 3; ++k) f.vertex[k][i] = 3 * t + k;
}

/// Sets count and repeats the last row, as the contract requires.
void finish(size_t count) {
  raster::Fragments& f = g->fragments;
  f.count = count;
  for (size_t i = count; i < data::padded(count); ++i)
    set_fragment(i, f.triangle[count - 1], f.x[count - 1], f.y[count - 1]);
}

/// Fails unless all columns of the batch equal those of `first`.
inline void compare_blocks(const char* name) {
  const size_t bytes = g->fragments.block.size() * sizeof(float);
  if (memcmp(g->fragments.block.data(), g->first.block.data(), bytes) != 0) fail_msg("%s: other bits", name);
}
inline void keep_block() {
  memcpy(g->first.block.data(), g->fragments.block.data(), g->fragments.block.size() * sizeof(float));
}

}  // namespace
}  // namespace shd::tests
