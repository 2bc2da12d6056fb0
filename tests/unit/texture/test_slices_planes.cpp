// SPDX-License-Identifier: MIT
// Filters of 3D textures beside those of 2D textures: equal slices give the values of one slice, permuted axes permute
// the results, and constants stay exactly constant.
#include "filter_cases.h"
#include "solids.h"

namespace {

using namespace fixture;

SolidBatch t_batch, t_other;

constexpr shd_filter kFilters[] = {SHD_FILTER_BICUBIC, SHD_FILTER_EWA, SHD_FILTER_EXACT};

double bound(shd_filter filter, double m, double sizes) {
  if (filter == SHD_FILTER_EXACT) return 2e-6 * m;
  return m * (filter == SHD_FILTER_BICUBIC ? 6e-6 + 8e-6 * sizes : 6e-5 + 8e-6 * sizes + 8e-6 * 16);
}

/// Footprints along slices of 24 x 24 texels, at most 20 times longer than wide, around centres of slices.
void make_flat_places(uint32_t depth) {
  make_places(&t_batch);
  Random random{31};
  for (size_t i = 0; i < kPoints; ++i) {
    const float angle = random.real(0, 7), longer = exp2f(random.real(-2, 5)) / 24,
                shorter = longer * random.real(0.05f, 1);
    t_batch.w[i] = (floorf(random.real(-9, 9)) + 0.5f) / static_cast<float>(depth);
    t_batch.dudx[i] = longer * cosf(angle);
    t_batch.dvdx[i] = longer * sinf(angle);
    t_batch.dudy[i] = -shorter * sinf(angle);
    t_batch.dvdy[i] = shorter * cosf(angle);
    t_batch.dwdx[i] = t_batch.dwdy[i] = 0;
  }
}

/// EWA weights slices by their distance, so its texture has one slice.
void test_equal_slices(void**) {
  for (const shd_filter filter : kFilters) {
    const SolidSize size = {"", 24, 24, filter == SHD_FILTER_EWA ? 1u : 5u};
    make_flat_places(size.depth);
    for (const shd_format format : kSolidFormats) {
      uint8_t* texels = solid_texels(format, size, 5);
      const size_t slice = size_t{24} * 24 * shd_format_size(format);
      for (uint32_t z = 1; z < size.depth; ++z) memcpy(texels + z * slice, texels, slice);
      Texture *solid = build_solid(solid_desc(format, size, texels)),
              *flat = make_texture(format, 24, 24, texels, true);
      for (uint32_t triple = 0; triple < 25; triple += 3) {
        shd_sampler_desc desc = solid_sampler(filter, triple);
        if (desc.wrap_w == SHD_WRAP_BORDER) desc.wrap_w = SHD_WRAP_CLAMP;
        if (filter == SHD_FILTER_EWA) desc.max_anisotropy = 16;
        run_everywhere(*solid, desc, t_batch.places(true, false), &t_batch);
        memcpy(static_cast<void*>(&t_other), &t_batch, sizeof t_batch);
        run_everywhere(*flat, desc, t_batch.lookups(true, false), &t_other);
        for (int c = 0; c < 4; ++c) {
          for (size_t i = 0; i < kPoints; ++i) {
            shd_assert_close("equal slices", i, static_cast<double>(t_batch.out[c][i]),
                             static_cast<double>(t_other.out[c][i]), bound(filter, fmax(magnitude(format), 2), 53), 0);
          }
        }
      }
      free_texture(solid);
      free_texture(flat);
      free(texels);
    }
  }
}

/// (u, v, w) become (v, w, u), and the texels with them.
void test_permuted_axes(void**) {
  const SolidSize size = {"", 12, 7, 20}, turned = {"", 7, 20, 12};
  for (const shd_format format : {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA32F}) {
    const size_t bytes = shd_format_size(format);
    uint8_t *texels = solid_texels(format, size, 8), *other = solid_texels(format, turned, 8);
    for (uint32_t n = 0; n < 12 * 7 * 20; ++n) {
      const uint32_t x = n % 12, y = n / 12 % 7, z = n / 84;
      memcpy(other + ((x * 20 + z) * 7 + y) * bytes, texels + n * bytes, bytes);
    }
    Texture *first = build_solid(solid_desc(format, size, texels)),
            *second = build_solid(solid_desc(format, turned, other));
    for (const shd_filter filter : kFilters) {
      for (uint32_t triple = 0; triple < 25; triple += 4) {
        shd_sampler_desc desc = solid_sampler(filter, triple);
        make_places(&t_batch);
        memcpy(static_cast<void*>(&t_other), &t_batch, sizeof t_batch);
        run(*first, make_sampler(desc), hwy::SupportedAndGeneratedTargets()[0], t_batch.places(true, false), &t_batch);
        const auto turn = [](float* u, float* v, float* w) {
          for (size_t i = 0; i < kPoints; ++i) {
            const float was = u[i];
            u[i] = v[i], v[i] = w[i], w[i] = was;
          }
        };
        turn(t_other.u, t_other.v, t_other.w);
        turn(t_other.dudx, t_other.dvdx, t_other.dwdx);
        turn(t_other.dudy, t_other.dvdy, t_other.dwdy);
        const shd_wrap wrap_u = desc.wrap_u;
        desc.wrap_u = desc.wrap_v, desc.wrap_v = desc.wrap_w, desc.wrap_w = wrap_u;
        run(*second, make_sampler(desc), hwy::SupportedAndGeneratedTargets()[0], t_other.places(true, false), &t_other);
        size_t different = 0;
        for (int c = 0; c < 4; ++c) {
          for (size_t i = 0; i < kPoints; ++i) {
            const double got = static_cast<double>(t_batch.out[c][i]), want = static_cast<double>(t_other.out[c][i]);
            different += !shd_is_close(got, want, bound(filter, fmax(magnitude(format), 2), 39), 0);
          }
        }
        // Rounding chooses the level of a few footprints of EWA.
        assert_true(different <= (filter == SHD_FILTER_EWA ? 8u : 0u));
      }
    }
    free_texture(first);
    free_texture(second);
    free(texels);
    free(other);
  }
}

void test_constant(void**) {
  const SolidSize size = {"", 9, 16, 6};
  make_places(&t_batch);
  for (const shd_format format : kSolidFormats) {
    uint8_t* texels = solid_texels(format, size, 3);
    const size_t bytes = shd_format_size(format);
    for (size_t i = 1; i < 9 * 16 * 6; ++i) memcpy(texels + i * bytes, texels, bytes);
    Texture* texture = build_solid(solid_desc(format, size, texels));
    for (const shd_filter filter : {SHD_FILTER_BICUBIC, SHD_FILTER_EWA, SHD_FILTER_EXACT, SHD_FILTER_STOCHASTIC}) {
      for (const shd_wrap wrap : {SHD_WRAP_REPEAT, SHD_WRAP_CLAMP, SHD_WRAP_MIRROR, SHD_WRAP_MIRROR_ONCE}) {
        for (const bool lod : {false, true}) {
          shd_sampler_desc desc = solid_sampler(filter, 1);
          desc.wrap_u = desc.wrap_v = desc.wrap_w = wrap;
          run_everywhere(*texture, desc, t_batch.places(!lod, lod), &t_batch);
          for (int c = 0; c < 4; ++c) {
            const auto want = static_cast<float>(ref::decode(format, texels, c));
            for (size_t i = 0; i < kPoints; ++i) assert_true(t_batch.out[c][i] == want);
          }
        }
      }
    }
    free_texture(texture);
    free(texels);
  }
}

/// Hostile derivatives give finite values within the range of the texels.
void test_hostile_footprints(void**) {
  const SolidSize size = {"", 33, 8, 17};
  const float hostile[] = {0,     1e-45f, 1e-30f, 1e-8f, 0.03f,    1,         1e8f, 1e30f, 3.4e38f,
                           -1e8f, -3e38f, -0.03f, NAN,   INFINITY, -INFINITY, 2,    -1};
  constexpr size_t kHostile = sizeof hostile / sizeof hostile[0];
  Texture* texture = random_solid(SHD_FORMAT_RGBA8, size);
  Random random{17};
  make_places(&t_batch);
  for (size_t i = 0; i < kPoints; ++i) {
    for (float* column :
         {t_batch.dudx, t_batch.dvdx, t_batch.dwdx, t_batch.dudy, t_batch.dvdy, t_batch.dwdy, t_batch.lod}) {
      column[i] = hostile[random.next() % kHostile];
    }
  }
  for (const shd_filter filter : {SHD_FILTER_BICUBIC, SHD_FILTER_EWA, SHD_FILTER_EXACT, SHD_FILTER_STOCHASTIC}) {
    for (uint32_t triple = 0; triple < 25; triple += 6) {
      for (const bool lod : {false, true}) {
        shd_sampler_desc desc = solid_sampler(filter, triple);
        desc.stochastic_filter = SHD_FILTER_EWA;
        desc.cubic = SHD_CUBIC_B_SPLINE;
        desc.tolerance = 1;
        desc.max_anisotropy = 64;
        run_everywhere(*texture, desc, t_batch.places(!lod, lod), &t_batch);
        for (int c = 0; c < 4; ++c) {
          const float border = desc.border[c];
          for (size_t i = 0; i < kPoints; ++i) {
            assert_true(t_batch.out[c][i] >= fminf(border, 0) - 1e-5f && t_batch.out[c][i] <= fmaxf(border, 1) + 1e-5f);
          }
        }
      }
    }
  }
  free_texture(texture);
}

/// A NaN texel without weight has no effect: around the middle of slice 4, of row 4 and of column 4.
void test_nonfinite_texels(void**) {
  static float texels[9 * 9 * 9];
  for (size_t i = 0; i < 9 * 9 * 9; ++i) texels[i] = i % 9 == 0 || i / 9 % 9 == 0 || i / 81 == 0 ? NAN : 2.5f;
  Texture* texture = build_solid(solid_desc(SHD_FORMAT_R32F, {"", 9, 9, 9}, reinterpret_cast<uint8_t*>(texels)));
  make_places(&t_batch);
  for (size_t i = 0; i < kPoints; ++i) {
    t_batch.u[i] = t_batch.v[i] = t_batch.w[i] = 0.5f;
    for (float* column : {t_batch.dudx, t_batch.dvdx, t_batch.dwdx, t_batch.dudy, t_batch.dvdy, t_batch.dwdy}) {
      column[i] = fminf(fmaxf(column[i], -0.1f), 0.1f);  // at most 0.9 texels
    }
  }
  for (const shd_filter filter : {SHD_FILTER_BICUBIC, SHD_FILTER_EWA, SHD_FILTER_EXACT, SHD_FILTER_STOCHASTIC}) {
    shd_sampler_desc desc = solid_sampler(filter, 0);
    desc.lod_max = 0;
    run_everywhere(*texture, desc, t_batch.places(true, false), &t_batch);
    for (size_t i = 0; i < kPoints; ++i) assert_true(t_batch.out[0][i] == 2.5f);
  }
  free_texture(texture);
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(test_equal_slices), cmocka_unit_test(test_permuted_axes),
                              cmocka_unit_test(test_constant), cmocka_unit_test(test_hostile_footprints),
                              cmocka_unit_test(test_nonfinite_texels)};
  return _cmocka_run_group_tests("unit.texture.slices_planes", tests, sizeof tests / sizeof tests[0], nullptr, nullptr);
}
