// SPDX-License-Identifier: MIT
// SHD_PROFILE_LEAST_ERROR, the default: levels of detail and the results of its filters against the oracle, with the
// bounds of SHD_PROFILE_EXACT, for every format x wrap pair x size x target.
#include "profiles.h"

#include "ref/least_error_ref.h"
#include "texture/domain/lod.h"
#include "texture/domain/probes.h"

namespace {

using namespace fixture;
using shd::texture::LodAxis;
using shd::texture::ProbeBlock;

Batch t_batch, t_first;

shd_sampler_desc least_error(shd_filter filter, uint32_t pair) {
  shd_sampler_desc desc = make_desc(SHD_PROFILE_LEAST_ERROR, filter, pair);
  desc.probe_weights = pair % 2 ? SHD_PROBE_WEIGHTS_GAUSSIAN : SHD_PROBE_WEIGHTS_EQUAL;
  return desc;
}

/// Derivatives with the widths of a sampler.
ref::Jacobian jacobian(const shd_sampler_desc& desc, size_t i) {
  const double x = static_cast<double>(desc.width_x), y = static_cast<double>(desc.width_y);
  return {x * static_cast<double>(t_batch.dudx[i]), x * static_cast<double>(t_batch.dvdx[i]),
          y * static_cast<double>(t_batch.dudy[i]), y * static_cast<double>(t_batch.dvdy[i])};
}

ref::Ellipse ellipse_in_texels(const ref::Jacobian& j, double w, double h) {
  return ref::ellipse(ref::Jacobian{j.ux * w, j.vx * h, j.uy * w, j.vy * h});
}

/// Clamps a level of detail, with its bias, to the range of the test.
double biased(const shd_sampler_desc& desc, double lambda) {
  return fmin(fmax(lambda + static_cast<double>(desc.lod_bias), -15), 17);
}

void check_probe_levels(const char* name, const ref::Image& image, const ProbeBlock& block, size_t first) {
  const shd_sampler_desc& desc = *image.sampler;
  const double w = static_cast<double>(image.levels[0].width), h = static_cast<double>(image.levels[0].height);
  for (size_t k = 0; k < 32; ++k) {
    const ref::Ellipse e = ellipse_in_texels(jacobian(desc, first + k), w, h);
    const double lambda = ref::least_error_probe_lambda(e, static_cast<double>(desc.max_anisotropy));
    const double want = ref::clamp_lod(image, lambda);
    shd_assert_close(name, first + k, static_cast<double>(block.lod[k]), want,
                     3e-6 * static_cast<double>(desc.max_anisotropy), 0);
  }
}

/// Levels of detail, with width, bias and clamps.
void test_levels(void** state) {
  const auto& c = *static_cast<const SizeCase*>(*state);
  Texture* texture = random_texture(SHD_FORMAT_R8, c.width, c.height, true);
  make_points(&t_batch);
  for (uint32_t round = 0; round < 12; ++round) {
    shd_sampler_desc desc = least_error(SHD_FILTER_ANISOTROPIC, round);
    if (round % 3 == 1) desc.width_x = 2.5f;
    if (round % 3 == 2) desc.lod_bias = -1.75f;
    ref::Level levels[shd::texture::kMaxLevels];
    const ref::Image image = oracle_image(*texture, desc, levels);
    const Sampler sampler = make_sampler(desc);
    for_each_target([&](int64_t target) {
      const auto simd = shd::core::simd_target_from_bit(target);
      float lod[kMaxPoints];
      shd::texture::find_lods(*texture, sampler, {-15, 17}, LodAxis::kLonger, simd, t_batch.lookups(true, false), lod);
      for (size_t i = 0; i < t_batch.count; ++i) {
        const double lambda = ref::least_error_lambda(jacobian(desc, i), c.width, c.height);
        if (lambda < -14 || lambda > 16) continue;
        shd_assert_close(c.name, i, static_cast<double>(lod[i]), biased(desc, lambda), 3e-6, 0);
      }
      for (size_t first = 0; first < kPoints; first += 32) {
        ProbeBlock block;
        const Lookups part = shd::texture::part_of(t_batch.lookups(true, false), first, 32);
        shd::texture::find_probes(*texture, sampler, simd, part, &block);
        check_probe_levels(c.name, image, block, first);
      }
    });
  }
  free_texture(texture);
}

/// Whether a value is possible for a filter on one mip level whose level of detail is lambda.
bool matches_level(const ref::Image& image, double lambda, double u, double v, int channel, double got) {
  const int level = static_cast<int>(fmax(ceil(ref::clamp_lod(image, lambda) + 0.5) - 1, 0));
  const double w = static_cast<double>(image.levels[level].width), h = static_cast<double>(image.levels[level].height);
  if (image.sampler->filter == SHD_FILTER_BILINEAR_MIP) {
    const double m = fmax(magnitude(image.format), 2);
    return shd_is_close(got, ref::bilinear(image, level, u, v, channel), m * (3e-7 + 8e-7 * (w + h)), 0);
  }
  for (const double dx : {0.0, -4e-7 * w, 4e-7 * w}) {
    for (const double dy : {0.0, -4e-7 * h, 4e-7 * h}) {
      if (shd_is_close(got, ref::nearest_on(image, level, u, v, dx, dy, channel), 1.2e-7, 1.2e-7)) return true;
    }
  }
  return false;
}

/// Calls body(value) with the nearest texels of a level that rounding may reach.
template <class Body>
void for_each_nearest(const ref::Image& image, int level, double u, double v, int channel, const Body& body) {
  const double w = static_cast<double>(image.levels[level].width), h = static_cast<double>(image.levels[level].height);
  for (const double dx : {0.0, -4e-7 * w, 4e-7 * w}) {
    for (const double dy : {0.0, -4e-7 * h, 4e-7 * h}) body(ref::nearest_on(image, level, u, v, dx, dy, channel));
  }
}

/// Whether a value is possible for NEAREST_MIP_LINEAR.
bool matches_two_levels(const ref::Image& image, double lambda, double u, double v, int channel, double got,
                        double error) {
  const double lod = ref::clamp_lod(image, lambda), floor_lod = floor(lod), s = lod - floor_lod;
  const int fine = static_cast<int>(floor_lod), coarse = s > 0 ? fine + 1 : fine;
  bool matches = false;
  for_each_nearest(image, fine, u, v, channel, [&](double a) {
    for_each_nearest(image, coarse, u, v, channel,
                     [&](double b) { matches = matches || shd_is_close(got, a + s * (b - a), error, 0); });
  });
  return matches;
}

bool matches(const ref::Image& image, const ref::Jacobian& j, size_t i, int channel, double got) {
  const double u = static_cast<double>(t_batch.u[i]), v = static_cast<double>(t_batch.v[i]);
  const double w = static_cast<double>(image.levels[0].width), h = static_cast<double>(image.levels[0].height);
  const double m = fmax(magnitude(image.format), 2), range = 2 * m;
  const double trilinear = 3e-7 * m + 4e-7 * (w + h) * range + 2e-6 * range;
  const double lambda = ref::least_error_lambda(j, w, h);
  const shd_filter filter = image.sampler->filter;
  if (filter == SHD_FILTER_TRILINEAR) {
    return shd_is_close(got, ref::trilinear(image, u, v, lambda, channel), trilinear, 0);
  }
  if (filter == SHD_FILTER_NEAREST_MIP_LINEAR) return matches_two_levels(image, lambda, u, v, channel, got, trilinear);
  for (const double slack : {0.0, -2e-6, 2e-6}) {
    if (filter != SHD_FILTER_ANISOTROPIC && matches_level(image, lambda + slack, u, v, channel, got)) return true;
    if (filter != SHD_FILTER_ANISOTROPIC) continue;
    const double limit = static_cast<double>(image.sampler->max_anisotropy);
    const ref::Ellipse e = ellipse_in_texels(j, w, h);
    const int count = static_cast<int>(ceil(ref::aspect(e, limit) - 0.125 + 50 * slack));
    const double level = ref::least_error_probe_lambda(e, limit);
    const double want = ref::anisotropic_at(image, e, level, count, u, v, channel);
    if (shd_is_close(got, want, trilinear + 2e-6 * limit * range, 0)) return true;
  }
  return false;
}

void check_filter(const SizeCase& c, const Texture& texture, const shd_sampler_desc& desc) {
  check_against_oracle(texture, desc, t_batch.lookups(true, false), &t_batch, [&](const ref::Image& image, size_t i) {
    for (int channel = 0; channel < 4; ++channel) {
      const double got = static_cast<double>(t_batch.out[channel][i]);
      if (matches(image, jacobian(desc, i), i, channel, got)) continue;
      fail_msg("%s: filter %d, point %zu channel %d: got %.9g", c.name, static_cast<int>(desc.filter), i, channel, got);
    }
  });
}

void test_filters(void** state) {
  const auto& c = *static_cast<const SizeCase*>(*state);
  make_points(&t_batch);
  for (const shd_format format : kFormats) {
    Texture* texture = random_texture(format, c.width, c.height, true);
    for (const shd_filter filter : kFilters) {
      for (uint32_t pair = 0; pair < 25; ++pair) check_filter(c, *texture, least_error(filter, pair));
    }
    free_texture(texture);
  }
}

/// A ripmap lookup has the bits of SHD_PROFILE_EXACT with a bias of -3/8. Levels have different values.
void test_ripmap(void**) {
  shd_texture_desc build = shd_texture_desc_default();
  uint8_t texels[64 * 64] = {};
  build.format = SHD_FORMAT_R8;
  build.width = build.height = 64;
  build.texels = texels;
  build.tables = SHD_TABLE_RIPMAP;
  auto* texture = shd::core::create<Texture>(context()->allocator);
  shd::texture::build(*context(), build, texture);
  for (uint32_t i = 0; i < texture->ripmap_columns; ++i) {
    for (uint32_t j = 0; j < texture->ripmap_rows; ++j) {
      memset(const_cast<uint8_t*>(shd::texture::ripmap_row(*texture, 0, i, j, 0)),
             static_cast<int>(7 * i + 49 * j % 200), size_t{64u >> i} * (64u >> j));
    }
  }
  make_points(&t_batch);
  memcpy(&t_first, &t_batch, sizeof t_batch);
  for_each_target([&](int64_t target) {
    shd_sampler_desc desc = least_error(SHD_FILTER_RIPMAP, 0);
    run(*texture, make_sampler(desc), target, t_batch.lookups(true, false), &t_batch);
    desc.profile = SHD_PROFILE_EXACT;
    desc.lod_bias = -0.375f;
    run(*texture, make_sampler(desc), target, t_first.lookups(true, false), &t_first);
    assert_memory_equal(t_first.out, t_batch.out, sizeof t_batch.out);
  });
  free_texture(texture);
}

/// Levels of the `lod` column have the bits of SHD_PROFILE_EXACT; so have the filters that the profile does not change.
void test_unchanged(void**) {
  const shd_filter by_lod[] = {SHD_FILTER_NEAREST_MIP,       SHD_FILTER_BILINEAR_MIP, SHD_FILTER_TRILINEAR,
                               SHD_FILTER_ANISOTROPIC,       SHD_FILTER_EWA,          SHD_FILTER_STOCHASTIC,
                               SHD_FILTER_NEAREST_MIP_LINEAR};
  const shd_filter others[] = {SHD_FILTER_NEAREST, SHD_FILTER_BILINEAR, SHD_FILTER_BICUBIC, SHD_FILTER_EWA,
                               SHD_FILTER_EXACT};
  make_points(&t_batch);
  memcpy(&t_first, &t_batch, sizeof t_batch);
  Texture* texture = random_texture(SHD_FORMAT_RGBA16, 64, 32, true);
  const auto check = [&](shd_filter filter, bool lod) {
    for_each_target([&](int64_t target) {
      shd_sampler_desc desc = least_error(filter, 6);
      run(*texture, make_sampler(desc), target, t_batch.lookups(!lod, lod), &t_batch);
      desc.profile = SHD_PROFILE_EXACT;
      run(*texture, make_sampler(desc), target, t_first.lookups(!lod, lod), &t_first);
      assert_memory_equal(t_first.out, t_batch.out, sizeof t_batch.out);
    });
  };
  for (const shd_filter filter : by_lod) check(filter, true);
  for (const shd_filter filter : others) check(filter, false);
  free_texture(texture);
}

/// A round footprint gives anisotropic and stochastic lookups the levels of trilinear, bit for bit.
void test_round(void**) {
  make_points(&t_batch);
  for (size_t i = 0; i < kPoints; ++i) {
    t_batch.dvdy[i] = i % 2 ? t_batch.dudx[i] : -t_batch.dudx[i];
    t_batch.dudy[i] = i % 2 ? -t_batch.dvdx[i] : t_batch.dvdx[i];
  }
  memcpy(&t_first, &t_batch, sizeof t_batch);
  Texture* texture = random_texture(SHD_FORMAT_RGBA8, 128, 128, true);
  for (uint32_t pair = 0; pair < 25; ++pair) {
    for_each_target([&](int64_t target) {
      run(*texture, make_sampler(least_error(SHD_FILTER_ANISOTROPIC, pair)), target, t_batch.lookups(true, false),
          &t_batch);
      run(*texture, make_sampler(least_error(SHD_FILTER_TRILINEAR, pair)), target, t_first.lookups(true, false),
          &t_first);
      assert_memory_equal(t_first.out, t_batch.out, sizeof t_batch.out);
    });
  }
  free_texture(texture);
}

/// One probe for any footprint: the level of trilinear.
void test_one_probe(void**) {
  make_points(&t_batch);
  Texture* texture = random_texture(SHD_FORMAT_R8, 128, 128, true);
  shd_sampler_desc desc = least_error(SHD_FILTER_ANISOTROPIC, 0);
  desc.max_anisotropy = 1;
  for_each_target([&](int64_t target) {
    const auto simd = shd::core::simd_target_from_bit(target);
    const auto range = shd::texture::lod_range(*texture, make_sampler(desc));
    float lod[kMaxPoints];
    shd::texture::find_lods(*texture, make_sampler(desc), range, LodAxis::kLonger, simd, t_batch.lookups(true, false),
                            lod);
    for (size_t first = 0; first < kPoints; first += 32) {
      ProbeBlock block;
      const Lookups part = shd::texture::part_of(t_batch.lookups(true, false), first, 32);
      shd::texture::find_probes(*texture, make_sampler(desc), simd, part, &block);
      for (size_t k = 0; k < 32; ++k) {
        assert_true(block.probes[k] == 1);
        shd_assert_close("one_probe", first + k, static_cast<double>(block.lod[k]), static_cast<double>(lod[first + k]),
                         3e-6, 0);
      }
    }
  });
  free_texture(texture);
}

/// Magnified lookups are those whose own level is at most 0: for trilinear circles of up to 2^(3/8) texels, for the
/// other filters footprints of at most one texel.
void test_magnified(void**) {
  const float texels[] = {0, 1, 0, 1};
  Texture* texture = make_texture(SHD_FORMAT_R32F, 4, 1, reinterpret_cast<const uint8_t*>(texels), true);
  const float length[] = {0.9f, 1.1f, 1.29f, 1.31f};
  t_batch.count = 4;
  for (size_t i = 0; i < 4; ++i) {
    t_batch.u[i] = 0.3f;  // inside texel 1; a bilinear lookup has a share of texel 0
    t_batch.v[i] = 0.5f;
    t_batch.dudx[i] = length[i] / 4;
    t_batch.dvdy[i] = length[i];
    t_batch.dvdx[i] = t_batch.dudy[i] = 0;
  }
  for_each_target([&](int64_t target) {
    for (const shd_filter filter : {SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC}) {
      shd_sampler_desc desc = least_error(filter, 0);
      desc.magnification = SHD_MAGNIFICATION_NEAREST;
      run(*texture, make_sampler(desc), target, t_batch.lookups(true, false), &t_batch);
      const size_t magnified = filter == SHD_FILTER_TRILINEAR ? 3 : 1;
      for (size_t i = 0; i < 4; ++i) assert_true((t_batch.out[0][i] == 1) == (i < magnified));
    }
  });
  free_texture(texture);
}

void test_hostile(void**) {
  const float values[] = {0, -1e-45f, 1e-30f, -1e-8f, -1e-3f, 0.3f, 1e10f, -1e19f, -1e30f, 3.4e38f, INFINITY, NAN};
  check_hostile_derivatives(values, 60, [](uint32_t round) {
    shd_sampler_desc desc = least_error(kFilters[round % 4], round);
    desc.lod_bias = round % 5 == 0 ? -15.0f : 0.0f;
    desc.width_x = round % 4 == 0 ? 64.0f : round % 7 == 0 ? 0.0f : 1.0f;
    desc.blur_v = round % 5 == 0 ? 0.5f : 0.0f;
    if (round % 2) desc.magnification = SHD_MAGNIFICATION_NEAREST;
    return desc;
  });
}

void test_infinite(void**) {
  for (const shd_filter filter : kFilters) check_infinite(least_error(filter, 0));
}

}  // namespace

int main() {
  CMUnitTest tests[32];
  size_t n = add_sizes("filters", test_filters, tests);
  for (size_t i = 0; i < kSizeCount; ++i) {
    tests[n++] = {kSizes[i].name, test_levels, nullptr, nullptr, const_cast<SizeCase*>(&kSizes[i])};
  }
  tests[n++] = {"ripmap", test_ripmap, nullptr, nullptr, nullptr};
  tests[n++] = {"unchanged", test_unchanged, nullptr, nullptr, nullptr};
  tests[n++] = {"round", test_round, nullptr, nullptr, nullptr};
  tests[n++] = {"one_probe", test_one_probe, nullptr, nullptr, nullptr};
  tests[n++] = {"magnified", test_magnified, nullptr, nullptr, nullptr};
  tests[n++] = {"hostile", test_hostile, nullptr, nullptr, nullptr};
  tests[n++] = {"infinite", test_infinite, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.least_error", tests, n, nullptr, nullptr);
}
