// SPDX-License-Identifier: MIT
// Rows with normals and tangents, turned on every target. On the heap: cmocka fails by longjmp.
#pragma once

#include "support/check.h"

#include <algorithm>

#include "data/data.h"
#include "ref/surface_ref.h"
#include "shade/normals.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {
using raster::kBatch;
using ref::Vector;

inline const core::Allocator g_allocator = {core::default_allocator()};

struct NormalFixture {
  material::Material material;
  raster::Fragments points, before, first;
  shade::Columns columns, given;
  float variance[kBatch];
};
inline NormalFixture* g;

inline int set_up(void**) {
  g = new NormalFixture;
  for (raster::Fragments* f : {&g->points, &g->before, &g->first}) raster::allocate(g_allocator, f);
  shade::allocate(g_allocator, 1, &g->columns);
  shade::allocate(g_allocator, 1, &g->given);
  return 0;
}
inline int tear_down(void**) {
  delete g;
  return 0;
}

inline Vector random_unit(Random* random) {
  for (;;) {
    const Vector v = {random->in(-1.0, 1.0), random->in(-1.0, 1.0), random->in(-1.0, 1.0)};
    if (ref::length(v) > 0.1L && ref::length(v) < 1.0L) return ref::unit(v);
  }
}

inline void store(const Vector& v, float* x, float* y, float* z, size_t i) {
  x[i] = static_cast<float>(v.x), y[i] = static_cast<float>(v.y), z[i] = static_cast<float>(v.z);
}
inline Vector load(const float* x, const float* y, const float* z, size_t i) {
  const float v[3] = {x[i], y[i], z[i]};
  return ref::vector(v);
}
inline Vector normal_of(const raster::Fragments& f, size_t i) {
  return load(f.nx, f.ny, f.nz, i);
}

inline void copy_points(const raster::Fragments& from, raster::Fragments* to) {
  to->count = from.count;
  std::copy_n(from.block.data(), from.block.size(), to->block.data());
}

inline void check_normal(const char* what, size_t i, const Vector& want, double tolerance) {
  shd_assert_close(what, i, g->first.nx[i], static_cast<double>(want.x), tolerance, 0.0);
  shd_assert_close(what, i, g->first.ny[i], static_cast<double>(want.y), tolerance, 0.0);
  shd_assert_close(what, i, g->first.nz[i], static_cast<double>(want.z), tolerance, 0.0);
}

/// Normals and tangents that are not exactly perpendicular, of any length and handedness.
inline void random_points(Random* random) {
  g->before.count = kBatch;
  for (size_t i = 0; i < kBatch; ++i) {
    const Vector n = random_unit(random), other = random_unit(random);
    const Vector t = ref::unit(other - 0.8L * ref::dot(other, n) * n);
    store(n, g->before.nx, g->before.ny, g->before.nz, i);
    store(std::exp2(random->in(-20.0, 20.0)) * t, g->before.tx, g->before.ty, g->before.tz, i);
    g->before.tw[i] = random->bits() & 1 ? -1.0f : 1.0f;
  }
}

/// Calls run(target, points) with equal points on every target, with the result in `first`: all bits agree, and tails
/// are complete and write nothing more.
template <class Run>
void turn_everywhere(const Run& run) {
  for_each_target([&](const core::SimdTarget& target, bool first) {
    raster::Fragments& points = first ? g->first : g->points;
    copy_points(g->before, &points);
    run(target, &points);
    const float *got[3] = {points.nx, points.ny, points.nz}, *want[3] = {g->first.nx, g->first.ny, g->first.nz};
    for (int c = 0; c < 3; ++c) assert_memory_equal(got[c], want[c], points.count * sizeof(float));
  });
}

template <class Run>
void turn_tails(const Run& run) {
  turn_everywhere(run);
  const size_t all = g->before.count;
  for_each_target([&](const core::SimdTarget& target, bool) {
    for (size_t count = 0; count <= 2 * 64 + 3; ++count) {
      copy_points(g->before, &g->points);
      g->points.count = count;
      run(target, &g->points);
      const float *got[3] = {g->points.nx, g->points.ny, g->points.nz},
                  *want[3] = {g->first.nx, g->first.ny, g->first.nz};
      const float* old[3] = {g->before.nx, g->before.ny, g->before.nz};
      for (int c = 0; c < 3; ++c) {
        assert_memory_equal(got[c], want[c], count * sizeof(float));
        assert_memory_equal(got[c] + data::padded(count), old[c] + data::padded(count),
                            (all - data::padded(count)) * sizeof(float));
      }
    }
  });
}

}  // namespace shd::tests
