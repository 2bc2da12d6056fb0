// SPDX-License-Identifier: MIT
// Every filter x format x wrap pair x size x target against the oracle, all tails, and the bits of all targets.
#include "filter_cases.h"

namespace {

using namespace fixture;

struct filter_case {
  const char* name;
  shd_filter filter;
  uint32_t width, height;
};
const filter_case k_cases[] = {
    {"nearest/1x1", SHD_FILTER_NEAREST, 1, 1},
    {"nearest/1x7", SHD_FILTER_NEAREST, 1, 7},
    {"nearest/5x3", SHD_FILTER_NEAREST, 5, 3},
    {"nearest/64x64", SHD_FILTER_NEAREST, 64, 64},
    {"nearest/128x32", SHD_FILTER_NEAREST, 128, 32},
    {"nearest/1023x511", SHD_FILTER_NEAREST, 1023, 511},
    {"nearest/4096x1", SHD_FILTER_NEAREST, 4096, 1},
    {"bilinear/1x1", SHD_FILTER_BILINEAR, 1, 1},
    {"bilinear/1x7", SHD_FILTER_BILINEAR, 1, 7},
    {"bilinear/5x3", SHD_FILTER_BILINEAR, 5, 3},
    {"bilinear/64x64", SHD_FILTER_BILINEAR, 64, 64},
    {"bilinear/128x32", SHD_FILTER_BILINEAR, 128, 32},
    {"bilinear/1023x511", SHD_FILTER_BILINEAR, 1023, 511},
    {"bilinear/4096x1", SHD_FILTER_BILINEAR, 4096, 1},
    {"hermite/1x1", SHD_FILTER_HERMITE, 1, 1},
    {"hermite/1x7", SHD_FILTER_HERMITE, 1, 7},
    {"hermite/5x3", SHD_FILTER_HERMITE, 5, 3},
    {"hermite/64x64", SHD_FILTER_HERMITE, 64, 64},
    {"hermite/128x32", SHD_FILTER_HERMITE, 128, 32},
    {"hermite/1023x511", SHD_FILTER_HERMITE, 1023, 511},
    {"hermite/4096x1", SHD_FILTER_HERMITE, 4096, 1},
    {"trilinear/1x1", SHD_FILTER_TRILINEAR, 1, 1},
    {"trilinear/1x7", SHD_FILTER_TRILINEAR, 1, 7},
    {"trilinear/5x3", SHD_FILTER_TRILINEAR, 5, 3},
    {"trilinear/64x64", SHD_FILTER_TRILINEAR, 64, 64},
    {"trilinear/128x32", SHD_FILTER_TRILINEAR, 128, 32},
    {"trilinear/1023x511", SHD_FILTER_TRILINEAR, 1023, 511},
    {"trilinear/4096x1", SHD_FILTER_TRILINEAR, 4096, 1},
};

Batch t_batch, t_first;

/// The bounds stated in sample.h, for values within [-m, m].
double bound(const filter_case& c, shd_format format, double border) {
  const double m = fmax(magnitude(format), border), range = 2 * m;
  const double linear = 3e-7 * m + 4e-7 * (c.width + c.height) * range;
  if (c.filter == SHD_FILTER_HERMITE) return 1.5 * linear + 7e-7 * m;
  return c.filter == SHD_FILTER_TRILINEAR ? linear + 2e-6 * range : linear;
}

bool nearest_matches(const ref::Image& image, const filter_case& c, double u, double v, int channel, double got) {
  const double slack_x = 4e-7 * c.width, slack_y = 4e-7 * c.height;
  for (const double dx : {0.0, -slack_x, slack_x}) {
    for (const double dy : {0.0, -slack_y, slack_y}) {
      if (shd_is_close(got, ref::nearest(image, u, v, dx, dy, channel), 1.2e-7, 1.2e-7)) return true;
    }
  }
  return false;
}

void check_point(const ref::Image& image, const filter_case& c, const Batch& batch, bool lod, size_t i) {
  const double u = static_cast<double>(batch.u[i]), v = static_cast<double>(batch.v[i]);
  const bool exact_input = i % 2 == 0 && i < 96 && c.width <= 1024 && c.height <= 1024;
  const double tolerance = bound(c, image.format, 2);
  const double tight = 3e-7 * fmax(magnitude(image.format), 2);
  const double lambda =
      lod ? static_cast<double>(batch.lod[i])
          : ref::lambda(static_cast<double>(batch.dudx[i]), static_cast<double>(batch.dvdx[i]),
                        static_cast<double>(batch.dudy[i]), static_cast<double>(batch.dvdy[i]), c.width, c.height);
  for (int channel = 0; channel < 4; ++channel) {
    const double got = static_cast<double>(batch.out[channel][i]);
    if (c.filter == SHD_FILTER_NEAREST) {
      if (!nearest_matches(image, c, u, v, channel, got)) {
        fail_msg("point %zu (%.9g, %.9g) channel %d: got %.9g, want %.9g", i, u, v, channel, got,
                 ref::nearest(image, u, v, 0, 0, channel));
      }
      continue;
    }
    const bool hermite = c.filter == SHD_FILTER_HERMITE, bilinear = hermite || c.filter == SHD_FILTER_BILINEAR;
    const double want = hermite    ? ref::hermite(image, u, v, channel)
                        : bilinear ? ref::bilinear(image, 0, u, v, channel)
                                   : ref::trilinear(image, u, v, lambda, channel);
    const double exact = hermite ? 4 * tight : tight;
    shd_assert_close(c.name, i, got, want, bilinear && exact_input ? exact : tolerance, 0);
  }
}

void check_combination(const filter_case& c, const Texture& texture, const shd_sampler_desc& desc, bool lod) {
  check_against_oracle(texture, desc, t_batch.lookups(!lod, lod), &t_batch,
                       [&](const ref::Image& image, size_t i) { check_point(image, c, t_batch, lod, i); });
}

void test_filter(void** state) {
  const auto& c = *static_cast<const filter_case*>(*state);
  make_points(&t_batch);
  for (const shd_format format : kFormats) {
    Texture* texture = random_texture(format, c.width, c.height, c.filter == SHD_FILTER_TRILINEAR);
    for (uint32_t pair = 0; pair < 25; ++pair) {
      const shd_sampler_desc desc = wrap_desc(c.filter, pair);
      check_combination(c, *texture, desc, false);
      if (c.filter == SHD_FILTER_TRILINEAR) check_combination(c, *texture, desc, true);
    }
    free_texture(texture);
  }
}

void test_tails(void**) {
  for (const shd_filter filter : {SHD_FILTER_NEAREST, SHD_FILTER_BILINEAR, SHD_FILTER_TRILINEAR, SHD_FILTER_HERMITE}) {
    shd_sampler_desc desc = shd_sampler_desc_default();
    desc.filter = filter;
    check_tails_of_formats(desc, true);
  }
}

void test_unwanted_channels(void**) {
  for (const shd_format format : kFormats) {
    Texture* texture = random_texture(format, 16, 16, true);
    check_unwanted_channels(*texture, shd_sampler_desc_default());
    free_texture(texture);
  }
}

/// Points along one row, as in a span of fragments, use other loads than random points, with equal bits.
void test_rows(void**) {
  const shd_filter filters[] = {SHD_FILTER_BILINEAR, SHD_FILTER_TRILINEAR, SHD_FILTER_HERMITE};
  const float steps[] = {0.25f, 0.9f, 1.0f, 1.9f, 2.1f, -0.7f, -2.0f, 0.0f};
  for (const shd_format format : {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8_SRGB}) {
    Texture* texture = random_texture(format, 96, 8, true);
    for (uint32_t combination = 0; combination < 96; ++combination) {
      const float step = steps[combination % 8];
      shd_sampler_desc desc = shd_sampler_desc_default();
      desc.wrap_u = desc.wrap_v = static_cast<shd_wrap>(combination / 8 % 4);
      desc.filter = filters[combination / 32];
      const Sampler sampler = make_sampler(desc);
      t_batch.count = kPoints;
      for (size_t i = 0; i < kPoints; ++i) {
        t_batch.u[i] = (0.3f + step * static_cast<float>(i)) / 96;
        t_batch.v[i] = (i < 96 ? 0.99f : -0.2f) + (i % 48 == 47 ? 0.25f : 0.0f);
        t_batch.lod[i] = i < 64 ? 0.75f : 1.5f;
      }
      for_each_target([&](int64_t target) {
        run(*texture, sampler, target, t_batch.lookups(false, true), &t_batch);
        for (size_t i = 0; i < kPoints; ++i) {
          t_first.count = 1;
          t_first.u[0] = t_batch.u[i];
          t_first.v[0] = t_batch.v[i];
          t_first.lod[0] = t_batch.lod[i];
          run(*texture, sampler, target, t_first.lookups(false, true), &t_first);
          for (size_t c = 0; c < 4; ++c) assert_memory_equal(&t_batch.out[c][i], t_first.out[c], sizeof(float));
        }
      });
    }
    free_texture(texture);
  }
}

void test_constant(void**) {
  for (const shd_filter filter : {SHD_FILTER_NEAREST, SHD_FILTER_BILINEAR, SHD_FILTER_TRILINEAR, SHD_FILTER_HERMITE}) {
    const shd_wrap wraps[] = {SHD_WRAP_REPEAT, SHD_WRAP_CLAMP, SHD_WRAP_MIRROR};
    check_constant_mipmap(3, [&](uint32_t k) {
      shd_sampler_desc desc = shd_sampler_desc_default();
      desc.filter = filter;
      desc.wrap_u = desc.wrap_v = wraps[k];
      return desc;
    });
  }
}

/// At texel centres an 8-bit texel is exactly code / 255, and its decoded value for sRGB.
void test_centres_exact(void**) {
  uint8_t texels[256 * 4];
  for (int i = 0; i < 256; ++i) {
    for (int c = 0; c < 4; ++c) texels[4 * i + c] = static_cast<uint8_t>(c % 2 ? 255 - i : i);
  }
  t_batch.count = 256;
  for (size_t i = 0; i < 256; ++i) {
    t_batch.u[i] = (static_cast<float>(i) + 0.5f) / 256;
    t_batch.v[i] = 0.5f;
  }
  for (const shd_format format : {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8_SRGB}) {
    for (uint32_t wrap = 0; wrap < 4; ++wrap) {
      Texture* texture = make_texture(format, 256, 1, texels, true);
      shd_sampler_desc desc = shd_sampler_desc_default();
      desc.wrap_u = static_cast<shd_wrap>(wrap);
      for_each_target([&](int64_t target) {
        run(*texture, make_sampler(desc), target, t_batch.lookups(false, false), &t_batch);
        for (size_t i = 0; i < 256; ++i) {
          for (int c = 0; c < 4; ++c) {
            assert_true(t_batch.out[c][i] == static_cast<float>(ref::decode(format, texels + 4 * i, c)));
          }
        }
      });
      free_texture(texture);
    }
  }
}

/// A linear ramp is reproduced: value x - 1/2 between the centres of 0, 1, 2, ...
void test_ramp(void**) {
  float texels[64 * 4];
  for (size_t i = 0; i < 256; ++i) texels[i] = static_cast<float>(i / 4);
  Texture* texture = make_texture(SHD_FORMAT_RGBA32F, 64, 1, reinterpret_cast<uint8_t*>(texels), false);
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = SHD_FILTER_BILINEAR;
  desc.wrap_u = desc.wrap_v = SHD_WRAP_CLAMP;
  t_batch.count = kMaxPoints;
  for (size_t i = 0; i < kMaxPoints; ++i) {
    t_batch.u[i] = (0.5f + 63.0f * static_cast<float>(i) / (kMaxPoints - 1)) / 64;
    t_batch.v[i] = 0.25f;
  }
  for_each_target([&](int64_t target) {
    run(*texture, make_sampler(desc), target, t_batch.lookups(false, false), &t_batch);
    for (size_t i = 0; i < kMaxPoints; ++i) {
      const double want = static_cast<double>(t_batch.u[i]) * 64 - 0.5;
      shd_assert_close("ramp", i, static_cast<double>(t_batch.out[0][i]), want, 4e-6, 1e-7);
    }
  });
  free_texture(texture);
}

}  // namespace

int main() {
  CMUnitTest tests[40];
  size_t n = 0;
  for (const filter_case& c : k_cases) {
    tests[n++] = {c.name, test_filter, nullptr, nullptr, const_cast<filter_case*>(&c)};
  }
  tests[n++] = {"tails", test_tails, nullptr, nullptr, nullptr};
  tests[n++] = {"unwanted_channels", test_unwanted_channels, nullptr, nullptr, nullptr};
  tests[n++] = {"rows", test_rows, nullptr, nullptr, nullptr};
  tests[n++] = {"constant", test_constant, nullptr, nullptr, nullptr};
  tests[n++] = {"texel_centres", test_centres_exact, nullptr, nullptr, nullptr};
  tests[n++] = {"ramp", test_ramp, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.filters", tests, n, nullptr, nullptr);
}
