// SPDX-License-Identifier: MIT
// Anisotropic probes against the oracle: every format x wrap pair x size x target; the bits of trilinear where there is
// one probe; hostile derivatives and texels.
#include "points.h"

#include "ref/footprint_ref.h"

namespace {

using namespace fixture;

struct size_case {
  const char* name;
  uint32_t width, height;
};
const size_case k_sizes[] = {
    {"anisotropic/1x1", 1, 1},       {"anisotropic/1x7", 1, 7},       {"anisotropic/5x3", 5, 3},
    {"anisotropic/64x64", 64, 64},   {"anisotropic/128x32", 128, 32}, {"anisotropic/1023x511", 1023, 511},
    {"anisotropic/4096x1", 4096, 1},
};

Batch t_batch, t_first;

shd_sampler_desc anisotropic_desc(uint32_t pair) {
  const float limits[] = {16, 1, 3.5f, 64, 2};
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = SHD_FILTER_ANISOTROPIC;
  desc.wrap_u = static_cast<shd_wrap>(pair % 5);
  desc.wrap_v = static_cast<shd_wrap>(pair / 5 % 5);
  desc.max_anisotropy = limits[(pair + pair / 5) % 5];
  desc.probe_weights = pair % 2 ? SHD_PROBE_WEIGHTS_GAUSSIAN : SHD_PROBE_WEIGHTS_EQUAL;
  const float border[] = {0.25f, -1.5f, 2.0f, 0.75f};
  memcpy(desc.border, border, sizeof border);
  return desc;
}

/// Against the oracle; with either number of probes where rounding decides between two.
void check_point(const size_case& c, const ref::Image& image, const Batch& batch, bool lod, size_t i) {
  const double u = static_cast<double>(batch.u[i]), v = static_cast<double>(batch.v[i]);
  const double w = c.width, h = c.height, limit = static_cast<double>(image.sampler->max_anisotropy);
  const double length = exp2(static_cast<double>(batch.lod[i]));
  const ref::Jacobian j = {static_cast<double>(batch.dudx[i]) * w, static_cast<double>(batch.dvdx[i]) * h,
                           static_cast<double>(batch.dudy[i]) * w, static_cast<double>(batch.dvdy[i]) * h};
  const ref::Ellipse e = lod ? ref::Ellipse{length, length, 1, 0} : ref::ellipse(j);
  const double ratio = ref::aspect(e, limit) - 0.125;
  const double m = fmax(magnitude(image.format), 2), range = 2 * m;
  const double tolerance = 3e-7 * m + 4e-7 * (w + h) * range + 2e-6 * range + 2e-6 * limit * range;
  const int low = static_cast<int>(ceil(ratio - 1e-4)), high = static_cast<int>(ceil(ratio + 1e-4));
  for (int channel = 0; channel < 4; ++channel) {
    const double got = static_cast<double>(batch.out[channel][i]);
    if (low != high && shd_is_close(got, ref::anisotropic(image, e, low, u, v, channel), tolerance, 0)) continue;
    shd_assert_close(c.name, i, got, ref::anisotropic(image, e, high, u, v, channel), tolerance, 0);
  }
}

void check_combination(const size_case& c, const Texture& texture, const shd_sampler_desc& desc, bool lod) {
  const Sampler sampler = make_sampler(desc);
  ref::Level levels[shd::texture::kMaxLevels];
  const ref::Image image = oracle_image(texture, desc, levels);
  bool first = true;
  for_each_target([&](int64_t target) {
    const size_t nonfinite = run(texture, sampler, target, t_batch.lookups(!lod, lod), &t_batch);
    assert_int_equal(nonfinite, kNonfinitePoints);
    if (first) {
      for (size_t i = 0; i < t_batch.count; ++i) check_point(c, image, t_batch, lod, i);
      memcpy(t_first.out, t_batch.out, sizeof t_batch.out);
      first = false;
    }
    assert_memory_equal(t_first.out, t_batch.out, sizeof t_batch.out);
  });
}

void test_size(void** state) {
  const auto& c = *static_cast<const size_case*>(*state);
  make_points(&t_batch);
  for (const shd_format format : kFormats) {
    Texture* texture = random_texture(format, c.width, c.height, true);
    for (uint32_t pair = 0; pair < 25; ++pair) {
      check_combination(c, *texture, anisotropic_desc(pair), false);
      if (pair % 6 == 0) check_combination(c, *texture, anisotropic_desc(pair), true);
    }
    free_texture(texture);
  }
}

/// Round footprints, a limit of 1 and a given level of detail have the bits of trilinear.
void test_isotropic(void**) {
  make_points(&t_batch);
  for (size_t i = 0; i < kPoints; ++i) {
    if (i % 3 == 0) t_batch.dvdx[i] = t_batch.dudy[i] = 0;
    t_batch.dvdy[i] = i % 2 ? t_batch.dudx[i] : -t_batch.dudx[i];
    t_batch.dudy[i] = i % 2 ? -t_batch.dvdx[i] : t_batch.dvdx[i];
  }
  memcpy(&t_first, &t_batch, sizeof t_batch);
  for (const shd_format format : kFormats) {
    Texture* texture = random_texture(format, 128, 128, true);
    for (uint32_t pair = 0; pair < 75; ++pair) {
      shd_sampler_desc desc = anisotropic_desc(pair);
      const bool lod = pair / 25 == 1;
      if (pair / 25 == 2) {
        desc.max_anisotropy = 1;
        desc.width_x = 0.5f;
        desc.blur_u = 0.125f;
      }
      desc.lod_bias = static_cast<float>(pair % 4) - 1.5f;
      for_each_target([&](int64_t target) {
        run(*texture, make_sampler(desc), target, t_batch.lookups(!lod, lod), &t_batch);
        shd_sampler_desc trilinear = desc;
        trilinear.filter = SHD_FILTER_TRILINEAR;
        run(*texture, make_sampler(trilinear), target, t_first.lookups(!lod, lod), &t_first);
        assert_memory_equal(t_first.out, t_batch.out, sizeof t_batch.out);
      });
    }
    free_texture(texture);
  }
}

/// A constant texture gives exactly its value, whatever the coordinates and the footprint.
void test_constant(void**) {
  make_points(&t_batch);
  for (const shd_format format : kFormats) {
    uint8_t texels[16 * 16 * 16];
    const size_t bytes = shd_format_size(format);
    random_texels(format, 1, 4242, texels);
    for (size_t i = 1; i < 256; ++i) memcpy(texels + i * bytes, texels, bytes);
    Texture* texture = make_texture(format, 16, 16, texels, true);
    for (uint32_t pair = 0; pair < 25; ++pair) {
      const shd_sampler_desc desc = anisotropic_desc(pair);
      if (desc.wrap_u == SHD_WRAP_BORDER || desc.wrap_v == SHD_WRAP_BORDER) continue;
      for_each_target([&](int64_t target) {
        run(*texture, make_sampler(desc), target, t_batch.lookups(true, false), &t_batch);
        for (int c = 0; c < 4; ++c) {
          const auto want = static_cast<float>(ref::decode(format, texels, c));
          for (size_t i = 0; i < t_batch.count; ++i) assert_true(t_batch.out[c][i] == want);
        }
      });
    }
    free_texture(texture);
  }
}

/// Every tail length gives the bits of the whole batch and writes nothing after it.
void test_tails(void**) {
  make_points(&t_batch);
  memcpy(&t_first, &t_batch, sizeof t_batch);
  for (const shd_format format : kFormats) {
    Texture* texture = random_texture(format, 64, 32, true);
    const Sampler sampler = make_sampler(anisotropic_desc(1));
    for_each_target([&](int64_t target) {
      run(*texture, sampler, target, t_first.lookups(true, false), &t_first);
      for (size_t count = 0; count <= 35; ++count) {
        t_batch.count = count;
        run(*texture, sampler, target, t_batch.lookups(true, false), &t_batch);
        for (size_t k = 0; k < 4; ++k) assert_memory_equal(t_batch.out[k], t_first.out[k], count * sizeof(float));
      }
    });
    free_texture(texture);
  }
}

/// Derivatives of any bits: finite texels give values between the least and the largest of them.
void test_hostile_derivatives(void**) {
  const float values[] = {0, -1e-45f, 1e-30f, -1e-3f, 0.3f, 1e10f, -1e30f, 3.4e38f, INFINITY, NAN};
  constexpr size_t kValues = sizeof values / sizeof values[0];
  Texture* texture = random_texture(SHD_FORMAT_RGBA32F, 61, 37, true);
  Random random{99};
  for (uint32_t round = 0; round < 60; ++round) {
    make_points(&t_batch);
    for (size_t i = 0; i < kPoints; ++i) {
      for (float* column : {t_batch.dudx, t_batch.dvdx, t_batch.dudy, t_batch.dvdy})
        column[i] = values[(random.next() >> 16) % kValues];
    }
    shd_sampler_desc desc = anisotropic_desc(round);
    desc.lod_bias = round % 3 == 0 ? -15.0f : 0.0f;
    desc.width_x = round % 4 == 0 ? 64.0f : 1.0f;
    desc.blur_v = round % 5 == 0 ? 0.5f : 0.0f;
    bool first = true;
    for_each_target([&](int64_t target) {
      run(*texture, make_sampler(desc), target, t_batch.lookups(true, false), &t_batch);
      for (const auto& column : t_batch.out) {
        for (size_t i = 0; i < kPoints; ++i) assert_true(column[i] >= -8.001f && column[i] <= 8.001f);
      }
      if (first) memcpy(t_first.out, t_batch.out, sizeof t_batch.out);
      first = false;
      assert_memory_equal(t_first.out, t_batch.out, sizeof t_batch.out);
    });
  }
  free_texture(texture);
}

/// An infinite derivative gives the coarsest level.
void test_infinite(void**) {
  Texture* texture = random_texture(SHD_FORMAT_RGBA32F, 64, 64, true);
  const auto* coarsest = reinterpret_cast<const float*>(shd::texture::row_of(*texture, 0, 6, 0));
  make_points(&t_batch);
  for (size_t i = 0; i < kPoints; ++i) t_batch.dvdx[i] = i % 2 ? INFINITY : -INFINITY;
  for_each_target([&](int64_t target) {
    shd_sampler_desc desc = anisotropic_desc(0);
    run(*texture, make_sampler(desc), target, t_batch.lookups(true, false), &t_batch);
    for (int c = 0; c < 4; ++c) {
      for (size_t i = 0; i < kPoints; ++i) assert_true(t_batch.out[c][i] == coarsest[c]);
    }
  });
  free_texture(texture);
}

/// Texels that are not finite never count with weight 0, neither beside the probes nor past the last of a lane, and do
/// count inside.
void test_nonfinite_texels(void**) {
  float texels[16 * 16 * 4];
  for (size_t i = 0; i < 256; ++i) {
    for (size_t c = 0; c < 4; ++c) texels[4 * i + c] = i % 16 == 9 ? (c % 2 ? NAN : INFINITY) : 1;
  }
  Texture* texture = make_texture(SHD_FORMAT_RGBA32F, 16, 16, reinterpret_cast<uint8_t*>(texels), false);
  t_batch.count = 64;
  for (size_t i = 0; i < 64; ++i) {
    const bool inside = i % 5 == 4;
    t_batch.u[i] = inside ? 9.25f / 16 : 8.5f / 16;  // the centre of column 8 has weight 0 for column 9
    t_batch.v[i] = 0.5f;
    t_batch.dudx[i] = t_batch.dvdx[i] = t_batch.dudy[i] = 0;
    t_batch.dvdx[i] = 1.0f / 16;
    t_batch.dvdy[i] = i % 3 ? 8.0f / 16 : 0;
    t_batch.dudy[i] = 0;
  }
  for_each_target([&](int64_t target) {
    shd_sampler_desc desc = anisotropic_desc(0);
    run(*texture, make_sampler(desc), target, t_batch.lookups(true, false), &t_batch);
    for (const auto& column : t_batch.out) {
      for (size_t i = 0; i < 64; ++i) {
        if (i % 5 == 4) assert_false(isfinite(column[i]));
        if (i % 5 != 4) assert_true(column[i] == 1);
      }
    }
  });
  free_texture(texture);
}

/// Lanes read their own layer.
void test_layers(void**) {
  constexpr size_t kTexels = 32 * 16, kLayers = 3;
  auto* texels = static_cast<uint8_t*>(malloc(kTexels * kLayers * 4));
  random_texels(SHD_FORMAT_RGBA8, kTexels * kLayers, 5, texels);
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = SHD_FORMAT_RGBA8;
  desc.width = 32;
  desc.height = 16;
  desc.layers = kLayers;
  desc.texels = texels;
  desc.tables = SHD_TABLE_MIPMAP;
  auto* array = shd::core::create<Texture>(context()->allocator);
  shd::texture::build(*context(), desc, array);
  make_points(&t_batch);
  static uint32_t layer[kMaxPoints];
  for (size_t i = 0; i < kPoints; ++i) layer[i] = static_cast<uint32_t>(i * 7 % 4);  // 3 is beyond the last
  const Sampler sampler = make_sampler(anisotropic_desc(0));
  for (uint32_t l = 0; l < kLayers; ++l) {
    Texture* single = make_texture(SHD_FORMAT_RGBA8, 32, 16, texels + l * kTexels * 4, true);
    for_each_target([&](int64_t target) {
      Lookups lookups = t_batch.lookups(true, false);
      run(*single, sampler, target, lookups, &t_batch);
      memcpy(t_first.out, t_batch.out, sizeof t_batch.out);
      lookups.layer = layer;
      run(*array, sampler, target, lookups, &t_batch);
      for (size_t i = 0; i < kPoints; ++i) {
        if ((layer[i] < kLayers ? layer[i] : kLayers - 1) != l) continue;
        for (size_t c = 0; c < 4; ++c) assert_memory_equal(&t_first.out[c][i], &t_batch.out[c][i], sizeof(float));
      }
    });
    free_texture(single);
  }
  free_texture(array);
  free(texels);
}

}  // namespace

int main() {
  CMUnitTest tests[32];
  size_t n = 0;
  for (const size_case& c : k_sizes) tests[n++] = {c.name, test_size, nullptr, nullptr, const_cast<size_case*>(&c)};
  tests[n++] = {"isotropic", test_isotropic, nullptr, nullptr, nullptr};
  tests[n++] = {"constant", test_constant, nullptr, nullptr, nullptr};
  tests[n++] = {"tails", test_tails, nullptr, nullptr, nullptr};
  tests[n++] = {"hostile_derivatives", test_hostile_derivatives, nullptr, nullptr, nullptr};
  tests[n++] = {"infinite", test_infinite, nullptr, nullptr, nullptr};
  tests[n++] = {"nonfinite_texels", test_nonfinite_texels, nullptr, nullptr, nullptr};
  tests[n++] = {"layers", test_layers, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.anisotropic", tests, n, nullptr, nullptr);
}
