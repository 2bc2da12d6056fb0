// SPDX-License-Identifier: MIT
// Materials, lights and points for tests of lobes, and the expected values. On the heap: cmocka fails by longjmp.
#pragma once

#include "support/check.h"

#include <algorithm>

#include "data/data.h"
#include "ref/model_ref.h"
#include "shade/illuminate.h"
#include "support/random.h"
#include "support/targets.h"

namespace shd::tests {

using raster::kBatch;
using ref::Vector;

inline const core::Allocator g_allocator = {core::default_allocator()};
constexpr size_t kMaxLights = 16;

struct LobeFixture {
  material::Material material;
  size_t count;  // number of lights
  shd_light_desc desc[kMaxLights];
  light::Light light[kMaxLights];
  shade::ActiveLight active[kMaxLights];
  shade::LobeShape shape;
  raster::Fragments points;
  shade::Columns columns, first;
  core::Array<float> block;  // factors and shapes
  float* factor[kMaxLights][3];
  float *exponent, *alpha_squared, *gain;
};
inline LobeFixture* g;

inline int set_up(void**) {
  g = new LobeFixture;
  raster::allocate(g_allocator, &g->points);
  shade::allocate(g_allocator, 1, &g->columns);
  shade::allocate(g_allocator, 1, &g->first);
  g->block = core::Array<float>(g_allocator, (3 * kMaxLights + 3) * kBatch);
  g->block.fill_zero();
  for (size_t k = 0; k < 3 * kMaxLights; ++k) g->factor[k / 3][k % 3] = g->block.data() + k * kBatch;
  g->exponent = g->block.data() + 3 * kMaxLights * kBatch;
  g->alpha_squared = g->exponent + kBatch;
  g->gain = g->alpha_squared + kBatch;
  return 0;
}
inline int tear_down(void**) {
  delete g;
  return 0;
}

struct ModelCase {
  const char* name;
  shd_model model;
  uint32_t flags;
  float exponent, roughness;
};

inline void set_material(const ModelCase& c) {
  shd_material_desc desc = shd_material_desc_default();
  desc.model = c.model;
  desc.flags = c.flags;
  desc.exponent = c.exponent;
  desc.roughness = c.roughness;
  desc.toon_steps = 5;
  const material::SlotInput slots[material::kSlotCount] = {};
  material::build(desc, slots, &g->material);
  g->shape = {};
}

/// Whether the shape of the model's lobes is a roughness; otherwise it is an exponent and its gain.
inline bool is_rough() {
  return material::info_of(g->material.model).shape_slots >> SHD_SLOT_ROUGHNESS & 1;
}

/// Columns for the shape of the model's lobes.
inline void set_shape(bool has_parameter, bool has_gain) {
  g->shape.column[0] = !has_parameter ? nullptr : is_rough() ? g->alpha_squared : g->exponent;
  g->shape.column[1] = has_gain ? g->gain : nullptr;
}

inline void set_light(size_t k, const shd_light_desc& desc) {
  g->desc[k] = desc;
  g->light[k] = light::make_light(desc, nullptr, nullptr);
  g->active[k] = {&g->light[k], {nullptr, nullptr, nullptr}};
}

inline void set_point(size_t i, Vector p, Vector n, Vector wo) {
  raster::Fragments& f = g->points;
  f.px[i] = static_cast<float>(p.x), f.py[i] = static_cast<float>(p.y), f.pz[i] = static_cast<float>(p.z);
  f.nx[i] = static_cast<float>(n.x), f.ny[i] = static_cast<float>(n.y), f.nz[i] = static_cast<float>(n.z);
  f.ox[i] = static_cast<float>(wo.x), f.oy[i] = static_cast<float>(wo.y), f.oz[i] = static_cast<float>(wo.z);
}

inline Vector random_unit(Random* random) {
  for (;;) {
    const Vector v = {random->in(-1.0, 1.0), random->in(-1.0, 1.0), random->in(-1.0, 1.0)};
    if (ref::length(v) > 0.1L && ref::length(v) < 1.0L) return ref::unit(v);
  }
}

enum LightMix { kPoints, kRanges, kDirections, kSpots, kRangedSpots, kHardSpots, kMixed, kMixCount };

inline void random_lights(Random* random, size_t count, LightMix wanted) {
  g->count = count;
  for (size_t k = 0; k < count; ++k) {
    const int mix = wanted == kMixed ? random->whole(0, kMixed - 1) : wanted;
    shd_light_desc desc = shd_light_desc_default();
    desc.kind = mix == kDirections ? SHD_LIGHT_KIND_DIRECTIONAL
                : mix >= kSpots    ? SHD_LIGHT_KIND_SPOT
                                   : SHD_LIGHT_KIND_POINT;
    const double power = std::exp2(random->in(-3.0, 6.0));
    for (int c = 0; c < 3; ++c) {
      desc.position[c] = random->real(-5.0, 5.0);
      desc.direction[c] = random->real(-1.0, 1.0) - 0.3f * desc.position[c];
      desc.intensity[c] = static_cast<float>(power * (1.0 + 0.25 * c));
    }
    if (mix == kRanges || mix == kRangedSpots) desc.range = random->real(1.0, 9.0);
    desc.outer_angle = random->real(0.2, 1.5);
    desc.inner_angle = mix == kHardSpots ? desc.outer_angle : random->real(0.0, 0.9) * desc.outer_angle;
    set_light(k, desc);
  }
}

/// Random rows; every other row shows the highlight of a light, with its normal near the half vector.
inline void random_points(Random* random, double sharpness) {
  g->points.count = kBatch;
  for (size_t i = 0; i < kBatch; ++i) {
    const Vector p = {random->in(-3.0, 3.0), random->in(-3.0, 3.0), random->in(-3.0, 3.0)};
    const Vector wo = random_unit(random);
    Vector n = random_unit(random);
    if (i % 2 && g->count) {
      const size_t k = i / 2 % g->count;
      const Vector l = ref::arriving(g->desc[k], g->light[k], p).l;
      n = ref::unit(ref::unit(wo + l) + sqrtl(random->in(0.0, 2.0) / (1.0 + sharpness)) * n);
    }
    set_point(i, p, n, wo);
  }
}

/// Runs every target into `columns`, the first also into `first`; all bits must agree.
inline void illuminate_everywhere() {
  const uint32_t lobes = material::info_of(g->material.model).lobes;
  for_each_target([&](const core::SimdTarget& target, bool first) {
    shade::Columns& out = first ? g->first : g->columns;
    shade::illuminate(target, g->material, g->shape, g->active, g->count, g->points, {false, true}, &out.lobes);
    for (uint32_t k = 0; k < 3 * lobes && !first; ++k) {
      if (memcmp(out.lobes.lobe[k / 3][k % 3], g->first.lobes.lobe[k / 3][k % 3], g->points.count * sizeof(float)))
        fail_msg("%s: other bits", target.name);
    }
  });
}

inline Vector row_vector(const float* x, const float* y, const float* z, size_t i) {
  const float v[3] = {x[i], y[i], z[i]};
  return ref::vector(v);
}

/// Expected lobes of row i in channel c, the bounds of their error, and whether a step may be rounded either way.
struct WantedLobes {
  long double lobe[3], bound[3];
  bool ambiguous;
};
inline WantedLobes wanted_lobes(size_t i, int c) {
  const raster::Fragments& f = g->points;
  const material::Material& m = g->material;
  const Vector p = row_vector(f.px, f.py, f.pz, i), n = row_vector(f.nx, f.ny, f.nz, i),
               wo = row_vector(f.ox, f.oy, f.oz, i);
  const float* parameter = g->shape.column[0];
  const long double exponent = !is_rough() && parameter ? parameter[i] : m.exponent;
  const long double alpha = is_rough() && parameter
                                ? sqrtl(parameter[i])
                                : std::max(static_cast<long double>(m.roughness) * m.roughness, 1e-3L);
  const bool gooch = m.model == SHD_MODEL_GOOCH;
  WantedLobes sum = {{}, {1e-37L, 1e-37L, 1e-37L}, false};
  for (size_t k = 0; k < g->count; ++k) {
    const ref::Arriving in = ref::arriving(g->desc[k], g->light[k], p);
    const ref::LobeTerms t = ref::lobes_of(m, exponent, alpha, n, wo, in.l);
    const float* factor = g->active[k].factor[c];
    const long double power = gooch ? 1 : g->desc[k].intensity[c] * (factor ? factor[i] : 1.0L);
    const long double e = gooch ? 1 : in.e, off = gooch ? 0 : in.error;
    for (int j = 0; j < 3; ++j) {
      sum.lobe[j] += power * e * t.lobe[j];
      // The bound includes the loss where E leaves the range of float.
      sum.bound[j] += power * (e * t.error[j] + off * (t.lobe[j] + t.error[j]) + 3e-39L) +
                      5e-7L * power * e * t.lobe[j] * static_cast<long double>(1 + k);
    }
    sum.ambiguous |= t.ambiguous && power * (e + off) > 0;
  }
  const bool has_gain = m.model == SHD_MODEL_PHONG || m.model == SHD_MODEL_BLINN_PHONG || m.model == SHD_MODEL_COMBINED;
  if (g->shape.column[1] && has_gain) {
    sum.lobe[1] *= g->shape.column[1][i];
    sum.bound[1] *= g->shape.column[1][i];
  }
  return sum;
}

inline double g_used[3];  // largest fraction of the bounds that was used

/// Compares all points of `first` with the formulas. Returns the number of unambiguous points.
inline size_t check_lobes() {
  const uint32_t lobes = material::info_of(g->material.model).lobes;
  size_t clear = 0;
  for (size_t i = 0; i < g->points.count; ++i) {
    for (int c = 0; c < 3; ++c) {
      const WantedLobes want = wanted_lobes(i, c);
      for (uint32_t k = 0; k < lobes; ++k) {
        const float got = g->first.lobes.lobe[k][c][i];
        if (want.ambiguous) {
          assert_true(std::isfinite(got) && got >= 0.0f);
          continue;
        }
        clear += c == 0 && k == 0;
        g_used[k] = std::max(g_used[k], static_cast<double>(fabsl(got - want.lobe[k]) / want.bound[k]));
        const char* const name[3] = {"lobe 0", "lobe 1", "lobe 2"};
        shd_assert_close(name[k], i, got, static_cast<double>(want.lobe[k]), static_cast<double>(want.bound[k]), 0.0);
      }
    }
  }
  return clear;
}

}  // namespace shd::tests
