// SPDX-License-Identifier: MIT
// Summed-area lookups: every format x wrap pair x box x size against the oracle, equal bits on every target; tails,
// layers, constants, hostile footprints, non-finite texels, magnification.
#include "summed_area_fixture.h"

namespace {

using namespace fixture;

Batch t_batch, t_other;

/// Footprints from 2^-6 to `texels` texels, sheared and rotated; some along the axes.
void make_footprints(Batch* batch, size_t count, float texels, uint32_t width, uint32_t height) {
  Random random{width * 7 + height};
  make_points(batch);
  const size_t skipped = kPoints - count;
  batch->count = count;
  for (size_t i = 0; i < count; ++i) {
    batch->u[i] = batch->u[i + skipped];
    batch->v[i] = batch->v[i + skipped];
    const float w = static_cast<float>(width), h = static_cast<float>(height);
    const float scale = texels * ldexpf(1, -static_cast<int>(i % 12)), thin = ldexpf(1, -static_cast<int>(i / 12 % 4));
    batch->dudx[i] = scale * random.real(-1, 1) / w;
    batch->dvdx[i] = scale * random.real(-1, 1) / h;
    batch->dudy[i] = thin * scale * random.real(-1, 1) / w;
    batch->dvdy[i] = thin * scale * random.real(-1, 1) / h;
    if (i % 5 == 0) batch->dvdx[i] = batch->dudy[i] = 0;
    batch->lod[i] = random.real(-2, log2f(texels));
  }
}

ref::Jacobian jacobian_at(const Batch& batch, size_t i, const shd_sampler_desc& s, bool lod, double w, double h) {
  if (lod) {
    const double side = exp2(static_cast<double>(batch.lod[i] + s.lod_bias));
    return {side, 0, 0, side};
  }
  const ref::Jacobian given = {static_cast<double>(batch.dudx[i]), static_cast<double>(batch.dvdx[i]),
                               static_cast<double>(batch.dudy[i]), static_cast<double>(batch.dvdy[i])};
  return ref::box_sides(given, s, w, h);
}

/// Numbers of parts, and orders of the sides, between which rounding may decide.
size_t choices(const ref::Jacobian& j, const shd_sampler_desc& s, bool lod, ref::Jacobian* sides, int* counts) {
  const double a = hypot(j.ux, j.vx), b = hypot(j.uy, j.vy);
  size_t n = 0;
  for (const bool swapped : {false, true}) {
    if (swapped ? b < a * (1 - 1e-6) : a < b * (1 - 1e-6)) continue;
    sides[n] = swapped ? ref::Jacobian{j.uy, j.vy, j.ux, j.vx} : j;
    counts[n] = 1;
    if (lod || s.box == SHD_BOX_BOUNDING) return 1;
    const double ratio = ref::box_ratio(sides[n]), maximum = floor(static_cast<double>(s.max_anisotropy));
    const int low = static_cast<int>(fmin(fmax(ceil(ratio * (1 - 1e-6)), 1), maximum));
    const int high = static_cast<int>(fmin(fmax(ceil(ratio * (1 + 1e-6)), 1), maximum));
    counts[n++] = low;
    if (high == low) continue;
    sides[n] = sides[n - 1];
    counts[n++] = high;
  }
  return n;
}

void check_points(const Texture& texture, const double* values, const shd_sampler_desc& desc, bool lod) {
  const double m = fmax(magnitude(texture.format), 2);
  const ref::SummedTexels t = {values, texture.width, texture.height, ref::layout(texture.format).channels, &desc};
  for (size_t i = 0; i < t_batch.count; ++i) {
    ref::Jacobian sides[4];
    int counts[4];
    const ref::Jacobian j = jacobian_at(t_batch, i, desc, lod, texture.width, texture.height);
    const size_t n = choices(j, desc, lod, sides, counts);
    bool ok = false;
    ref::BoxesAverage want = {};
    for (size_t k = 0; k < n && !ok; ++k) {
      want = ref::boxes_average(t, static_cast<double>(t_batch.u[i]), static_cast<double>(t_batch.v[i]), sides[k],
                                counts[k]);
      ok = true;
      for (int c = 0; c < 4; ++c) {
        const double got = static_cast<double>(t_batch.out[c][i]);
        ok = ok && shd_is_close(got, want.value[c], m * (5e-7 + 2e-6 * want.edges), 0);
      }
    }
    if (ok) continue;
    fail_msg(
        "%ux%u format %d wraps %d %d box %d point %zu (%.9g, %.9g): got %.9g %.9g %.9g %.9g, want %.9g %.9g %.9g %.9g",
        texture.width, texture.height, static_cast<int>(texture.format), static_cast<int>(desc.wrap_u),
        static_cast<int>(desc.wrap_v), static_cast<int>(desc.box), i, static_cast<double>(t_batch.u[i]),
        static_cast<double>(t_batch.v[i]), static_cast<double>(t_batch.out[0][i]),
        static_cast<double>(t_batch.out[1][i]), static_cast<double>(t_batch.out[2][i]),
        static_cast<double>(t_batch.out[3][i]), want.value[0], want.value[1], want.value[2], want.value[3]);
  }
}

void test_size(void** state) {
  const auto& size = *static_cast<const SizeCase*>(*state);
  const bool large = size.width * size.height > 1 << 14;
  make_footprints(&t_batch, large ? 24 : 60, large ? 60.0f : 40.0f, size.width, size.height);
  for (const shd_format format : kFormats) {
    Texture* texture = random_summed(format, size.width, size.height, 1);
    const double* values = oracle_values(*texture, 0);
    for (uint32_t pair = 0; pair < 25; ++pair) {
      for (const shd_box box : {SHD_BOX_BOUNDING, SHD_BOX_ORIENTED}) {
        const shd_sampler_desc desc = summed_desc(pair, box);
        run_everywhere(*texture, desc, t_batch.lookups(true, false), &t_batch);
        check_points(*texture, values, desc, false);
      }
    }
    free_texture(texture);
  }
}

/// Boxes of many periods, and boxes wider than any margin.
void test_wide(void**) {
  for (const auto& size : {SizeCase{"", 5, 3}, SizeCase{"", 1, 7}, SizeCase{"", 64, 64}}) {
    for (const shd_format format : {SHD_FORMAT_RG8, SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA32F}) {
      make_footprints(&t_batch, 24, 4096, size.width, size.height);
      for (size_t i = 0; i < 2; ++i) t_batch.dudx[i] = 0x1p20f / static_cast<float>(size.width);
      Texture* texture = random_summed(format, size.width, size.height, 1);
      const double* values = oracle_values(*texture, 0);
      for (uint32_t pair = 0; pair < 25; ++pair) {
        const shd_sampler_desc desc = summed_desc(pair, pair % 2 ? SHD_BOX_BOUNDING : SHD_BOX_ORIENTED);
        run_everywhere(*texture, desc, t_batch.lookups(true, false), &t_batch);
        check_points(*texture, values, desc, false);
      }
      free_texture(texture);
    }
  }
}

/// A given level of detail; bias, clamps, width, blur and the number of parts.
void test_settings(void**) {
  Texture* texture = random_summed(SHD_FORMAT_RGBA8, 64, 32, 1);
  const double* values = oracle_values(*texture, 0);
  for (uint32_t setting = 0; setting < 10; ++setting) {
    for (uint32_t pair = 0; pair < 25; ++pair) {
      shd_sampler_desc desc = summed_desc(pair, setting % 2 ? SHD_BOX_ORIENTED : SHD_BOX_BOUNDING);
      make_footprints(&t_batch, 40, 40, 64, 32);
      if (setting == 2 || setting == 3) desc.lod_bias = 1.5f;
      if (setting == 4 || setting == 5) desc.lod_bias = -2.0f;
      if (setting == 6) desc.lod_min = 2.5f;
      if (setting == 7) desc.lod_max = 3.25f;
      if (setting >= 8) desc.width_x = 0.5f;
      if (setting == 9) desc.max_anisotropy = 3.75f;
      const bool lod = setting % 4 == 0;
      run_everywhere(*texture, desc, t_batch.lookups(true, lod), &t_batch);
      check_points(*texture, values, desc, lod);
      if (lod) continue;
      desc.blur_u = 0.05f;
      desc.blur_v = 0.125f;
      run_everywhere(*texture, desc, t_batch.lookups(true, false), &t_batch);
      check_points(*texture, values, desc, false);
    }
  }
  free_texture(texture);
}

/// A footprint that is no longer than a texel is looked up bilinearly.
void test_magnified(void**) {
  make_points(&t_batch);
  for (const shd_format format : kFormats) {
    Texture* texture = random_summed(format, 13, 9, 1);
    for (uint32_t pair = 0; pair < 25; ++pair) {
      const shd_sampler_desc desc = summed_desc(pair, SHD_BOX_ORIENTED);
      shd_sampler_desc bilinear = desc;
      bilinear.filter = SHD_FILTER_BILINEAR;
      run_everywhere(*texture, bilinear, t_batch.lookups(false, false), &t_batch);
      memcpy(&t_other, &t_batch, sizeof t_batch);
      for (const bool lod : {false, true}) {
        for (size_t i = 0; i < kPoints; ++i) t_batch.lod[i] = -static_cast<float>(i);
        run(*texture, make_sampler(desc), hwy::SupportedAndGeneratedTargets().front(), t_batch.lookups(false, lod),
            &t_batch);
        for (size_t i = 0; i < kPoints; ++i) {
          for (int c = 0; c < 4; ++c) {
            const double want = static_cast<double>(t_other.out[c][i]);
            const double tolerance = fmax(magnitude(format), 2) * (1e-6 + 5e-6 * (13 + 9));
            shd_assert_close("magnified", i, static_cast<double>(t_batch.out[c][i]), want, tolerance, 0);
          }
        }
      }
    }
    free_texture(texture);
  }
}

void test_tails(void**) {
  for (const shd_format format : kFormats) {
    Texture* texture = random_summed(format, 64, 32, 1);
    const shd_sampler_desc desc = summed_desc(5, SHD_BOX_ORIENTED);
    check_tails(*texture, desc, true);
    check_unwanted_channels(*texture, desc);
    free_texture(texture);
  }
}

/// Layers are looked up separately; indices beyond the last layer use the last.
void test_layers(void**) {
  constexpr uint32_t kLayers = 3;
  static uint32_t layer[kMaxPoints];
  for (const shd_format format : {SHD_FORMAT_RGBA8, SHD_FORMAT_RG16}) {
    Texture* texture = random_summed(format, 17, 12, kLayers);
    const shd_sampler_desc desc = summed_desc(0, SHD_BOX_BOUNDING);
    make_footprints(&t_batch, 60, 20, 17, 12);
    for (uint32_t k = 0; k < kLayers + 1; ++k) {
      for (uint32_t& l : layer) l = k == kLayers ? 0xffffffffu : k;
      Lookups lookups = t_batch.lookups(true, false);
      lookups.layer = layer;
      run_everywhere(*texture, desc, lookups, &t_batch);
      check_points(*texture, oracle_values(*texture, k < kLayers ? k : kLayers - 1), desc, false);
    }
    free_texture(texture);
  }
}

/// Finite texels give values between the smallest and the largest; a constant texture gives exactly its value.
void test_hostile(void**) {
  make_hostile_points(&t_batch);
  for (const bool constant : {false, true}) {
    uint8_t texels[23 * 9 * 16];
    for (const shd_format format : kFormats) {
      random_texels(format, 23 * 9, 4242, texels);
      if (constant) constant_texels(format, 23 * 9, texels);
      Texture* texture = build_summed(*context(), format, 23, 9, 1, texels);
      for (uint32_t pair = 0; pair < 50; ++pair) {
        shd_sampler_desc desc = summed_desc(pair % 25, pair < 25 ? SHD_BOX_BOUNDING : SHD_BOX_ORIENTED);
        for (int c = 0; c < 4; ++c) desc.border[c] = static_cast<float>(ref::decode(format, texels, c));
        desc.lod_bias = static_cast<float>(static_cast<int>(pair % 5)) * 7 - 14;
        desc.width_x = pair % 3 ? 1.0f : 0.0f;
        desc.blur_v = pair % 7 ? 0.0f : 0.5f;
        run_everywhere(*texture, desc, t_batch.lookups(pair % 2 == 0, pair % 2 == 1), &t_batch);
        for (int c = 0; c < 4; ++c) {
          const bool missing = c >= ref::layout(format).channels;
          const double maximum = constant || missing ? 0 : magnitude(format) * 1.00001;
          const double around = constant || missing ? static_cast<double>(desc.border[c]) : 0;
          for (size_t i = 0; i < kMaxPoints; ++i) {
            shd_assert_close("hostile", i, static_cast<double>(t_batch.out[c][i]), around, maximum, 0);
          }
        }
      }
      free_texture(texture);
    }
  }
}

/// Every code of a constant texture is reproduced for any box.
void test_codes(void**) {
  uint8_t texels[7 * 5 * 2];
  make_points(&t_batch);
  for (const shd_format format : {SHD_FORMAT_R8, SHD_FORMAT_R8_SRGB, SHD_FORMAT_R16}) {
    for (uint32_t code = 0; code < 256; ++code) {
      for (uint8_t& texel : texels) texel = static_cast<uint8_t>(code);
      Texture* texture = build_summed(*context(), format, 7, 5, 1, texels);
      shd_sampler_desc desc = summed_desc(code % 25, code / 25 % 2 ? SHD_BOX_ORIENTED : SHD_BOX_BOUNDING);
      const auto want = static_cast<float>(ref::decode(format, texels, 0));
      desc.border[0] = want;
      run_everywhere(*texture, desc, t_batch.lookups(true, false), &t_batch);
      for (size_t i = 0; i < kPoints; ++i) assert_true(t_batch.out[0][i] == want);
      free_texture(texture);
    }
  }
}

/// A box that touches a non-finite texel gives NaN in its channel; other boxes are not affected.
void test_nonfinite_texels(void**) {
  static float texels[32 * 16 * 4];
  for (size_t i = 0; i < 32 * 16 * 4; ++i) texels[i] = 2.5f;
  const size_t bad = 6 * 32 + 20;  // texel (20, 6)
  texels[4 * bad] = NAN;
  texels[4 * bad + 1] = INFINITY;
  Texture* texture = build_summed(*context(), SHD_FORMAT_RGBA32F, 32, 16, 1, texels);
  assert_int_equal(texture->nonfinite_sums.size(), 33 * 17 * 4);
  for (uint32_t pair = 0; pair < 50; ++pair) {
    shd_sampler_desc desc = summed_desc(pair % 25, pair < 25 ? SHD_BOX_BOUNDING : SHD_BOX_ORIENTED);
    for (float& value : desc.border) value = 2.5f;
    t_batch.count = 32;
    for (size_t i = 0; i < 32; ++i) {
      t_batch.u[i] = (static_cast<float>(i) + 0.5f) / 32;
      t_batch.v[i] = 6.5f / 16;
      t_batch.dudx[i] = 5.0f / 32;  // 2 whole texels on either side
      t_batch.dvdy[i] = 1.0f / 16;
      t_batch.dvdx[i] = t_batch.dudy[i] = 0;
    }
    run_everywhere(*texture, desc, t_batch.lookups(true, false), &t_batch);
    for (size_t i = 0; i < 32; ++i) {
      const bool touched = i >= 18 && i <= 22;
      for (int c = 0; c < 4; ++c) {
        const float got = t_batch.out[c][i];
        assert_true(touched && c < 2 ? isnan(got) : got == 2.5f);
      }
    }
  }
  free_texture(texture);
}

/// Sums and averages of the largest floats stay finite.
void test_largest(void**) {
  static float texels[64 * 64];
  for (size_t i = 0; i < 64 * 64; ++i) texels[i] = 3.40282347e38f;
  texels[0] = -3.40282347e38f;
  Texture* texture = build_summed(*context(), SHD_FORMAT_R32F, 64, 64, 1, texels);
  make_hostile_points(&t_batch);
  for (uint32_t pair = 0; pair < 25; ++pair) {
    run_everywhere(*texture, summed_desc(pair, SHD_BOX_BOUNDING), t_batch.lookups(true, false), &t_batch);
    for (size_t i = 0; i < kMaxPoints; ++i) assert_true(isfinite(t_batch.out[0][i]));
  }
  free_texture(texture);
}

}  // namespace

int main() {
  CMUnitTest tests[24];
  size_t n = 0;
  for (const SizeCase& c : kSizes) {
    tests[n++] = {c.name, test_size, nullptr, nullptr, const_cast<SizeCase*>(&c)};
  }
  tests[n++] = {"wide", test_wide, nullptr, nullptr, nullptr};
  tests[n++] = {"settings", test_settings, nullptr, nullptr, nullptr};
  tests[n++] = {"magnified", test_magnified, nullptr, nullptr, nullptr};
  tests[n++] = {"tails", test_tails, nullptr, nullptr, nullptr};
  tests[n++] = {"layers", test_layers, nullptr, nullptr, nullptr};
  tests[n++] = {"hostile", test_hostile, nullptr, nullptr, nullptr};
  tests[n++] = {"codes", test_codes, nullptr, nullptr, nullptr};
  tests[n++] = {"nonfinite_texels", test_nonfinite_texels, nullptr, nullptr, nullptr};
  tests[n++] = {"largest", test_largest, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.summed_area", tests, n, nullptr, nullptr);
}
