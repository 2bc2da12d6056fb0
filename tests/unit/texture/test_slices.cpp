// SPDX-License-Identifier: MIT
// 3D textures: every filter against the oracle on every target, with all wraps, odd sizes, tails and inputs that are
// not finite; derivatives; levels; updates; the bits of 2D textures where there is one slice.
#include "solids.h"

namespace {

using namespace fixture;

SolidBatch t_batch, t_other;

/// Whether a value is that of a texel within the error of the position, on one of two levels.
bool is_near_texel(const ref::Solid& solid, const SolidSize& size, const int (&level)[2], const ref::Place& p, int c,
                   double got) {
  const double slack[] = {0, -1, 1};
  for (const int l : level) {
    for (int k = 0; k < 27; ++k) {
      const ref::Place moved = {4e-7 * size.width * slack[k % 3], 4e-7 * size.height * slack[k / 3 % 3],
                                4e-7 * size.depth * slack[k / 9]};
      if (shd_is_close(got, ref::nearest_on(solid, l, p, moved, c), 1.2e-7, 1.2e-7)) return true;
    }
  }
  return false;
}

/// Whether a value is a blend of texels of the two levels around a final level of detail, within the error of their
/// positions.
bool is_near_blend(const ref::Solid& solid, const SolidSize& size, double lod, const ref::Place& p, int c, double got,
                   double tolerance) {
  const double slack[] = {0, -4e-7, 4e-7}, s = lod - floor(lod);
  const int high = static_cast<int>(floor(lod)), low = high + 1 < solid.level_count ? high + 1 : high;
  const auto texel_at = [&](int level, int k) {
    return ref::nearest_on(solid, level, p,
                           {slack[k % 3] * size.width, slack[k / 3 % 3] * size.height, slack[k / 9] * size.depth}, c);
  };
  for (int k = 0; k < 27 * 27; ++k) {
    const double a = texel_at(high, k % 27);
    if (shd_is_close(got, s == 0 ? a : (1 - s) * a + s * texel_at(low, k / 27), tolerance, 0)) return true;
  }
  return false;
}

/// Whether a value is that of a filter, for the level of detail `lod` (of the probes for ANISOTROPIC).
bool matches(const ref::Solid& solid, const SolidSize& size, const ref::Place& p, const ref::Spread& s, double lod,
             int c, double got) {
  const shd_sampler_desc& sampler = *solid.sampler;
  const double m = fmax(magnitude(solid.format), 2), limit = static_cast<double>(sampler.max_anisotropy);
  const double linear = 3e-7 * m + 1.2e-6 * (size.width + size.height + size.depth) * m + 1e-6 * m;
  const double clamped = ref::clamp_lod(solid, lod);
  const int level[2] = {static_cast<int>(fmax(ceil(clamped + 0.5 - 2e-6) - 1, 0)),
                        static_cast<int>(fmin(fmax(ceil(clamped + 0.5 + 2e-6) - 1, 0), solid.level_count - 1))};
  switch (sampler.filter) {
    case SHD_FILTER_NEAREST: return is_near_texel(solid, size, {0, 0}, p, c, got);
    case SHD_FILTER_NEAREST_MIP: return is_near_texel(solid, size, level, p, c, got);
    case SHD_FILTER_NEAREST_MIP_LINEAR:
      return is_near_blend(solid, size, clamped, p, c, got, 4e-6 * m) ||
             is_near_blend(solid, size, ref::clamp_lod(solid, lod - 2e-6), p, c, got, 4e-6 * m) ||
             is_near_blend(solid, size, ref::clamp_lod(solid, lod + 2e-6), p, c, got, 4e-6 * m);
    case SHD_FILTER_BILINEAR: return shd_is_close(got, ref::linear(solid, 0, p, c), linear, 0);
    case SHD_FILTER_HERMITE: return shd_is_close(got, ref::hermite(solid, p, c), 1.5 * linear + 1e-6 * m, 0);
    case SHD_FILTER_BILINEAR_MIP:
      return shd_is_close(got, ref::linear(solid, level[0], p, c), linear, 0) ||
             shd_is_close(got, ref::linear(solid, level[1], p, c), linear, 0);
    case SHD_FILTER_BICUBIC:
      return shd_is_close(got, ref::tricubic(solid, p, c), m * (6e-6 + 8e-6 * (size.width + size.height + size.depth)),
                          0);
    case SHD_FILTER_TRILINEAR: return shd_is_close(got, ref::trilinear(solid, p, lod, c), linear + 4e-6 * m, 0);
    default: {
      const double ratio = s.a == 0 ? 1 : s.a > limit * s.b ? limit : s.a / s.b;
      const double bound = linear + 4e-6 * m + 4e-6 * limit * m;
      const int low = static_cast<int>(fmax(ceil(ratio - 0.125 - 1e-4), 1));
      const int high = static_cast<int>(fmax(ceil(ratio - 0.125 + 1e-4), 1));
      return shd_is_close(got, ref::anisotropic(solid, s, low, p, c), bound, 0) ||
             shd_is_close(got, ref::anisotropic(solid, s, high, p, c), bound, 0);
    }
  }
}

void check_solid(const Texture& texture, const SolidSize& size, const shd_sampler_desc& desc) {
  static float first[4][kMaxPoints + 64];
  ref::SolidLevel levels[shd::texture::kMaxLevels];
  const ref::Solid solid = oracle_solid(texture, desc, levels);
  bool is_first = true;
  for_each_target([&](int64_t target) {
    run(texture, make_sampler(desc), target, t_batch.places(true, false), &t_batch);
    if (is_first) memcpy(first, t_batch.out, sizeof first);
    is_first = false;
    assert_memory_equal(first, t_batch.out, sizeof first);
  });
  for (size_t i = 0; i < kPoints; ++i) {
    const ref::Spread s = spread_at(t_batch, size, i);
    for (int c = 0; c < 4; ++c) {
      const double got = static_cast<double>(t_batch.out[c][i]);
      if (matches(solid, size, place_of(t_batch, i), s, log2(s.a), c, got)) continue;
      fail_msg("filter %d, format %d, %s, point %zu, channel %d: got %.9g", desc.filter, texture.format, size.name, i,
               c, got);
    }
  }
}

void test_oracle(void** state) {
  const auto& size = *static_cast<const SolidSize*>(*state);
  const shd_filter filters[] = {SHD_FILTER_NEAREST,      SHD_FILTER_BILINEAR,           SHD_FILTER_NEAREST_MIP,
                                SHD_FILTER_BILINEAR_MIP, SHD_FILTER_TRILINEAR,          SHD_FILTER_ANISOTROPIC,
                                SHD_FILTER_BICUBIC,      SHD_FILTER_NEAREST_MIP_LINEAR, SHD_FILTER_HERMITE};
  make_places(&t_batch);
  uint32_t triple = 0;
  for (const shd_format format : kSolidFormats) {
    Texture* texture = random_solid(format, size);
    for (const shd_filter filter : filters) {
      for (int k = 0; k < 5; ++k) check_solid(*texture, size, solid_sampler(filter, triple++ * 7 % 25));
    }
    free_texture(texture);
  }
}

/// A 3D texture of one slice has the bits of the 2D texture, for any w.
void test_one_slice(void**) {
  const SolidSize size = {"", 37, 20, 1};
  make_places(&t_batch);
  for (size_t i = 0; i < kPoints; ++i) t_batch.dwdx[i] = t_batch.dwdy[i] = 0;
  for (const shd_format format : kSolidFormats) {
    uint8_t* texels = solid_texels(format, size, 5);
    Texture *solid = build_solid(solid_desc(format, size, texels)), *flat = make_texture(format, 37, 20, texels, true);
    assert_int_equal(solid->level_count, flat->level_count);
    assert_memory_equal(solid->texels.data(), flat->texels.data(), flat->texels.size());
    for (const shd_filter filter : {SHD_FILTER_NEAREST, SHD_FILTER_BILINEAR, SHD_FILTER_BICUBIC, SHD_FILTER_TRILINEAR,
                                    SHD_FILTER_NEAREST_MIP_LINEAR, SHD_FILTER_HERMITE}) {
      shd_sampler_desc desc = shd_sampler_desc_default();
      desc.filter = filter;
      desc.wrap_w = SHD_WRAP_MIRROR;
      for_each_target([&](int64_t target) {
        run(*solid, make_sampler(desc), target, t_batch.places(true, false), &t_batch);
        memcpy(&t_other, &t_batch, sizeof t_batch);
        run(*flat, make_sampler(desc), target, t_batch.lookups(true, false), &t_other);
        assert_memory_equal(t_batch.out, t_other.out, sizeof t_batch.out);
      });
    }
    free_texture(solid);
    free_texture(flat);
    free(texels);
  }
}

/// Every tail length gives the bits of the whole batch and writes nothing after it.
void test_tails(void**) {
  const SolidSize size = {"", 9, 6, 5};
  for (const shd_filter filter : {SHD_FILTER_NEAREST, SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC, SHD_FILTER_BICUBIC,
                                  SHD_FILTER_EWA, SHD_FILTER_NEAREST_MIP_LINEAR}) {
    Texture* texture = random_solid(SHD_FORMAT_RGBA8, size);
    const Sampler sampler = make_sampler(solid_sampler(filter, 3));
    make_places(&t_batch);
    for_each_target([&](int64_t target) {
      run(*texture, sampler, target, t_batch.places(true, false), &t_batch);
      memcpy(static_cast<void*>(&t_other), &t_batch, sizeof t_batch);
      for (size_t count = 0; count <= 35; ++count) {
        t_other.count = count;
        run(*texture, sampler, target, t_other.places(true, false), &t_other);
        for (size_t c = 0; c < 4; ++c) assert_memory_equal(t_other.out[c], t_batch.out[c], count * sizeof(float));
      }
    });
    free_texture(texture);
  }
}

/// Round footprints have the bits of trilinear; a constant texture gives exactly its value for every footprint.
void test_equal_bits(void**) {
  const SolidSize size = {"", 16, 16, 16};
  make_places(&t_batch);
  for (const shd_format format : kSolidFormats) {
    Texture* texture = random_solid(format, size);
    const Sampler probes = make_sampler(solid_sampler(SHD_FILTER_ANISOTROPIC, 7));
    const Sampler trilinear = make_sampler(solid_sampler(SHD_FILTER_TRILINEAR, 7));
    for_each_target([&](int64_t target) {
      run(*texture, probes, target, t_batch.places(false, true), &t_batch);
      memcpy(static_cast<void*>(&t_other), &t_batch, sizeof t_batch);
      run(*texture, trilinear, target, t_batch.places(false, true), &t_other);
      assert_memory_equal(t_batch.out, t_other.out, sizeof t_batch.out);
    });
    free_texture(texture);
    uint8_t* texels = solid_texels(format, size, 3);
    const size_t bytes = shd_format_size(format);
    for (size_t i = 1; i < 4096; ++i) memcpy(texels + i * bytes, texels, bytes);
    texture = build_solid(solid_desc(format, size, texels));
    shd_sampler_desc desc = solid_sampler(SHD_FILTER_ANISOTROPIC, 0);
    desc.wrap_v = desc.wrap_w = SHD_WRAP_CLAMP;
    for_each_target([&](int64_t target) {
      run(*texture, make_sampler(desc), target, t_batch.places(true, false), &t_batch);
      for (int c = 0; c < 4; ++c) {
        const auto want = static_cast<float>(ref::decode(format, texels, c));
        for (size_t i = 0; i < kPoints; ++i) assert_true(t_batch.out[c][i] == want);
      }
    });
    free_texture(texture);
    free(texels);
  }
}

/// Derivatives against differences of the oracle, away from its kinks; they do not change values.
void test_gradient(void**) {
  constexpr double kStep = 1e-4;  // texels
  const SolidSize size = {"", 16, 8, 4};
  static float slopes[3][4][kMaxPoints];
  Random random{5};
  t_batch.count = kPoints - 1;
  for (size_t i = 0; i < kPoints; ++i) {
    t_batch.u[i] = (floorf(random.real(-20, 30)) + random.real(0.55f, 0.95f)) / 16;
    t_batch.v[i] = (floorf(random.real(-10, 20)) + random.real(0.55f, 0.95f)) / 8;
    t_batch.w[i] = (floorf(random.real(-6, 9)) + random.real(0.55f, 0.95f)) / 4;
    t_batch.lod[i] = i % 2 ? 0.0f : 0.75f;
  }
  for (const shd_format format : kSolidFormats) {
    Texture* texture = random_solid(format, size);
    for (const shd_filter filter :
         {SHD_FILTER_BILINEAR, SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC, SHD_FILTER_BICUBIC, SHD_FILTER_HERMITE}) {
      const shd_sampler_desc desc = solid_sampler(filter, 5 * (filter % 4) + 1);
      ref::SolidLevel levels[shd::texture::kMaxLevels];
      const ref::Solid solid = oracle_solid(*texture, desc, levels);
      const auto value = [&](size_t i, int axis, double step, int c) {
        ref::Place p = place_of(t_batch, i);
        (axis == 0 ? p.u : axis == 1 ? p.v : p.w) += step / (axis == 0 ? 16 : axis == 1 ? 8 : 4);
        return filter == SHD_FILTER_BILINEAR  ? ref::linear(solid, 0, p, c)
               : filter == SHD_FILTER_BICUBIC ? ref::tricubic(solid, p, c)
               : filter == SHD_FILTER_HERMITE ? ref::hermite(solid, p, c)
                                              : ref::trilinear(solid, p, static_cast<double>(t_batch.lod[i]), c);
      };
      for_each_target([&](int64_t target) {
        const auto simd = shd::core::simd_target_from_bit(target);
        run(*texture, make_sampler(desc), target, t_batch.places(false, true), &t_other);
        Texels out = {};
        for (int c = 0; c < 4; ++c) {
          out.channel[c] = t_batch.out[c];
          out.du[c] = slopes[0][c];
          out.dv[c] = slopes[1][c];
          out.dw[c] = slopes[2][c];
        }
        shd::texture::sample(*texture, make_sampler(desc), simd, t_batch.places(false, true), out);
        for (int c = 0; c < 4; ++c) {
          assert_memory_equal(t_batch.out[c], t_other.out[c], t_batch.count * sizeof(float));
          for (size_t i = 0; i < t_batch.count; ++i) {
            for (int axis = 0; axis < 3; ++axis) {
              const double forward = value(i, axis, kStep, c) - value(i, axis, 0, c);
              const double backward = value(i, axis, 0, c) - value(i, axis, -kStep, c);
              const double n = axis == 0 ? 16 : axis == 1 ? 8 : 4, m = magnitude(format) + 2;
              if (fabs(forward - backward) > 1e-7 * m) continue;  // a kink of a level within the step
              shd_assert_close("slope", i, static_cast<double>(slopes[axis][c][i]), forward / kStep * n, 4e-4 * n * m,
                               0);
            }
          }
        }
      });
    }
    free_texture(texture);
  }
}

/// Levels are box averages, and updates give the bits of a new texture.
void test_levels(void** state) {
  const auto& size = *static_cast<const SolidSize*>(*state);
  const shd_sampler_desc sampler = shd_sampler_desc_default();
  for (const shd_format format : kSolidFormats) {
    uint8_t* texels = solid_texels(format, size, 17);
    Texture* texture = build_solid(solid_desc(format, size, texels));
    ref::SolidLevel levels[shd::texture::kMaxLevels];
    const ref::Solid solid = oracle_solid(*texture, sampler, levels);
    const size_t bytes = shd_format_size(format);
    assert_memory_equal(levels[0].texels, texels, size_t{size.width} * size.height * size.depth * bytes);
    const bool half = format == SHD_FORMAT_RGBA16F;
    const double bound = half                              ? 1e-3
                         : format == SHD_FORMAT_RGBA8_SRGB ? 0.005
                         : format == SHD_FORMAT_RG16       ? 8e-6
                                                           : 0.002;
    for (int l = 1; l < solid.level_count; ++l) {
      const ref::SolidLevel& to = levels[l];
      for (int64_t i = 0; i < to.width * to.height * to.depth; ++i) {
        for (int c = 0; c < ref::layout(format).channels; ++c) {
          const double want = ref::box(solid, l, i % to.width, i / to.width % to.height, i / to.width / to.height, c);
          const double got = ref::decode(format, to.texels + static_cast<size_t>(i) * bytes, c);
          const bool exact = shd::image::format_info(format).component == Component::kFloat32;
          shd_assert_close(size.name, static_cast<size_t>(i), got, want, exact ? 1e-6 : bound, exact ? 1e-6 : 0);
        }
      }
    }
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t z = size.depth * k / 3, x = size.width * k / 4, y = size.height / 2;
      shd_image image = shd_image_default();
      image.format = format;
      image.width = size.width - x;
      image.height = size.height - y;
      image.row_stride = size.width * bytes;
      uint8_t* changed = texels + ((size_t{z} * size.height + y) * size.width + x) * bytes;
      uint8_t pixel[16];
      random_texels(format, 1, k + 50, pixel);
      memcpy(changed, pixel, bytes);
      image.pixels = changed;
      shd::texture::update(*context(), z, x, y, image, texture);
      Texture* made = build_solid(solid_desc(format, size, texels));
      assert_memory_equal(made->texels.data(), texture->texels.data(), made->texels.size());
      free_texture(made);
    }
    free_texture(texture);
    free(texels);
  }
}

/// Borrowed texels and levels of the caller give the bits of copied ones.
void test_sources(void**) {
  const SolidSize size = {"", 20, 12, 6};
  make_places(&t_batch);
  uint8_t* texels = solid_texels(SHD_FORMAT_RGBA8, size, 9);
  Texture* copied = build_solid(solid_desc(SHD_FORMAT_RGBA8, size, texels));
  shd_texture_desc desc = solid_desc(SHD_FORMAT_RGBA8, size, texels);
  desc.flags = SHD_TEXTURE_BORROW;
  Texture* borrowed = build_solid(desc);
  desc.flags = 0;
  shd_image images[3 + 1 + 1];
  size_t count = 0;
  for (uint32_t l = 1; l < 3; ++l) {
    for (uint32_t z = 0; z < (6u >> l); ++z, ++count) {
      images[count] = shd_image_default();
      images[count].format = SHD_FORMAT_RGBA8;
      images[count].width = 20u >> l;
      images[count].height = 12u >> l;
      images[count].pixels = shd::texture::row_of(*copied, z, l, 0);
    }
  }
  desc.level_images = images;
  desc.level_count = 2;
  Texture* given = build_solid(desc);
  assert_int_equal(given->level_count, 3);
  shd_sampler_desc sampler = shd_sampler_desc_default();
  sampler.lod_max = 2;
  for_each_target([&](int64_t target) {
    run(*copied, make_sampler(sampler), target, t_batch.places(true, false), &t_batch);
    memcpy(static_cast<void*>(&t_other), &t_batch, sizeof t_batch);
    for (const Texture* texture : {borrowed, given}) {
      run(*texture, make_sampler(sampler), target, t_batch.places(true, false), &t_other);
      assert_memory_equal(t_batch.out, t_other.out, sizeof t_batch.out);
    }
  });
  free_texture(copied);
  free_texture(borrowed);
  free_texture(given);
  free(texels);
}

/// Coordinates that are not finite count as 0, NaN derivatives as 0, infinite ones as the coarsest level.
void test_nonfinite(void**) {
  const SolidSize size = {"", 8, 8, 8};
  const float bad[] = {NAN, INFINITY, -INFINITY};
  Texture* texture = random_solid(SHD_FORMAT_RGBA32F, size);
  const shd_sampler_desc desc = solid_sampler(SHD_FILTER_TRILINEAR, 0);
  make_places(&t_batch);
  t_batch.count = 9;
  for (size_t i = 0; i < 9; ++i) {
    float* const columns[] = {t_batch.w, t_batch.dwdx, t_batch.dwdy};
    t_batch.dudx[i] = t_batch.dvdx[i] = t_batch.dudy[i] = t_batch.dvdy[i] = 0.25f;
    t_batch.u[i] = t_batch.v[i] = t_batch.w[i] = 0.3f;
    t_batch.dwdx[i] = t_batch.dwdy[i] = 0;
    columns[i / 3][i] = bad[i % 3];
  }
  memcpy(static_cast<void*>(&t_other), &t_batch, sizeof t_batch);
  for (size_t i = 0; i < 9; ++i) {
    if (i < 3) t_other.w[i] = 0;
    if (i == 3) t_other.dwdx[i] = 0;
    if (i == 6) t_other.dwdy[i] = 0;
    if (i > 3 && i != 6) t_other.dudx[i] = 1e30f;
  }
  for_each_target([&](int64_t target) {
    assert_int_equal(run(*texture, make_sampler(desc), target, t_batch.places(true, false), &t_batch), 9);
    run(*texture, make_sampler(desc), target, t_other.places(true, false), &t_other);
    for (size_t c = 0; c < 4; ++c) assert_memory_equal(t_batch.out[c], t_other.out[c], 9 * sizeof(float));
  });
  free_texture(texture);
}

}  // namespace

int main() {
  static char names[2][6][32];
  CMUnitTest tests[32];
  size_t n = 0;
  for (size_t i = 0; i < 6; ++i) {
    snprintf(names[0][i], sizeof names[0][i], "oracle/%s", kSolidSizes[i].name);
    snprintf(names[1][i], sizeof names[1][i], "levels/%s", kSolidSizes[i].name);
    tests[n++] = {names[0][i], test_oracle, nullptr, nullptr, const_cast<SolidSize*>(&kSolidSizes[i])};
    if (i < 5) tests[n++] = {names[1][i], test_levels, nullptr, nullptr, const_cast<SolidSize*>(&kSolidSizes[i])};
  }
  tests[n++] = {"one_slice", test_one_slice, nullptr, nullptr, nullptr};
  tests[n++] = {"tails", test_tails, nullptr, nullptr, nullptr};
  tests[n++] = {"equal_bits", test_equal_bits, nullptr, nullptr, nullptr};
  tests[n++] = {"gradient", test_gradient, nullptr, nullptr, nullptr};
  tests[n++] = {"sources", test_sources, nullptr, nullptr, nullptr};
  tests[n++] = {"nonfinite", test_nonfinite, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.slices", tests, n, nullptr, nullptr);
}
