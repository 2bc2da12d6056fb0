// SPDX-License-Identifier: MIT
// EXACT in 3D textures: rectangles and boxes along the axes in closed form, parallelograms against many samples, linear
// functions, points, and the number of cells.
#include "filter_cases.h"
#include "solids.h"

#include "ref/exact_ref.h"
#include "texture/domain/exact_footprint.h"

namespace {

using namespace fixture;

SolidBatch t_batch;

shd_sampler_desc exact_desc(uint32_t triple) {
  return solid_sampler(SHD_FILTER_EXACT, triple);
}

int64_t any_target() {
  return hwy::SupportedAndGeneratedTargets().front();
}

/// Average over a box around a place: texels times averages of their hats. A side of 0 has the hat itself.
double box_average(const ref::Solid& solid, int level, const ref::Place& p, const ref::Place& sides, int c) {
  const ref::Place t = ref::texels_of(solid, level, p, -0.5);
  const auto weight = [](double x, double side, int64_t i) {
    const double at = x - static_cast<double>(i);
    if (side == 0) return fmax(0, 1 - fabs(at));
    return (ref::hat_integral(at + side / 2) - ref::hat_integral(at - side / 2)) / side;
  };
  const auto first = [](double x, double side) { return static_cast<int64_t>(floor(x - side / 2)); };
  double sum = 0;
  for (int64_t k = first(t.w, sides.w); static_cast<double>(k) < t.w + sides.w / 2 + 1; ++k) {
    for (int64_t j = first(t.v, sides.v); static_cast<double>(j) < t.v + sides.v / 2 + 1; ++j) {
      for (int64_t i = first(t.u, sides.u); static_cast<double>(i) < t.u + sides.u / 2 + 1; ++i) {
        const double part = weight(t.u, sides.u, i) * weight(t.v, sides.v, j) * weight(t.w, sides.w, k);
        if (part > 0) sum += part * ref::texel(solid, level, i, j, k, c);
      }
    }
  }
  return sum;
}

/// Two sides along two of the three axes.
void test_rectangles(void** state) {
  const auto& size = *static_cast<const SolidSize*>(*state);
  const float sizes[] = {static_cast<float>(size.width), static_cast<float>(size.height),
                         static_cast<float>(size.depth)};
  Random random{9};
  make_places(&t_batch);
  t_batch.count = 18;
  static ref::Place sides[kMaxPoints];
  for (size_t i = 0; i < t_batch.count; ++i) {
    float *const x[] = {t_batch.dudx, t_batch.dvdx, t_batch.dwdx}, *const y[] = {t_batch.dudy, t_batch.dvdy,
                                                                                 t_batch.dwdy};
    float* const at[] = {t_batch.u, t_batch.v, t_batch.w};
    double side[3] = {0, 0, 0};
    for (size_t a = 0; a < 3; ++a) {
      const float length = a == i % 3 ? 0 : random.real(0.25f, 5);
      at[a][i] = random.real(-2, 3);
      x[a][i] = a == (i + 1) % 3 ? length / sizes[a] : 0;
      y[a][i] = a == (i + 2) % 3 ? -length / sizes[a] : 0;
      side[a] = fabs(static_cast<double>(x[a][i] + y[a][i])) * static_cast<double>(sizes[a]);
    }
    sides[i] = {side[0], side[1], side[2]};
  }
  for (const shd_format format : kSolidFormats) {
    Texture* texture = random_solid(format, size);
    for (uint32_t triple = 0; triple < 25; ++triple) {
      const shd_sampler_desc desc = exact_desc(triple);
      ref::SolidLevel levels[shd::texture::kMaxLevels];
      const ref::Solid solid = oracle_solid(*texture, desc, levels);
      assert_int_equal(run(*texture, make_sampler(desc), any_target(), t_batch.places(true, false), &t_batch), 0);
      for (size_t i = 0; i < t_batch.count; ++i) {
        for (int c = 0; c < 4; ++c) {
          shd_assert_close(size.name, i, static_cast<double>(t_batch.out[c][i]),
                           box_average(solid, 0, place_of(t_batch, i), sides[i], c), 1e-6 * fmax(magnitude(format), 2),
                           0);
        }
      }
    }
    free_texture(texture);
  }
}

/// A level of detail is a box; bias scales it, lod_min raises the level.
void test_lod(void**) {
  const SolidSize size = {"lod", 32, 16, 32};
  Texture* texture = random_solid(SHD_FORMAT_RGBA32F, size);
  make_places(&t_batch);
  t_batch.count = 40;
  for (uint32_t lowest = 0; lowest < 3; ++lowest) {
    shd_sampler_desc desc = exact_desc(6);
    desc.lod_bias = 0.75f;
    desc.lod_min = static_cast<float>(lowest);
    for (size_t i = 0; i < t_batch.count; ++i) t_batch.lod[i] = static_cast<float>(i) / 16 - 1;
    ref::SolidLevel levels[shd::texture::kMaxLevels];
    const ref::Solid solid = oracle_solid(*texture, desc, levels);
    run(*texture, make_sampler(desc), any_target(), t_batch.places(false, true), &t_batch);
    for (size_t i = 0; i < t_batch.count; ++i) {
      const double edge = exp2(static_cast<double>(t_batch.lod[i]) + 0.75 - lowest);
      shd_assert_close("lod", i, static_cast<double>(t_batch.out[1][i]),
                       box_average(solid, static_cast<int>(lowest), place_of(t_batch, i), {edge, edge, edge}, 1), 8e-6,
                       0);
    }
  }
  free_texture(texture);
}

/// Footprints in any plane, thick, thin and without width. The error is mostly in the samples.
void test_parallelograms(void**) {
  constexpr int kSamples = 300;
  const SolidSize size = {"", 12, 12, 12};
  Texture* texture = random_solid(SHD_FORMAT_RGBA32F, size);
  Random random{77};
  make_places(&t_batch);
  t_batch.count = 18;
  for (size_t i = 0; i < t_batch.count; ++i) {
    float *const x[] = {t_batch.dudx, t_batch.dvdx, t_batch.dwdx}, *const y[] = {t_batch.dudy, t_batch.dvdy,
                                                                                 t_batch.dwdy};
    const float width = i % 3 == 0 ? 1.0f : i % 3 == 1 ? 1e-3f : 0.0f;
    for (int a = 0; a < 3; ++a) {
      x[a][i] = random.real(-0.2f, 0.2f);
      y[a][i] = -0.5f * x[a][i] + width * random.real(-0.2f, 0.2f);
    }
    t_batch.u[i] = random.real(-1, 2), t_batch.v[i] = random.real(-1, 2), t_batch.w[i] = random.real(-1, 2);
  }
  for (uint32_t triple = 0; triple < 25; triple += 4) {
    const shd_sampler_desc desc = exact_desc(triple);
    ref::SolidLevel levels[shd::texture::kMaxLevels];
    const ref::Solid solid = oracle_solid(*texture, desc, levels);
    run(*texture, make_sampler(desc), any_target(), t_batch.places(true, false), &t_batch);
    for (size_t i = 0; i < t_batch.count; ++i) {
      const auto side = [&](const float* u, const float* v, const float* w) {
        return ref::Place{static_cast<double>(u[i]), static_cast<double>(v[i]), static_cast<double>(w[i])};
      };
      const double want =
          ref::parallelogram_average(solid, place_of(t_batch, i), side(t_batch.dudx, t_batch.dvdx, t_batch.dwdx),
                                     side(t_batch.dudy, t_batch.dvdy, t_batch.dwdy), kSamples, 0);
      shd_assert_close("parallelogram", i, static_cast<double>(t_batch.out[0][i]), want, 4e-4, 0);
    }
  }
  free_texture(texture);
}

/// The average of a linear function is its value at the centre of any parallelogram; points are those of BILINEAR.
void test_ramp(void**) {
  constexpr uint32_t kEdge = 32;
  auto* texels = static_cast<float*>(malloc(kEdge * kEdge * kEdge * sizeof(float)));
  for (uint32_t i = 0; i < kEdge * kEdge * kEdge; ++i) {
    texels[i] = static_cast<float>(i % kEdge) - 2 * static_cast<float>(i / kEdge % kEdge) +
                3 * static_cast<float>(i / kEdge / kEdge);
  }
  Texture* texture =
      build_solid(solid_desc(SHD_FORMAT_R32F, {"", kEdge, kEdge, kEdge}, reinterpret_cast<uint8_t*>(texels)));
  Random random{5};
  t_batch.count = kMaxPoints;
  for (size_t i = 0; i < kMaxPoints; ++i) {
    const float scale = ldexpf(0.2f, -static_cast<int>(i % 25)), thin = ldexpf(1, -static_cast<int>(i / 25));
    for (float* at : {t_batch.u, t_batch.v, t_batch.w}) at[i] = random.real(0.4f, 0.6f);
    for (float* x : {t_batch.dudx, t_batch.dvdx, t_batch.dwdx}) x[i] = scale * random.real(-1, 1);
    for (float* y : {t_batch.dudy, t_batch.dvdy, t_batch.dwdy}) y[i] = thin * scale * random.real(-1, 1);
  }
  run(*texture, make_sampler(exact_desc(12)), any_target(), t_batch.places(true, false), &t_batch);
  for (size_t i = 0; i < kMaxPoints; ++i) {
    const ref::Place p = place_of(t_batch, i);
    const double want = (p.u - 2 * p.v + 3 * p.w) * kEdge - 0.5 * (1 - 2 + 3);
    shd_assert_close("ramp", i, static_cast<double>(t_batch.out[0][i]), want, 4e-5, 0);
  }
  free_texture(texture);
  free(texels);
}

struct CellCounter {
  double count = 0, area = 0;
  void cell(int64_t, int64_t, int64_t, const shd::texture::SpaceMoments& m) {
    count += 1;
    area += m.one;
  }
};

/// No lookup visits more cells than its tolerance allows, and the pieces of a footprint make up its whole area.
void test_cells(void**) {
  const float hostile[] = {0,       1e-45f, 1e-8f,  0.3f, 1,        7,         1e8f,
                           3.4e38f, -0.7f,  -1e20f, NAN,  INFINITY, -INFINITY, 0.013f};
  constexpr size_t kHostile = sizeof hostile / sizeof hostile[0];
  Texture* texture = random_solid(SHD_FORMAT_R8, {"", 63, 8, 100});
  Random random{3};
  make_places(&t_batch);
  for (size_t i = 0; i < kPoints; ++i) {
    for (float* column :
         {t_batch.dudx, t_batch.dvdx, t_batch.dwdx, t_batch.dudy, t_batch.dvdy, t_batch.dwdy, t_batch.lod}) {
      column[i] = i % 2 ? hostile[random.next() % kHostile] : random.real(-2, 2);
    }
  }
  for (const float tolerance : {1.0f, 0.125f, 0.015625f}) {
    shd_sampler_desc desc = exact_desc(1);
    desc.tolerance = tolerance;
    for (size_t i = 0; i < kPoints; ++i) {
      for (const bool lod : {false, true}) {
        const auto f = shd::texture::exact_footprint(*texture, make_sampler(desc), t_batch.places(!lod, lod), i);
        CellCounter cells;
        visit_cells_in_space(f.center, f.a, f.b, &cells);
        assert_true(cells.count * (f.depth > 0 ? floor(f.depth) + 2 : 1) <=
                    shd::texture::exact_cell_limit(tolerance) + 16);
        shd_assert_close("area", i, cells.area, 1, 1e-9, 0);
      }
    }
  }
  free_texture(texture);
}

}  // namespace

int main() {
  static char names[6][32];
  CMUnitTest tests[16];
  size_t n = 0;
  for (const SolidSize& size : kSolidSizes) {
    snprintf(names[n], sizeof names[n], "rectangles/%s", size.name);
    tests[n] = {names[n], test_rectangles, nullptr, nullptr, const_cast<SolidSize*>(&size)};
    ++n;
  }
  tests[n++] = {"lod", test_lod, nullptr, nullptr, nullptr};
  tests[n++] = {"parallelograms", test_parallelograms, nullptr, nullptr, nullptr};
  tests[n++] = {"ramp", test_ramp, nullptr, nullptr, nullptr};
  tests[n++] = {"cells", test_cells, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.slices_exact", tests, n, nullptr, nullptr);
}
