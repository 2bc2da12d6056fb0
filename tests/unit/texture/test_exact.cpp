// SPDX-License-Identifier: MIT
// The exact filter: rectangles in closed form for every format x wrap pair x size, parallelograms against many samples,
// properties for constants, ramps, points, hostile footprints and texels, and its quality on a floor.
#include "filter_cases.h"

#include "ref/exact_ref.h"
#include "texture/domain/cube_pieces.h"
#include "texture/domain/exact_footprint.h"

namespace {

using namespace fixture;

Batch t_batch, t_other;

shd_sampler_desc exact_desc(uint32_t pair) {
  return wrap_desc(SHD_FILTER_EXACT, pair);
}

int64_t any_target() {
  return hwy::SupportedAndGeneratedTargets().front();
}

ref::Jacobian jacobian_of(const Batch& batch, size_t i) {
  return {static_cast<double>(batch.dudx[i]), static_cast<double>(batch.dvdx[i]), static_cast<double>(batch.dudy[i]),
          static_cast<double>(batch.dvdy[i])};
}

/// Footprints with sides along the axes, up to `texels` long, in either order and sign.
void make_rectangles(Batch* batch, size_t count, float texels, const SizeCase& c) {
  Random random{c.width * 7 + c.height};
  batch->count = count;
  for (size_t i = 0; i < count; ++i) {
    batch->u[i] = random.real(-2, 3);
    batch->v[i] = random.real(-2, 3);
    const float u = random.real(-texels, texels) / static_cast<float>(c.width);
    const float v = random.real(-texels, texels) / static_cast<float>(c.height);
    const bool swapped = i % 2;
    batch->dudx[i] = swapped ? 0 : u;
    batch->dvdx[i] = swapped ? v : 0;
    batch->dudy[i] = swapped ? u : 0;
    batch->dvdy[i] = swapped ? 0 : v;
  }
}

void test_rectangles(void** state) {
  const auto& c = *static_cast<const SizeCase*>(*state);
  make_rectangles(&t_batch, 12, 5, c);
  for (const shd_format format : kFormats) {
    Texture* texture = random_texture(format, c.width, c.height, true);
    for (uint32_t pair = 0; pair < 25; ++pair) {
      const shd_sampler_desc desc = exact_desc(pair);
      ref::Level levels[shd::texture::kMaxLevels];
      const ref::Image image = oracle_image(*texture, desc, levels);
      assert_int_equal(run(*texture, make_sampler(desc), any_target(), t_batch.lookups(true, false), &t_batch), 0);
      for (size_t i = 0; i < t_batch.count; ++i) {
        const ref::Jacobian j = jacobian_of(t_batch, i);
        const double width = fabs(j.ux + j.uy) * c.width, height = fabs(j.vx + j.vy) * c.height;
        for (int channel = 0; channel < 4; ++channel) {
          const double want = ref::box_average(image, 0, static_cast<double>(t_batch.u[i]),
                                               static_cast<double>(t_batch.v[i]), width, height, channel);
          shd_assert_close(c.name, i, static_cast<double>(t_batch.out[channel][i]), want,
                           1e-6 * fmax(magnitude(format), 2), 0);
        }
      }
    }
    free_texture(texture);
  }
}

/// A level of detail is a square; bias scales it, lod_min raises the level.
void test_lod(void**) {
  const SizeCase c = {"lod", 64, 32};
  make_rectangles(&t_batch, 64, 1, c);
  Texture* texture = random_texture(SHD_FORMAT_RGBA32F, c.width, c.height, true);
  for (uint32_t lowest = 0; lowest < 3; ++lowest) {
    shd_sampler_desc desc = exact_desc(6);
    desc.lod_bias = 0.75f;
    desc.lod_min = static_cast<float>(lowest);
    for (size_t i = 0; i < t_batch.count; ++i) t_batch.lod[i] = static_cast<float>(i) / 16 - 1;
    ref::Level levels[shd::texture::kMaxLevels];
    const ref::Image image = oracle_image(*texture, desc, levels);
    run(*texture, make_sampler(desc), any_target(), t_batch.lookups(true, true), &t_batch);
    for (size_t i = 0; i < t_batch.count; ++i) {
      const double edge = exp2(static_cast<double>(t_batch.lod[i]) + 0.75 - lowest);
      const double want = ref::box_average(image, static_cast<int>(lowest), static_cast<double>(t_batch.u[i]),
                                           static_cast<double>(t_batch.v[i]), edge, edge, 1);
      shd_assert_close("lod", i, static_cast<double>(t_batch.out[1][i]), want, 8e-6, 0);
    }
  }
  free_texture(texture);
}

/// Rotated and sheared footprints, thick, thin and without width. The error is mostly in the samples.
void test_parallelograms(void**) {
  Texture* texture = random_texture(SHD_FORMAT_RGBA32F, 16, 16, true);
  Random random{77};
  t_batch.count = 24;
  for (size_t i = 0; i < t_batch.count; ++i) {
    t_batch.u[i] = random.real(-1, 2);
    t_batch.v[i] = random.real(-1, 2);
    const float width = i % 3 == 0 ? 1.0f : i % 3 == 1 ? 1e-3f : 0.0f;
    t_batch.dudx[i] = random.real(-0.2f, 0.2f);
    t_batch.dvdx[i] = random.real(-0.2f, 0.2f);
    t_batch.dudy[i] = -0.5f * t_batch.dudx[i] + width * random.real(-0.2f, 0.2f);
    t_batch.dvdy[i] = -0.5f * t_batch.dvdx[i] + width * random.real(-0.2f, 0.2f);
  }
  for (uint32_t pair = 0; pair < 25; pair += 3) {
    const shd_sampler_desc desc = exact_desc(pair);
    ref::Level levels[shd::texture::kMaxLevels];
    const ref::Image image = oracle_image(*texture, desc, levels);
    run(*texture, make_sampler(desc), any_target(), t_batch.lookups(true, false), &t_batch);
    for (size_t i = 0; i < t_batch.count; ++i) {
      const double want = ref::parallelogram_average(
          image, static_cast<double>(t_batch.u[i]), static_cast<double>(t_batch.v[i]), jacobian_of(t_batch, i), 200, 0);
      shd_assert_close("parallelogram", i, static_cast<double>(t_batch.out[0][i]), want, 4e-4, 0);
    }
  }
  free_texture(texture);
}

/// The average of a linear function is its value at the centre of any parallelogram.
void test_ramp(void**) {
  static float texels[64 * 64];
  for (size_t i = 0; i < 64 * 64; ++i) texels[i] = static_cast<float>(i % 64) - 2 * static_cast<float>(i / 64);
  Texture* texture = make_texture(SHD_FORMAT_R32F, 64, 64, reinterpret_cast<uint8_t*>(texels), true);
  Random random{5};
  t_batch.count = kMaxPoints;
  for (size_t i = 0; i < kMaxPoints; ++i) {
    const float scale = ldexpf(0.2f, -static_cast<int>(i % 25)), thin = ldexpf(1, -static_cast<int>(i / 25));
    t_batch.u[i] = random.real(0.4f, 0.6f);
    t_batch.v[i] = random.real(0.4f, 0.6f);
    t_batch.dudx[i] = scale * random.real(-1, 1);
    t_batch.dvdx[i] = scale * random.real(-1, 1);
    t_batch.dudy[i] = thin * scale * random.real(-1, 1);
    t_batch.dvdy[i] = thin * scale * random.real(-1, 1);
  }
  run(*texture, make_sampler(exact_desc(12)), any_target(), t_batch.lookups(true, false), &t_batch);
  for (size_t i = 0; i < kMaxPoints; ++i) {
    const double want =
        static_cast<double>(t_batch.u[i]) * 64 - 0.5 - 2 * (static_cast<double>(t_batch.v[i]) * 64 - 0.5);
    shd_assert_close("ramp", i, static_cast<double>(t_batch.out[0][i]), want, 2e-5, 0);
  }
  free_texture(texture);
}

/// A footprint without extent is a point: the result has the bits of bilinear.
void test_points(void**) {
  make_points(&t_batch);
  memcpy(&t_other, &t_batch, sizeof t_batch);
  for (size_t i = 0; i < kPoints; ++i) t_batch.lod[i] = -INFINITY;
  for (const shd_format format : kFormats) {
    Texture* texture = random_texture(format, 13, 9, true);
    for (uint32_t pair = 0; pair < 25; ++pair) {
      shd_sampler_desc desc = exact_desc(pair), bilinear = desc;
      bilinear.filter = SHD_FILTER_BILINEAR;
      for_each_target([&](int64_t target) {
        run(*texture, make_sampler(bilinear), target, t_other.lookups(false, false), &t_other);
        run(*texture, make_sampler(desc), target, t_batch.lookups(false, false), &t_batch);
        assert_memory_equal(t_batch.out, t_other.out, sizeof t_batch.out);
        run(*texture, make_sampler(desc), target, t_batch.lookups(false, true), &t_batch);
        assert_memory_equal(t_batch.out, t_other.out, sizeof t_batch.out);
      });
    }
    free_texture(texture);
  }
}

/// Hostile footprints, some without width.
void make_hostile(Batch* batch) {
  make_hostile_points(batch);
  for (size_t i = 2; i < kMaxPoints; i += 4) {
    batch->dudy[i] = 2 * batch->dudx[i];
    batch->dvdy[i] = 2 * batch->dvdx[i];
  }
}

/// Samplers that reach the limits of the footprint, with a coarse tolerance to keep the test short.
shd_sampler_desc hostile_desc(uint32_t pair) {
  shd_sampler_desc desc = exact_desc(pair);
  desc.tolerance = pair % 2 ? 0.25f : 0.0625f;
  desc.width_x = pair % 3 ? 1.0f : 0.0f;
  desc.blur_v = pair % 7 ? 0.0f : 0.5f;
  desc.lod_bias = static_cast<float>(static_cast<int>(pair % 5)) * 7 - 14;
  desc.lod_min = pair % 4 == 1 ? 1.5f : 0;
  desc.lod_max = pair % 4 == 3 ? 0.5f : 32;
  return desc;
}

/// Finite texels give values between the smallest and the largest; a constant texture gives its value.
void test_hostile(void**) {
  make_hostile(&t_batch);
  for (const bool constant : {false, true}) {
    uint8_t texels[8 * 8 * 16];
    for (const shd_format format : kFormats) {
      random_texels(format, 64, 4242, texels);
      if (constant) constant_texels(format, 64, texels);
      Texture* texture = make_texture(format, 8, 8, texels, true);
      for (uint32_t pair = 0; pair < 25; ++pair) {
        shd_sampler_desc desc = hostile_desc(pair);
        for (int c = 0; c < 4; ++c) desc.border[c] = static_cast<float>(ref::decode(format, texels, c));
        run(*texture, make_sampler(desc), any_target(), t_batch.lookups(pair % 2 == 0, pair % 2 == 1), &t_batch);
        for (int c = 0; c < 4; ++c) {
          const double maximum = constant ? 0 : magnitude(format) * 1.000001;
          const double around = constant ? static_cast<double>(desc.border[c]) : 0;
          for (size_t i = 0; i < kMaxPoints; ++i) {
            if (!constant && c >= ref::layout(format).channels) break;
            shd_assert_close("hostile", i, static_cast<double>(t_batch.out[c][i]), around, maximum, 0);
          }
        }
      }
      free_texture(texture);
    }
  }
}

struct CellCounter {
  double count, area;
  void cell(int64_t, int64_t, const shd::texture::Moments& m) { ++count, area += m.one; }
  void run(int64_t, int64_t begin, int64_t end) {
    count += static_cast<double>(end - begin), area += static_cast<double>(end - begin);
  }
};

/// The number of cells of a lookup stays below the stated bound.
void test_cost(void**) {
  make_hostile(&t_batch);
  for (const bool mipmap : {false, true}) {
    Texture* texture = random_texture(SHD_FORMAT_R8, 1023, 64, mipmap);
    for (uint32_t pair = 0; pair < 25; ++pair) {
      const Sampler sampler = make_sampler(hostile_desc(pair));
      const Lookups lookups = t_batch.lookups(pair % 2 == 0, pair % 2 == 1);
      for (size_t i = 0; i < lookups.count; ++i) {
        const auto f = shd::texture::exact_footprint(*texture, sampler, lookups, i);
        CellCounter cells = {0, 0};
        visit_cells(shd::texture::parallelogram(f.center, f.a, f.b), &cells);
        assert_true(cells.count <= shd::texture::exact_cell_limit(sampler.tolerance) + 16);
      }
    }
    free_texture(texture);
  }
}

/// The parts of a footprint on the faces of a cube have at most twice as many cells, and an area.
void test_cube_cost(void**) {
  constexpr float kSides[] = {0, 1e-9f, 0.001f, 0.3f, -0.2f, 1, -3, 40, 1e10f, 3e38f, INFINITY};
  Texture* texture = random_texture(SHD_FORMAT_R8, 64, 64, true);
  texture->projection = SHD_PROJECTION_CUBE;
  Random random{9};
  for (int i = 0; i < 4000; ++i) {
    shd_sampler_desc desc = exact_desc(6);  // clamped
    desc.tolerance = ldexpf(1, -(i % 6));
    desc.lod_max = i % 3 ? 32 : 0;
    shd::texture::DirectionPoint point = {};
    *point.u = i % 5 ? static_cast<double>(random.real(0, 1)) : 1;
    *point.v = static_cast<double>(random.real(0, 1));
    *point.stretch = 1;
    *point.face = static_cast<uint64_t>(i % 6);
    for (auto& step : point.step) *step = static_cast<double>(kSides[random.next() % 11] * random.real(0.5f, 1));
    const auto f = shd::texture::exact_footprint(*texture, make_sampler(desc), {}, 0, &point);
    const double half = 32.0 / (1 << f.level);
    const shd::texture::Vec2 center = {static_cast<double>(f.x) + f.center.x, static_cast<double>(f.y) + f.center.y};
    CellCounter cells = {0, 0};
    for (uint32_t face = 0; face < 6; ++face) {
      const auto part = part_on_face(shd::texture::parallelogram(center, f.a, f.b), half, f.layer, face);
      assert_true(part.count <= 8);
      if (part.count > 2) visit_cells(part, &cells);
    }
    assert_true(cells.count <= 2 * shd::texture::exact_cell_limit(desc.tolerance));
    assert_true(cells.area > 0);
  }
  free_texture(texture);
}

/// Where a mip level replaces the base, the value is within the tolerance of the value from the base.
void test_tolerance(void**) {
  Texture* texture = random_texture(SHD_FORMAT_R8, 500, 512, true);
  Random random{21};
  t_batch.count = 48;
  for (size_t i = 0; i < t_batch.count; ++i) {
    t_batch.u[i] = random.real(0, 1);
    t_batch.v[i] = random.real(0, 1);
    t_batch.dudx[i] = random.real(-1, 1);
    t_batch.dvdx[i] = random.real(-1, 1);
    t_batch.dudy[i] = -t_batch.dvdx[i] * random.real(0.05f, 1);
    t_batch.dvdy[i] = t_batch.dudx[i] * random.real(0.05f, 1);
  }
  shd_sampler_desc desc = exact_desc(0);
  desc.tolerance = 0x1p-12f;
  run(*texture, make_sampler(desc), any_target(), t_batch.lookups(true, false), &t_batch);
  memcpy(&t_other, &t_batch, sizeof t_batch);
  for (int exponent = 1; exponent <= 7; ++exponent) {
    desc.tolerance = ldexpf(1, -exponent);
    run(*texture, make_sampler(desc), any_target(), t_batch.lookups(true, false), &t_batch);
    double worst = 0;
    for (size_t i = 0; i < t_batch.count; ++i) {
      worst = fmax(worst, fabs(static_cast<double>(t_batch.out[0][i]) - static_cast<double>(t_other.out[0][i])));
    }
    print_message("tolerance 2^-%d: error %.2g\n", exponent, worst);
    assert_true(worst <= static_cast<double>(desc.tolerance));
  }
  free_texture(texture);
}

/// A footprint between the centres of texels does not read texels beyond them.
void test_texels(void**) {
  float texels[64];
  for (size_t i = 0; i < 64; ++i) texels[i] = i % 8 == 6 ? NAN : i % 8 == 1 ? INFINITY : 2.5f;
  Texture* texture = make_texture(SHD_FORMAT_R32F, 8, 8, reinterpret_cast<uint8_t*>(texels), false);
  t_batch.count = 3;
  for (size_t i = 0; i < 3; ++i) {
    t_batch.u[i] = i == 0 ? 0.5f : i == 1 ? 0.6f : 0.4f;
    t_batch.v[i] = 0.4375f;
    t_batch.dudx[i] = t_batch.dvdy[i] = i == 0 ? 0.375f : 0.25f;  // from centre 2 to centre 5, or slightly off
    t_batch.dvdx[i] = t_batch.dudy[i] = 0;
    if (i > 0) t_batch.dudx[i] = 0.375f;
  }
  run(*texture, make_sampler(exact_desc(0)), any_target(), t_batch.lookups(true, false), &t_batch);
  assert_true(t_batch.out[0][0] == 2.5f);
  assert_true(isnan(t_batch.out[0][1]));
  assert_true(t_batch.out[0][2] == INFINITY);
  free_texture(texture);
}

/// Peak signal-to-noise ratio in dB at every 8th pixel in both directions of a 256 x 256 frame: a floor of depth 1 to
/// 20, against 64 x 64 samples per pixel of the projection itself.
double floor_quality(const Texture& texture, const shd_sampler_desc& desc) {
  ref::Level levels[shd::texture::kMaxLevels];
  const ref::Image image = oracle_image(texture, desc, levels);
  const auto depth = [](double y) { return 1 / (1.0 / 20 + (1 - 1.0 / 20) * y / 256); };
  const auto across = [&](double x, double y) { return 1.25 * (x / 256 - 0.5) * depth(y); };
  double sum = 0;
  t_batch.count = 32;
  for (int row = 0; row < 32; ++row) {
    const double y = 8 * row + 4.5, z = depth(y), slope = -z * z * (1 - 1.0 / 20) / 256;
    for (int column = 0; column < 32; ++column) {
      t_batch.u[column] = static_cast<float>(across(8 * column + 4.5, y));
      t_batch.v[column] = static_cast<float>(1.25 * z);
      t_batch.dudx[column] = static_cast<float>(1.25 * z / 256);
      t_batch.dvdx[column] = 0;
      t_batch.dudy[column] = static_cast<float>(across(8 * column + 4.5, y) / z * slope);
      t_batch.dvdy[column] = static_cast<float>(1.25 * slope);
    }
    run(texture, make_sampler(desc), any_target(), t_batch.lookups(true, false), &t_batch);
    for (int column = 0; column < 32; ++column) {
      double truth = 0;
      for (int k = 0; k < 64 * 64; ++k) {
        const double sub_x = 8 * column + 4 + (k % 64 + 0.5) / 64, sub_y = 8 * row + 4 + (k / 64 + 0.5) / 64;
        truth += ref::bilinear(image, 0, across(sub_x, sub_y), 1.25 * depth(sub_y), 0) / (64 * 64);
      }
      const double error = static_cast<double>(t_batch.out[0][column]) - truth;
      sum += error * error / (32 * 32);
    }
  }
  return -10 * log10(sum);
}

void test_floor(void**) {
  static uint8_t texels[512 * 512];
  for (const bool checker : {true, false}) {
    Random random{8};
    for (size_t i = 0; i < sizeof texels; ++i) {
      const auto noise = static_cast<uint8_t>(random.next() >> 24);
      texels[i] = checker ? ((i % 512 / 64 + i / 512 / 64) % 2 ? 255 : 0) : noise;
    }
    Texture* texture = make_texture(SHD_FORMAT_R8, 512, 512, texels, true);
    const double quality = floor_quality(*texture, exact_desc(0));
    print_message("%s floor: %.1f dB\n", checker ? "checker" : "noise", quality);
    assert_true(quality >= 45);
    free_texture(texture);
  }
}

}  // namespace

int main() {
  CMUnitTest tests[24];
  size_t n = add_sizes("exact", test_rectangles, tests);
  tests[n++] = {"lod", test_lod, nullptr, nullptr, nullptr};
  tests[n++] = {"parallelograms", test_parallelograms, nullptr, nullptr, nullptr};
  tests[n++] = {"ramp", test_ramp, nullptr, nullptr, nullptr};
  tests[n++] = {"points", test_points, nullptr, nullptr, nullptr};
  tests[n++] = {"hostile", test_hostile, nullptr, nullptr, nullptr};
  tests[n++] = {"cost", test_cost, nullptr, nullptr, nullptr};
  tests[n++] = {"cube_cost", test_cube_cost, nullptr, nullptr, nullptr};
  tests[n++] = {"tolerance", test_tolerance, nullptr, nullptr, nullptr};
  tests[n++] = {"texels", test_texels, nullptr, nullptr, nullptr};
  tests[n++] = {"floor", test_floor, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.exact", tests, n, nullptr, nullptr);
}
