// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>

#include "procedural/solid.h"
#include "ref/solid_ref.h"
#include "support/check.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {

constexpr size_t kMaxPoints = 4096;
constexpr float kCanary = 123456.0f;

/// Points and their values, with room for a canary after the last one.
struct Points {
  size_t count;
  float x[kMaxPoints], y[kMaxPoints], z[kMaxPoints], width[kMaxPoints];
  float value[kMaxPoints + 1], gradient[3][kMaxPoints + 1];

  /// Places in a cube of a half side, and widths from 0 to twice the half side.
  void fill(Random* random, double reach) {
    for (size_t i = 0; i < kMaxPoints; ++i) {
      x[i] = random->real(-reach, reach);
      y[i] = random->real(-reach, reach);
      z[i] = random->real(-reach, reach);
      width[i] = i % 5 == 0 ? 0.0f : static_cast<float>(std::exp2(random->in(-14.0, 4.0)));
    }
  }
};

struct solid_case {
  const char* name;
  shd_solid kind;
  shd_solid_gradients gradients;
  shd_solid_fade fade;
  shd_solid_distance distance;
  double mean_absolute;  // mean of |n| in one octave; Worley noise: the mean
};
constexpr shd_solid_gradients kHashed = SHD_SOLID_GRADIENTS_HASHED, kTable = SHD_SOLID_GRADIENTS_TABLE;
constexpr shd_solid_fade kQuintic = SHD_SOLID_FADE_QUINTIC, kCubic = SHD_SOLID_FADE_CUBIC,
                         kLinear = SHD_SOLID_FADE_LINEAR;
constexpr shd_solid_distance kF1 = SHD_SOLID_DISTANCE_F1;
inline const solid_case k_solids[] = {
    {"stripes", SHD_SOLID_STRIPES, kHashed, kQuintic, kF1, 0.5},
    {"checker", SHD_SOLID_CHECKER, kHashed, kQuintic, kF1, 0.5},
    {"perlin/quintic", SHD_SOLID_PERLIN, kHashed, kQuintic, kF1, 0.2125},
    {"perlin/cubic", SHD_SOLID_PERLIN, kHashed, kCubic, kF1, 0.2},
    {"perlin/table_quintic", SHD_SOLID_PERLIN, kTable, kQuintic, kF1, 0.1561},
    {"perlin/table_cubic", SHD_SOLID_PERLIN, kTable, kCubic, kF1, 0.1478},
    {"perlin/linear", SHD_SOLID_PERLIN, kHashed, kLinear, kF1, 0.1838},
    {"perlin/table_linear", SHD_SOLID_PERLIN, kTable, kLinear, kF1, 0.1385},
    {"value/quintic", SHD_SOLID_VALUE, kHashed, kQuintic, kF1, 0.3301},
    {"value/cubic", SHD_SOLID_VALUE, kHashed, kCubic, kF1, 0.3028},
    {"value/linear", SHD_SOLID_VALUE, kHashed, kLinear, kF1, 0.2553},
    {"simplex", SHD_SOLID_SIMPLEX, kHashed, kQuintic, kF1, 0.314},
    {"worley/f1", SHD_SOLID_WORLEY, kHashed, kQuintic, kF1, 0.3005},
    {"worley/f2", SHD_SOLID_WORLEY, kHashed, kQuintic, SHD_SOLID_DISTANCE_F2, 0.4139},
    {"worley/f2_f1", SHD_SOLID_WORLEY, kHashed, kQuintic, SHD_SOLID_DISTANCE_F2_F1, 0.1135},
    {"marble", SHD_SOLID_MARBLE, kHashed, kQuintic, kF1, 0.2125},
    {"marble/linear", SHD_SOLID_MARBLE, kHashed, kLinear, kF1, 0.1838},
    {"wood/linear", SHD_SOLID_WOOD, kHashed, kLinear, kF1, 0.1838},
    {"wood", SHD_SOLID_WOOD, kHashed, kCubic, kF1, 0.2},
};

inline shd_solid_desc desc_of(const solid_case& c) {
  shd_solid_desc desc = shd_solid_desc_default();
  desc.kind = c.kind;
  desc.gradients = c.gradients;
  desc.fade = c.fade;
  desc.distance = c.distance;
  return desc;
}

/// Whether octaves may be summed as absolute values.
inline bool can_fold(const solid_case& c) {
  return c.kind >= SHD_SOLID_PERLIN && c.kind <= SHD_SOLID_SIMPLEX;
}

/// The mean that replaces an octave.
inline double mean_of(const solid_case& c, const shd_solid_desc& desc) {
  if (c.kind == SHD_SOLID_WORLEY || c.kind == SHD_SOLID_MARBLE) return c.mean_absolute;
  return can_fold(c) && desc.sum == SHD_SOLID_SUM_TURBULENCE ? c.mean_absolute : 0.0;
}

/// Evaluates the points of a table. Returns the number of places that are not finite.
inline size_t run(const procedural::Solid& solid, const core::SimdTarget& target, bool has_width, bool has_gradient,
                  Points* p) {
  for (size_t i = 0; i <= kMaxPoints; ++i) {
    p->value[i] = kCanary;
    for (auto& column : p->gradient) column[i] = kCanary;
  }
  procedural::Values out = {p->value, {}};
  for (size_t c = 0; has_gradient && c < 3; ++c) out.gradient[c] = p->gradient[c];
  return procedural::evaluate(solid, target, {p->count, p->x, p->y, p->z, has_width ? p->width : nullptr}, out);
}

inline double ref_value(const solid_case& c, const shd_solid_desc& desc, const procedural::Solid& solid,
                        const double (&place)[3], double width) {
  const ref::SolidTable table = {solid.table.permutation, solid.table.x, solid.table.y, solid.table.z};
  return ref::solid(desc, table, mean_of(c, desc), place, width);
}

/// A test that runs for every case of k_solids.
struct solid_test {
  const char* name;
  CMUnitTestFunction body;
};

/// Adds the tests "name/case". Returns their number.
template <size_t kTests>
size_t add_solid_tests(const solid_test (&bodies)[kTests], CMUnitTest* tests) {
  static char names[kTests * std::size(k_solids)][64];
  size_t n = 0;
  for (const solid_test& test : bodies) {
    for (const solid_case& c : k_solids) {
      snprintf(names[n], sizeof names[n], "%s/%s", test.name, c.name);
      tests[n] = {names[n], test.body, nullptr, nullptr, const_cast<solid_case*>(&c)};
      ++n;
    }
  }
  return n;
}

}  // namespace shd::tests
