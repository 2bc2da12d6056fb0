// SPDX-License-Identifier: MIT
// SHD_PRECISION_FAST: the bits of the oracle on every target, for every format, filter, wrap and size; the bound to
// SHD_PRECISION_FULL; equal texels; what falls back to SHD_PRECISION_FULL.
#include "filter_cases.h"

#include "ref/fixed_ref.h"
#include "texture/domain/lod.h"
#include "texture/domain/probes.h"

namespace {

using namespace fixture;

constexpr shd_format kFixedFormats[] = {SHD_FORMAT_R8, SHD_FORMAT_RG8, SHD_FORMAT_RGBA8};
constexpr shd_filter kFixedFilters[] = {SHD_FILTER_BILINEAR, SHD_FILTER_BILINEAR_MIP, SHD_FILTER_TRILINEAR,
                                        SHD_FILTER_ANISOTROPIC};
constexpr shd_wrap kFixedWraps[] = {SHD_WRAP_REPEAT, SHD_WRAP_CLAMP, SHD_WRAP_MIRROR, SHD_WRAP_MIRROR_ONCE};
constexpr float kBound = 0x1p-11f;
constexpr float kLineBlend = 0.28125f;  // the largest level_blend of ANISOTROPIC

Batch t_fast, t_full;
shd::texture::ProbeBlock t_probes;

/// A sampler with wrap pair 0..15.
shd_sampler_desc fast_desc(shd_filter filter, uint32_t pair) {
  const float limits[] = {16, 1, 3.5f, 64, 2};
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = filter;
  desc.wrap_u = kFixedWraps[pair % 4];
  desc.wrap_v = kFixedWraps[pair / 4 % 4];
  desc.max_anisotropy = limits[(pair + pair / 4) % 5];
  desc.precision = SHD_PRECISION_FAST;
  desc.level_blend = pair % 3 == 0 ? 1.0f : pair % 3 == 1 ? 0.25f : 0.0f;
  desc.probe_slack = pair % 3 == 0 ? 0.125f : 0.4f;
  return desc;
}

shd_sampler_desc full_desc(shd_sampler_desc desc) {
  desc.precision = SHD_PRECISION_FULL;
  return desc;
}

/// SHD_PRECISION_FULL with the shapes of SHD_PRECISION_FAST.
shd_sampler_desc shapes_desc(shd_sampler_desc desc) {
  desc = full_desc(desc);
  if (desc.filter == SHD_FILTER_ANISOTROPIC) desc.level_blend = fminf(desc.level_blend, kLineBlend);
  return desc;
}

/// Shapes of at most kBlock lookups, which are tested elsewhere.
void find_shapes(const Texture& texture, const shd_sampler_desc& desc, const Lookups& lookups) {
  const Sampler sampler = make_sampler(shapes_desc(desc));
  const auto target = shd::core::baseline_target();
  shd::texture::find_probes(texture, sampler, target, lookups, &t_probes);
  if (desc.filter == SHD_FILTER_ANISOTROPIC) return;
  shd::texture::find_lods(texture, sampler, shd::texture::lod_range(texture, sampler), shd::texture::LodAxis::kLonger,
                          target, lookups, t_probes.lod);
  for (size_t i = 0; i < lookups.count; ++i) t_probes.probes[i] = 1;
}

/// The level of detail after shd_sampler_desc::level_blend.
float blend_levels(const shd_sampler_desc& desc, float lod) {
  if (desc.level_blend == 0.0f) return ceilf(lod - 0.5f);
  const float share = (lod - floorf(lod) - 0.5f) * (1.0f / desc.level_blend) + 0.5f;
  return floorf(lod) + fminf(fmaxf(share, 0.0f), 1.0f);
}

ref::FixedPoint point_of(const shd_sampler_desc& desc, size_t i) {
  const shd::texture::ProbeBlock& b = t_probes;
  float lod = b.lod[i];
  if (desc.filter == SHD_FILTER_BILINEAR) lod = 0;
  if (desc.filter == SHD_FILTER_TRILINEAR && desc.level_blend < 1.0f) lod = blend_levels(desc, lod);
  if (desc.filter == SHD_FILTER_BILINEAR_MIP) lod = fmaxf(ceilf(lod + 0.5f) - 1.0f, 0.0f);
  return {b.u[i], b.v[i], lod, b.step_u[i], b.step_v[i], static_cast<int>(b.probes[i])};
}

void check_bits(const char* what, size_t i, int c, float got, float want) {
  if (memcmp(&got, &want, sizeof got) != 0) {
    fail_msg("%s: point %zu channel %d: got %.9g, want %.9g", what, i, c, static_cast<double>(got),
             static_cast<double>(want));
  }
}

/// The bound to SHD_PRECISION_FULL. Both round the places of probes to floats, which moves them by 2^-23 of the
/// texture.
float bound_of(const Texture& texture, const shd_sampler_desc& desc) {
  if (desc.filter != SHD_FILTER_ANISOTROPIC) return kBound;
  return kBound + 0x1p-22f * static_cast<float>(texture.width + texture.height);
}

void check_bound(const Batch& fast, const Batch& full, float bound) {
  for (size_t c = 0; c < 4; ++c) {
    for (size_t i = 0; i < fast.count; ++i) {
      if (fabsf(fast.out[c][i] - full.out[c][i]) <= bound) continue;
      fail_msg("point %zu channel %zu: fast %.9g, full %.9g", i, c, static_cast<double>(fast.out[c][i]),
               static_cast<double>(full.out[c][i]));
    }
  }
}

/// Compares the first kBlock points with the oracle on every target, and all points with SHD_PRECISION_FULL. `bounded`:
/// lines of probes are not so long that the places of SHD_PRECISION_FULL have large errors.
void check_fast(const char* what, const Texture& texture, const shd_sampler_desc& desc, bool lod, bool bounded = true) {
  ref::Level levels[shd::texture::kMaxLevels];
  const ref::Image image = oracle_image(texture, desc, levels);
  Lookups lookups = t_fast.lookups(!lod, lod);
  const size_t nonfinite = run_everywhere(texture, desc, lookups, &t_fast);
  memcpy(t_full.out, t_fast.out, sizeof t_fast.out);
  static Batch full;
  memcpy(&full, &t_fast, sizeof full);
  assert_int_equal(run_everywhere(texture, shapes_desc(desc), lookups, &full), nonfinite);
  if (bounded || desc.filter != SHD_FILTER_ANISOTROPIC) check_bound(t_fast, full, bound_of(texture, desc));
  lookups.count = lookups.count < shd::texture::kBlock ? lookups.count : shd::texture::kBlock;
  find_shapes(texture, desc, lookups);
  const bool lines = desc.filter == SHD_FILTER_ANISOTROPIC;
  for (size_t i = 0; i < lookups.count; i += SHD_ORACLE_STRIDE) {
    const ref::FixedPoint point = point_of(desc, i);
    for (int c = 0; c < 4; ++c) {
      const float want = lines ? ref::fixed_line_value(image, point, c) : ref::fixed_value(image, point, c);
      check_bits(what, i, c, t_fast.out[c][i], want);
    }
  }
}

void test_size(void** state) {
  const auto& c = *static_cast<const SizeCase*>(*state);
  make_points(&t_fast);
  for (const shd_format format : kFixedFormats) {
    Texture* texture = random_texture(format, c.width, c.height, true);
    for (const shd_filter filter : kFixedFilters) {
      for (uint32_t pair = 0; pair < 16; ++pair) {
        check_fast(c.name, *texture, fast_desc(filter, pair), false);
        if (pair % 5 == 0) check_fast(c.name, *texture, fast_desc(filter, pair), true);
      }
    }
    free_texture(texture);
  }
}

/// Derivatives of every size, to infinity, and up to 64 probes.
void test_hostile(void**) {
  for (const shd_format format : {SHD_FORMAT_RGBA8, SHD_FORMAT_RG8}) {
    Texture* texture = random_texture(format, 61, 37, true);
    make_hostile_points(&t_fast);
    for (uint32_t pair = 0; pair < 16; ++pair) {
      for (const shd_filter filter : kFixedFilters) {
        shd_sampler_desc desc = fast_desc(filter, pair);
        desc.lod_bias = pair % 3 == 0 ? -15.0f : 0.5f;
        desc.width_x = pair % 4 == 0 ? 64.0f : 1.0f;
        desc.max_anisotropy = 64;
        check_fast("hostile", *texture, desc, false, false);
      }
    }
    free_texture(texture);
  }
}

/// Black and white texels of a large texture, where errors of weights weigh most.
void test_bound(void**) {
  constexpr uint32_t kWidth = 65536, kHeight = 4;
  auto* texels = static_cast<uint8_t*>(malloc(size_t{kWidth} * kHeight));
  for (size_t i = 0; i < size_t{kWidth} * kHeight; ++i) texels[i] = (i + i / kWidth) % 2 ? 255 : 0;
  Texture* texture = make_texture(SHD_FORMAT_R8, kWidth, kHeight, texels, true);
  make_hostile_points(&t_fast);
  Random random{77};
  for (size_t i = 0; i < t_fast.count; ++i) {
    t_fast.u[i] = random.real(0, 1);
    t_fast.v[i] = random.real(-1, 2);
  }
  for (uint32_t pair = 0; pair < 16; ++pair) {
    for (const shd_filter filter : kFixedFilters) check_fast("bound", *texture, fast_desc(filter, pair), false);
  }
  free_texture(texture);
  free(texels);
}

/// Every code in every texel, with 1 to 64 probes: the bits of SHD_PRECISION_FULL.
void test_constant(void**) {
  shd_sampler_desc desc = fast_desc(SHD_FILTER_ANISOTROPIC, 0);
  desc.max_anisotropy = 64;
  make_points(&t_fast);
  for (size_t i = 0; i < kPoints; ++i) {
    t_fast.dudx[i] = static_cast<float>(i % 64 + 1) * 0x1p-4f;
    t_fast.dvdy[i] = 0x1p-4f * (i % 3 == 0 ? 1.5f : 1.0f);
    t_fast.dvdx[i] = t_fast.dudy[i] = 0;
  }
  memcpy(&t_full, &t_fast, sizeof t_full);
  for (const shd_format format : kFixedFormats) {
    for (int code = 0; code < 256; ++code) {
      uint8_t texels[16 * 16 * 4];
      memset(texels, code, sizeof texels);
      for (size_t i = 3; i < sizeof texels; i += 4) texels[i] = static_cast<uint8_t>(255 - code);
      if (shd_format_size(format) != 4) memset(texels, code, sizeof texels);
      Texture* texture = make_texture(format, 16, 16, texels, true);
      desc.wrap_u = kFixedWraps[code % 4];
      for_each_target([&](int64_t target) {
        run(*texture, make_sampler(desc), target, t_fast.lookups(true, false), &t_fast);
        run(*texture, make_sampler(full_desc(desc)), target, t_full.lookups(true, false), &t_full);
        assert_memory_equal(t_fast.out, t_full.out, sizeof t_fast.out);
      });
      free_texture(texture);
    }
  }
}

/// Lines of 1 to 64 probes on axes that repeat, for every size.
void test_lines(void** state) {
  const auto& c = *static_cast<const SizeCase*>(*state);
  make_points(&t_fast);
  Random random{31};
  for (size_t i = 0; i < kPoints; ++i) {  // at most 64 times as long as wide, and some of them along an axis
    const float length = random.real(0.02f, 0.5f), width = length * random.real(1.0f / 70, 0.2f);
    const float x = random.real(-1, 1), y = i % 4 == 0 ? 0.0f : random.real(-1, 1);
    t_fast.dudx[i] = length * x, t_fast.dvdx[i] = length * y;
    t_fast.dudy[i] = -width * y, t_fast.dvdy[i] = width * x;
  }
  for (const shd_format format : kFixedFormats) {
    Texture* texture = random_texture(format, c.width, c.height, true);
    for (const float limit : {1.5f, 7.0f, 16.0f, 33.0f, 64.0f}) {
      for (const float blend : {0.0f, 0.1f, kLineBlend, 0.5f, 1.0f}) {
        shd_sampler_desc desc = fast_desc(SHD_FILTER_ANISOTROPIC, 0);
        desc.max_anisotropy = limit;
        desc.level_blend = blend;
        desc.profile = blend == 0.5f ? SHD_PROFILE_EXACT : SHD_PROFILE_LEAST_ERROR;
        check_fast(c.name, *texture, desc, false);
      }
    }
    free_texture(texture);
  }
}

void test_tails(void**) {
  for (const shd_filter filter : kFixedFilters) {
    for (const shd_format format : kFixedFormats) {
      Texture* texture = random_texture(format, 64, 32, true);
      check_tails(*texture, fast_desc(filter, 4), true);
      free_texture(texture);
    }
  }
}

void test_unwanted_channels(void**) {
  for (const shd_format format : kFixedFormats) {
    Texture* texture = random_texture(format, 16, 16, true);
    check_unwanted_channels(*texture, fast_desc(SHD_FILTER_ANISOTROPIC, 0));
    check_unwanted_channels(*texture, fast_desc(SHD_FILTER_BILINEAR, 5));
    free_texture(texture);
  }
}

void test_layers(void**) {
  for (const shd_filter filter : kFixedFilters) check_layers(fast_desc(filter, 9));
}

/// Points along rows, whose texels are near each other, have the bits of single points.
void test_rows(void**) {
  const float steps[] = {0.25f, 0.9f, 1.9f, 2.1f, -0.7f, -2.0f, 0.0f, 5.0f};
  for (const shd_format format : kFixedFormats) {
    Texture* texture = random_texture(format, 96, 8, true);
    for (uint32_t combination = 0; combination < 128; ++combination) {
      const shd_sampler_desc desc = fast_desc(kFixedFilters[combination / 32], combination / 8 % 4 * 5);
      t_fast.count = kPoints;
      for (size_t i = 0; i < kPoints; ++i) {
        t_fast.u[i] = (0.3f + steps[combination % 8] * static_cast<float>(i)) / 96;
        t_fast.v[i] = (i < 96 ? 0.99f : -0.2f) + (i % 48 == 47 ? 0.25f : 0.0f);
        t_fast.dudx[i] = (i < 64 ? 1.5f : 3.0f) / 96;
        t_fast.dvdy[i] = 1.5f / 8;
        t_fast.dvdx[i] = t_fast.dudy[i] = 0;
        t_fast.lod[i] = 0.75f;
      }
      check_fast("rows", *texture, desc, false);
    }
    free_texture(texture);
  }
}

/// A borrowed base gives the bits of a copied one.
void test_borrowed(void**) {
  make_points(&t_fast);
  for (const shd_format format : kFixedFormats) {
    const size_t size = size_t{24} * 20 * shd_format_size(format);
    auto* texels = static_cast<uint8_t*>(malloc(size + SHD_TEXTURE_PADDING));
    random_texels(format, 24 * 20, 8, texels);
    memset(texels + size, 0xa5, SHD_TEXTURE_PADDING);
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = format;
    desc.width = 24;
    desc.height = 20;
    desc.texels = texels;
    desc.tables = SHD_TABLE_MIPMAP;
    desc.flags = SHD_TEXTURE_BORROW;
    auto* borrowed = shd::core::create<Texture>(context()->allocator);
    shd::texture::build(*context(), desc, borrowed);
    for (const shd_filter filter : kFixedFilters) {
      for (uint32_t pair = 0; pair < 16; ++pair) check_fast("borrowed", *borrowed, fast_desc(filter, pair), false);
    }
    free_texture(borrowed);
    free(texels);
  }
}

/// Weights of 8 bits, as profiles have them, keep the bound.
void test_profiles(void**) {
  make_points(&t_fast);
  memcpy(&t_full, &t_fast, sizeof t_full);
  for (const shd_format format : kFixedFormats) {
    Texture* texture = random_texture(format, 128, 32, true);
    for (const shd_profile profile : {SHD_PROFILE_VULKAN, SHD_PROFILE_D3D11, SHD_PROFILE_OIIO}) {
      for (uint32_t pair = 0; pair < 64; ++pair) {
        shd_sampler_desc desc = fast_desc(kFixedFilters[pair / 16], pair);
        desc.profile = profile;
        run_everywhere(*texture, desc, t_fast.lookups(true, false), &t_fast);
        run_everywhere(*texture, shapes_desc(desc), t_full.lookups(true, false), &t_full);
        check_bound(t_fast, t_full, bound_of(*texture, desc));
      }
    }
    free_texture(texture);
  }
}

/// Returns whether all results of both precisions have the same bits.
bool same_bits(const Texture& texture, const shd_sampler_desc& desc) {
  make_points(&t_fast);
  memcpy(&t_full, &t_fast, sizeof t_full);
  run_everywhere(texture, desc, t_fast.lookups(true, false), &t_fast);
  run_everywhere(texture, full_desc(desc), t_full.lookups(true, false), &t_full);
  return memcmp(t_fast.out, t_full.out, sizeof t_fast.out) == 0;
}

/// Formats, filters and wraps without values of 16 bits have the bits of SHD_PRECISION_FULL, and the others do not.
void test_fallback(void**) {
  Texture* rgba8 = random_texture(SHD_FORMAT_RGBA8, 64, 32, true);
  for (const shd_format format : kFormats) {
    Texture* texture = random_texture(format, 64, 32, true);
    const bool bytes = shd::image::format_info(format).component == Component::kUnorm8;
    for (const shd_filter filter : kFixedFilters) assert_int_equal(same_bits(*texture, fast_desc(filter, 0)), !bytes);
    free_texture(texture);
  }
  for (const shd_filter filter : {SHD_FILTER_NEAREST, SHD_FILTER_BICUBIC, SHD_FILTER_NEAREST_MIP, SHD_FILTER_EWA,
                                  SHD_FILTER_STOCHASTIC, SHD_FILTER_HERMITE}) {
    assert_true(same_bits(*rgba8, fast_desc(filter, 0)));
  }
  for (const shd_filter filter : kFixedFilters) {
    shd_sampler_desc desc = fast_desc(filter, 0);
    desc.wrap_v = SHD_WRAP_BORDER;
    assert_true(same_bits(*rgba8, desc));
  }
  shd_sampler_desc desc = fast_desc(SHD_FILTER_ANISOTROPIC, 0);
  desc.probe_weights = SHD_PROBE_WEIGHTS_GAUSSIAN;
  assert_true(same_bits(*rgba8, desc));
  free_texture(rgba8);
}

/// Derivatives are those of SHD_PRECISION_FULL. Values do not depend on whether derivatives are wanted.
void test_gradient(void**) {
  static float gradient[2][2][4][kMaxPoints];
  Texture* texture = random_texture(SHD_FORMAT_RGBA8, 64, 32, true);
  make_points(&t_fast);
  make_points(&t_full);
  for (const shd_filter filter : kFixedFilters) {
    const shd_sampler_desc desc = fast_desc(filter, 6);
    for_each_target([&](int64_t target) {
      const auto simd = shd::core::simd_target_from_bit(target);
      const Lookups lookups = t_fast.lookups(true, false);
      run(*texture, make_sampler(desc), target, lookups, &t_full);
      for (size_t precision = 0; precision < 2; ++precision) {
        Texels out = {};
        for (size_t c = 0; c < 4; ++c) {
          if (precision == 0) out.channel[c] = t_fast.out[c];
          out.du[c] = gradient[precision][0][c];
          out.dv[c] = gradient[precision][1][c];
        }
        const size_t nonfinite =
            shd::texture::sample(*texture, make_sampler(precision == 0 ? desc : full_desc(desc)), simd, lookups, out);
        assert_int_equal(nonfinite, kNonfinitePoints);
      }
      assert_memory_equal(gradient[0], gradient[1], sizeof gradient[0]);
      for (size_t c = 0; c < 4; ++c) assert_memory_equal(t_fast.out[c], t_full.out[c], kPoints * sizeof(float));
    });
  }
  // Lookups without any output are counted as well.
  const Texels none = {};
  assert_int_equal(shd::texture::sample(*texture, make_sampler(fast_desc(SHD_FILTER_TRILINEAR, 0)),
                                        shd::core::baseline_target(), t_fast.lookups(true, false), none),
                   kNonfinitePoints);
  free_texture(texture);
}

}  // namespace

int main() {
  CMUnitTest tests[32];
  size_t n = add_sizes("size", test_size, tests);
  static char names[kSizeCount][32];
  for (const SizeCase& size : kSizes) {
    snprintf(names[n % kSizeCount], sizeof names[0], "lines/%s", size.name);
    tests[n] = {names[n % kSizeCount], test_lines, nullptr, nullptr, const_cast<SizeCase*>(&size)};
    ++n;
  }
  tests[n++] = {"hostile", test_hostile, nullptr, nullptr, nullptr};
  tests[n++] = {"bound", test_bound, nullptr, nullptr, nullptr};
  tests[n++] = {"constant", test_constant, nullptr, nullptr, nullptr};
  tests[n++] = {"tails", test_tails, nullptr, nullptr, nullptr};
  tests[n++] = {"unwanted_channels", test_unwanted_channels, nullptr, nullptr, nullptr};
  tests[n++] = {"layers", test_layers, nullptr, nullptr, nullptr};
  tests[n++] = {"rows", test_rows, nullptr, nullptr, nullptr};
  tests[n++] = {"borrowed", test_borrowed, nullptr, nullptr, nullptr};
  tests[n++] = {"profiles", test_profiles, nullptr, nullptr, nullptr};
  tests[n++] = {"fallback", test_fallback, nullptr, nullptr, nullptr};
  tests[n++] = {"gradient", test_gradient, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.fixed", tests, n, nullptr, nullptr);
}
