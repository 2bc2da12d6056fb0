// SPDX-License-Identifier: MIT
// Anisotropic probes against the oracle: every format x wrap pair x size x target; equality with trilinear for a single
// probe; hostile derivatives and texels.
#include "filter_cases.h"

#include "ref/footprint_ref.h"

namespace {

using namespace fixture;

Batch t_batch, t_first;

shd_sampler_desc anisotropic_desc(uint32_t pair) {
  const float limits[] = {16, 1, 3.5f, 64, 2};
  shd_sampler_desc desc = wrap_desc(SHD_FILTER_ANISOTROPIC, pair);
  desc.max_anisotropy = limits[(pair + pair / 5) % 5];
  desc.probe_weights = pair % 2 ? SHD_PROBE_WEIGHTS_GAUSSIAN : SHD_PROBE_WEIGHTS_EQUAL;
  return desc;
}

/// Compares with the oracle, with either number of probes where rounding decides between two.
void check_point(const SizeCase& c, const ref::Image& image, const Batch& batch, bool lod, size_t i) {
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

void check_combination(const SizeCase& c, const Texture& texture, const shd_sampler_desc& desc, bool lod) {
  check_against_oracle(texture, desc, t_batch.lookups(!lod, lod), &t_batch,
                       [&](const ref::Image& image, size_t i) { check_point(c, image, t_batch, lod, i); });
}

void test_size(void** state) {
  const auto& c = *static_cast<const SizeCase*>(*state);
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
      shd_sampler_desc trilinear = desc;
      trilinear.filter = SHD_FILTER_TRILINEAR;
      check_same_bits(*texture, desc, trilinear, lod, &t_batch, &t_first);
    }
    free_texture(texture);
  }
}

void test_constant(void**) {
  check_constant_mipmap(25, anisotropic_desc);
}

void test_tails(void**) {
  check_tails_of_formats(anisotropic_desc(1), true);
}

void test_hostile_derivatives(void**) {
  check_hostile_footprints(anisotropic_desc);
}

void test_infinite(void**) {
  check_infinite(anisotropic_desc(0));
}

void test_nonfinite_texels(void**) {
  check_nonfinite_column(anisotropic_desc(0), 9.25f, 8.5f);  // the centre of column 8 has weight 0 for column 9
}

void test_layers(void**) {
  check_layers(anisotropic_desc(0));
}

}  // namespace

int main() {
  CMUnitTest tests[32];
  size_t n = add_sizes("anisotropic", test_size, tests);
  tests[n++] = {"isotropic", test_isotropic, nullptr, nullptr, nullptr};
  tests[n++] = {"constant", test_constant, nullptr, nullptr, nullptr};
  tests[n++] = {"tails", test_tails, nullptr, nullptr, nullptr};
  tests[n++] = {"hostile_derivatives", test_hostile_derivatives, nullptr, nullptr, nullptr};
  tests[n++] = {"infinite", test_infinite, nullptr, nullptr, nullptr};
  tests[n++] = {"nonfinite_texels", test_nonfinite_texels, nullptr, nullptr, nullptr};
  tests[n++] = {"layers", test_layers, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.anisotropic", tests, n, nullptr, nullptr);
}
