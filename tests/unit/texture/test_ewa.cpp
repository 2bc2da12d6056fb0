// SPDX-License-Identifier: MIT
// The elliptical weighted average against the oracle: every format x wrap pair x size x target, values and derivatives;
// hostile derivatives and texels; the number of taps.
#include "points.h"

#include "ref/ewa_ref.h"
#include "texture/explain.h"

namespace {

using namespace fixture;

struct size_case {
  const char* name;
  uint32_t width, height;
};
const size_case k_sizes[] = {
    {"ewa/1x1", 1, 1},       {"ewa/1x7", 1, 7},           {"ewa/5x3", 5, 3},       {"ewa/64x64", 64, 64},
    {"ewa/128x32", 128, 32}, {"ewa/1023x511", 1023, 511}, {"ewa/4096x1", 4096, 1},
};

Batch t_batch, t_first;

shd_sampler_desc ewa_desc(uint32_t pair) {
  const float limits[] = {16, 1, 3.5f, 64, 2};
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = SHD_FILTER_EWA;
  desc.wrap_u = static_cast<shd_wrap>(pair % 5);
  desc.wrap_v = static_cast<shd_wrap>(pair / 5 % 5);
  desc.max_anisotropy = limits[(pair + pair / 5) % 5];
  const float border[] = {0.25f, -1.5f, 2.0f, 0.75f};
  memcpy(desc.border, border, sizeof border);
  return desc;
}

/// The footprint of a point in base texels.
ref::Ellipse ellipse_of(const Batch& batch, const ref::Image& image, bool lod, size_t i) {
  const auto w = static_cast<double>(image.levels[0].width), h = static_cast<double>(image.levels[0].height);
  const double length = exp2(static_cast<double>(batch.lod[i]));
  if (lod) return {length, length, 1, 0};
  return ref::ellipse(ref::Jacobian{static_cast<double>(batch.dudx[i]) * w, static_cast<double>(batch.dvdx[i]) * h,
                                    static_cast<double>(batch.dudy[i]) * w, static_cast<double>(batch.dvdy[i]) * h});
}

/// Against the oracle; with either level where rounding decides between two.
void check_point(const size_case& c, const ref::Image& image, const Batch& batch, bool lod, size_t i) {
  const double u = static_cast<double>(batch.u[i]), v = static_cast<double>(batch.v[i]);
  const double limit = static_cast<double>(image.sampler->max_anisotropy);
  const ref::Ellipse e = ellipse_of(batch, image, lod, i);
  const double m = fmax(magnitude(image.format), 2);
  const double tolerance = m * (3e-6 + 4e-6 * (c.width + c.height) + 4e-6 * limit);
  const double level = ref::ewa_lod(image, e);
  const int low = static_cast<int>(fmax(floor(level - 1e-4), 0));
  const int high = static_cast<int>(fmin(floor(level + 1e-4), image.level_count - 1));
  double finer[4], coarser[4];
  ref::ewa(image, e, high, u, v, 0, 0, coarser);
  memcpy(finer, coarser, sizeof finer);
  if (low != high) ref::ewa(image, e, low, u, v, 0, 0, finer);
  for (int channel = 0; channel < 4; ++channel) {
    const double got = static_cast<double>(batch.out[channel][i]);
    if (shd_is_close(got, finer[channel], tolerance, 0)) continue;
    shd_assert_close(c.name, i, got, coarser[channel], tolerance, 0);
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
      check_combination(c, *texture, ewa_desc(pair), false);
      if (pair % 6 == 0) check_combination(c, *texture, ewa_desc(pair), true);
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
      const shd_sampler_desc desc = ewa_desc(pair);
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
    const Sampler sampler = make_sampler(ewa_desc(1));
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
    shd_sampler_desc desc = ewa_desc(round);
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
    shd_sampler_desc desc = ewa_desc(0);
    run(*texture, make_sampler(desc), target, t_batch.lookups(true, false), &t_batch);
    for (int c = 0; c < 4; ++c) {
      for (size_t i = 0; i < kPoints; ++i) assert_true(t_batch.out[c][i] == coarsest[c]);
    }
  });
  free_texture(texture);
}

/// Texels that are not finite never count with weight 0, neither beside the ellipse nor past the last tap of a lane,
/// and do count inside.
void test_nonfinite_texels(void**) {
  float texels[16 * 16 * 4];
  for (size_t i = 0; i < 256; ++i) {
    for (size_t c = 0; c < 4; ++c) texels[4 * i + c] = i % 16 == 9 ? (c % 2 ? NAN : INFINITY) : 1;
  }
  Texture* texture = make_texture(SHD_FORMAT_RGBA32F, 16, 16, reinterpret_cast<uint8_t*>(texels), false);
  t_batch.count = 64;
  for (size_t i = 0; i < 64; ++i) {
    const bool inside = i % 5 == 4;
    t_batch.u[i] = inside ? 9.0f / 16 : 7.5f / 16;  // the ellipse is 2.7 texels wide, or bilinear without weight
    t_batch.v[i] = 0.5f;
    t_batch.dudx[i] = t_batch.dvdx[i] = t_batch.dudy[i] = 0;
    t_batch.dvdx[i] = 1.0f / 16;
    t_batch.dvdy[i] = i % 3 ? 8.0f / 16 : 0;
    t_batch.dudy[i] = 0;
  }
  for_each_target([&](int64_t target) {
    shd_sampler_desc desc = ewa_desc(0);
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

/// A circle is the same by derivatives and by level of detail.
void test_isotropic(void**) {
  Texture* texture = random_texture(SHD_FORMAT_RGBA32F, 64, 32, true);
  make_points(&t_batch);
  for (size_t i = 0; i < kPoints; ++i) {
    t_batch.lod[i] = static_cast<float>(i) * 0.0371f - 0.5f;
    const float cosine = cosf(static_cast<float>(i)), sine = sinf(static_cast<float>(i)), s = exp2f(t_batch.lod[i]);
    t_batch.dudx[i] = s * cosine / 64;
    t_batch.dvdx[i] = s * sine / 32;
    t_batch.dudy[i] = -s * sine / 64;
    t_batch.dvdy[i] = s * cosine / 32;
  }
  for_each_target([&](int64_t target) {
    const Sampler sampler = make_sampler(ewa_desc(0));
    run(*texture, sampler, target, t_batch.lookups(true, false), &t_batch);
    memcpy(t_first.out, t_batch.out, sizeof t_batch.out);
    run(*texture, sampler, target, t_batch.lookups(false, true), &t_batch);
    for (int c = 0; c < 4; ++c) {
      for (size_t i = 0; i < kPoints; ++i) {
        shd_assert_close("isotropic", i, static_cast<double>(t_batch.out[c][i]), static_cast<double>(t_first.out[c][i]),
                         1e-4, 0);
      }
    }
  });
  free_texture(texture);
}

/// The derivatives of the oracle next to a point: they jump where a texel enters the ellipse.
bool is_slope_near(const ref::Image& image, const ref::Ellipse& e, int level, size_t i, const float (*got)[kMaxPoints],
                   bool along_u, int channel, double tolerance) {
  const double size = static_cast<double>(along_u ? image.levels[0].width : image.levels[0].height);
  const double step = 1e-6 / size;
  for (int near = 0; near < 9; ++near) {
    const double du = (near % 3 - 1) * 2e-4 / static_cast<double>(image.levels[0].width);
    const double dv = (near / 3 - 1) * 2e-4 / static_cast<double>(image.levels[0].height);
    double before[4], after[4];
    const double u = static_cast<double>(t_batch.u[i]), v = static_cast<double>(t_batch.v[i]);
    ref::ewa(image, e, level, u, v, along_u ? du - step : du, along_u ? dv : dv - step, before);
    ref::ewa(image, e, level, u, v, along_u ? du + step : du, along_u ? dv : dv + step, after);
    const double slope = (after[channel] - before[channel]) / (2 * step);
    if (shd_is_close(static_cast<double>(got[channel][i]), slope, tolerance * size, 0)) return true;
  }
  return false;
}

/// Derivatives in u and v carry those of the weights.
void test_derivatives(void**) {
  static float du[4][kMaxPoints], dv[4][kMaxPoints];
  for (const shd_format format : {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA32F}) {
    Texture* texture = random_texture(format, 64, 32, true);
    for (uint32_t pair = 0; pair < 25; pair += 6) {
      const shd_sampler_desc desc = ewa_desc(pair);
      ref::Level levels[shd::texture::kMaxLevels];
      const ref::Image image = oracle_image(*texture, desc, levels);
      make_points(&t_batch);
      Random random{pair + 5};
      for (size_t i = 0; i < kPoints; ++i) {
        t_batch.u[i] = random.real(-1, 2);
        t_batch.v[i] = random.real(-1, 2);
      }
      uint64_t hash = 0;
      for_each_target([&](int64_t target) {
        const Texels out = {{}, {du[0], du[1], du[2], du[3]}, {dv[0], dv[1], dv[2], dv[3]}};
        shd::texture::sample(*texture, make_sampler(desc), shd::core::simd_target_from_bit(target),
                             t_batch.lookups(true, false), out);
        const uint64_t of_target = shd_hash(shd_hash(SHD_HASH_START, du, sizeof du), dv, sizeof dv);
        assert_true(hash == 0 || hash == of_target);
        hash = of_target;
      });
      for (size_t i = 0; i < kPoints; ++i) {
        const ref::Ellipse e = ellipse_of(t_batch, image, false, i);
        const double lod = ref::ewa_lod(image, e);
        if (floor(lod - 1e-4) != floor(lod + 1e-4)) continue;
        for (int c = 0; c < 4; ++c) {
          const double tolerance = 2e-3 * fmax(magnitude(format), 1);
          assert_true(is_slope_near(image, e, static_cast<int>(lod), i, du, true, c, tolerance));
          assert_true(is_slope_near(image, e, static_cast<int>(lod), i, dv, false, c, tolerance));
        }
      }
    }
    free_texture(texture);
  }
}

/// No lookup takes more than 16 (max_anisotropy + 1) texels, nor fewer than two where the ellipse counts.
void test_taps(void**) {
  Texture* texture = random_texture(SHD_FORMAT_R8, 256, 128, true);
  Random random{3};
  uint32_t most = 0;
  for (const float limit : {1.0f, 2.0f, 16.0f, 64.0f}) {
    for (int n = 0; n < 4000; ++n) {
      shd_sampler_desc desc = ewa_desc(0);
      desc.max_anisotropy = limit;
      const Sampler sampler = make_sampler(desc);
      const float angle = random.real(0, 7), longer = exp2f(random.real(-1, 9)),
                  shorter = longer * random.real(0, 1.2f) / limit;
      const float u = random.real(0, 1), v = random.real(0, 1);
      const float dudx = longer * cosf(angle) / 256, dvdx = longer * sinf(angle) / 128;
      const float dudy = -shorter * sinf(angle) / 256, dvdy = shorter * cosf(angle) / 128;
      const Lookups lookup = {1, &u, &v, &dudx, &dvdx, &dudy, &dvdy, nullptr, nullptr, nullptr};
      shd_explanation explanation = {};
      shd::texture::explain(*context(), *texture, sampler, lookup, &explanation);
      assert_true(static_cast<float>(explanation.tap_count) <= 16 * (limit + 1));
      assert_true(explanation.tap_count >= 2);
      if (limit == 64.0f && explanation.tap_count > most) most = explanation.tap_count;
    }
  }
  assert_true(most > 512);
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
  const Sampler sampler = make_sampler(ewa_desc(0));
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
  tests[n++] = {"constant", test_constant, nullptr, nullptr, nullptr};
  tests[n++] = {"isotropic", test_isotropic, nullptr, nullptr, nullptr};
  tests[n++] = {"derivatives", test_derivatives, nullptr, nullptr, nullptr};
  tests[n++] = {"taps", test_taps, nullptr, nullptr, nullptr};
  tests[n++] = {"tails", test_tails, nullptr, nullptr, nullptr};
  tests[n++] = {"hostile_derivatives", test_hostile_derivatives, nullptr, nullptr, nullptr};
  tests[n++] = {"infinite", test_infinite, nullptr, nullptr, nullptr};
  tests[n++] = {"nonfinite_texels", test_nonfinite_texels, nullptr, nullptr, nullptr};
  tests[n++] = {"layers", test_layers, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.ewa", tests, n, nullptr, nullptr);
}
