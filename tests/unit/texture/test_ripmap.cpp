// SPDX-License-Identifier: MIT
// Ripmap levels against area averages of the base, and lookups against the oracle: format x wrap pair x size x target.
#include "filter_cases.h"

#include "ref/ripmap_ref.h"

namespace {

using namespace fixture;

const SizeCase k_levels[] = {
    {"levels/1x1", 1, 1},       {"levels/1x7", 1, 7},     {"levels/5x3", 5, 3},     {"levels/64x64", 64, 64},
    {"levels/128x32", 128, 32}, {"levels/33x65", 33, 65}, {"levels/96x20", 96, 20}, {"levels/1024x1", 1024, 1},
};
Batch t_batch, t_first;
ref::Ripmap t_ripmap;

Texture* build_texture(shd_format format, uint32_t width, uint32_t height, uint32_t layers, uint32_t tables,
                       const uint8_t* texels) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = format;
  desc.width = width;
  desc.height = height;
  desc.layer_count = layers;
  desc.texels = texels;
  desc.tables = tables;
  auto* texture = shd::core::create<Texture>(context()->allocator);
  shd::texture::build(*context(), desc, texture);
  return texture;
}

Texture* random_ripmap(shd_format format, uint32_t width, uint32_t height, uint32_t layers, uint32_t tables) {
  const size_t count = size_t{width} * height * layers;
  auto* texels = static_cast<uint8_t*>(malloc(count * 16));
  random_texels(format, count, width * 31 + height, texels);
  Texture* texture = build_texture(format, width, height, layers, tables, texels);
  free(texels);
  return texture;
}

void read_levels(const Texture& texture, uint32_t layer) {
  t_ripmap.columns = static_cast<int>(texture.ripmap_columns);
  t_ripmap.rows = static_cast<int>(texture.ripmap_rows);
  for (uint32_t j = 0; j < texture.ripmap_rows; ++j) {
    for (uint32_t i = 0; i < texture.ripmap_columns; ++i) {
      t_ripmap.levels[j][i] = {shd::texture::ripmap_row(texture, layer, i, j, 0),
                               shd::texture::level_size(texture.width, i), shd::texture::level_size(texture.height, j)};
    }
  }
}

/// Half the distance between stored values around `value`, plus the error of the oracle.
double rounding(shd_format format, const uint8_t* texel, int c, double value) {
  uint32_t word;
  switch (ref::layout(format).component) {
    case ref::Layout::kFloat32: return fabs(value) * 6.0e-8 + 1e-13;
    case ref::Layout::kFloat16: return fmax(ldexp(1, -25), ldexp(fabs(value), -11)) + 1e-12;
    case ref::Layout::kUnorm16: return 0.5 / 65535 + 1e-12;
    case ref::Layout::kRgb9e5: memcpy(&word, texel, 4); return ref::rgb9e5_unit(word) / 2 + 1e-12;
    case ref::Layout::kSrgb8:
      if (c < 3) {
        const double code = 255 * ref::linear_to_srgb(value);
        return ref::srgb_to_linear((code + 0.51) / 255) - ref::srgb_to_linear(fmax(code - 0.51, 0) / 255);
      }
      return 0.5 / 255 + 1e-12;
    default: return 0.5 / 255 + 1e-12;
  }
}

void check_level(shd_format format, const ref::Level& level) {
  const size_t bytes = shd_format_size(format);
  for (int64_t y = 0; y < level.height; ++y) {
    for (int64_t x = 0; x < level.width; ++x) {
      const uint8_t* texel = level.texels + static_cast<size_t>(y * level.width + x) * bytes;
      for (int c = 0; c < ref::layout(format).channels; ++c) {
        const double want = ref::box(format, t_ripmap.levels[0][0], level.width, level.height, x, y, c);
        shd_assert_close("level", static_cast<size_t>(x), ref::decode(format, texel, c), want,
                         rounding(format, texel, c, want), 0);
      }
    }
  }
}

void test_levels(void** state) {
  const auto& size = *static_cast<const SizeCase*>(*state);
  for (const shd_format format : kFormats) {
    for (const uint32_t tables : {1u * SHD_TABLE_RIPMAP, 1u * SHD_TABLE_RIPMAP | SHD_TABLE_MIPMAP}) {
      Texture* texture = random_ripmap(format, size.width, size.height, 2, tables);
      for (uint32_t layer = 0; layer < 2; ++layer) {
        read_levels(*texture, layer);
        for (int j = 0; j < t_ripmap.rows; ++j) {
          for (int i = 0; i < t_ripmap.columns; ++i) check_level(format, t_ripmap.levels[j][i]);
        }
      }
      free_texture(texture);
    }
  }
}

/// The memory is at most four times the base, also with a mipmap.
void test_memory(void**) {
  const uint32_t sizes[][2] = {{1, 1}, {1, 7}, {64, 64}, {128, 32}, {1023, 511}, {1024, 1024}, {4096, 1}};
  for (const auto& size : sizes) {
    for (const uint32_t tables : {1u * SHD_TABLE_RIPMAP, 1u * SHD_TABLE_RIPMAP | SHD_TABLE_MIPMAP}) {
      Texture* texture = random_ripmap(SHD_FORMAT_RGBA8, size[0], size[1], 1, tables);
      const size_t base = size_t{4} * size[0] * size[1];
      assert_true(shd::texture::byte_size(*texture) <= 4 * base);
      size_t texels = 0;
      for (uint32_t w = size[0]; w; w /= 2) {
        for (uint32_t h = size[1]; h; h /= 2) texels += size_t{w} * h;
      }
      assert_int_equal(shd::texture::byte_size(*texture), 4 * texels);
      free_texture(texture);
    }
  }
}

void check_points(const Texture& texture, const shd_sampler_desc& desc, bool lod) {
  const double m = fmax(magnitude(texture.format), 2), w = texture.width, h = texture.height;
  const double tolerance = m * (8e-6 + 3e-7 + 8e-7 * (w + h));
  for (size_t i = 0; i < t_batch.count; ++i) {
    const auto real = [&](const float* column) { return static_cast<double>(column[i]); };
    const double lambda_u = lod ? real(t_batch.lod) : ref::axis_lambda(real(t_batch.dudx), real(t_batch.dudy), w);
    const double lambda_v = lod ? real(t_batch.lod) : ref::axis_lambda(real(t_batch.dvdx), real(t_batch.dvdy), h);
    for (int c = 0; c < 4; ++c) {
      const double want =
          ref::ripmap(texture.format, t_ripmap, desc, real(t_batch.u), real(t_batch.v), lambda_u, lambda_v, c);
      shd_assert_close("point", i, static_cast<double>(t_batch.out[c][i]), want, tolerance, 0);
    }
  }
}

void check_combination(const Texture& texture, const shd_sampler_desc& desc, bool lod) {
  assert_int_equal(run_everywhere(texture, desc, t_batch.lookups(!lod, lod), &t_batch), kNonfinitePoints);
  check_points(texture, desc, lod);
}

void test_lookup(void** state) {
  const auto& size = *static_cast<const SizeCase*>(*state);
  make_points(&t_batch);
  for (const shd_format format : kFormats) {
    Texture* texture = random_ripmap(format, size.width, size.height, 1, SHD_TABLE_RIPMAP);
    read_levels(*texture, 0);
    for (uint32_t pair = 0; pair < 25; ++pair) {
      shd_sampler_desc desc = wrap_desc(SHD_FILTER_RIPMAP, pair);
      check_combination(*texture, desc, false);
      desc.lod_bias = 0.75f;
      desc.lod_min = 0.5f;
      desc.lod_max = 3.25f;
      check_combination(*texture, desc, pair % 2 == 0);
    }
    free_texture(texture);
  }
}

void test_tails(void**) {
  for (const shd_format format : kFormats) {
    Texture* texture = random_ripmap(format, 64, 32, 1, SHD_TABLE_RIPMAP);
    shd_sampler_desc desc = shd_sampler_desc_default();
    desc.filter = SHD_FILTER_RIPMAP;
    check_tails(*texture, desc, true);
    check_unwanted_channels(*texture, desc);
    free_texture(texture);
  }
}

void test_constant(void**) {
  for (const shd_format format : kFormats) {
    uint8_t texels[23 * 18 * 16];
    constant_texels(format, 23 * 18, texels);
    Texture* texture = build_texture(format, 23, 18, 1, SHD_TABLE_RIPMAP, texels);
    for (const shd_wrap wrap : {SHD_WRAP_REPEAT, SHD_WRAP_CLAMP, SHD_WRAP_MIRROR, SHD_WRAP_MIRROR_ONCE}) {
      shd_sampler_desc desc = shd_sampler_desc_default();
      desc.filter = SHD_FILTER_RIPMAP;
      desc.wrap_u = desc.wrap_v = wrap;
      check_constant(*texture, desc, true);
    }
    free_texture(texture);
  }
}

/// For equal footprints along the axes, and with the lod column, a ripmap lookup equals a trilinear one except for the
/// levels off the diagonal. At whole levels both are equal.
void test_whole_levels(void**) {
  Texture* texture = random_ripmap(SHD_FORMAT_RGBA8, 64, 64, 1, SHD_TABLE_RIPMAP | SHD_TABLE_MIPMAP);
  shd_sampler_desc desc = shd_sampler_desc_default();
  const Sampler trilinear = make_sampler(desc);
  desc.filter = SHD_FILTER_RIPMAP;
  const Sampler ripmap = make_sampler(desc);
  make_points(&t_batch);
  for (size_t i = 0; i < t_batch.count; ++i) t_batch.lod[i] = static_cast<float>(i % 9);
  for_each_target([&](int64_t target) {
    run(*texture, trilinear, target, t_batch.lookups(false, true), &t_batch);
    memcpy(t_first.out, t_batch.out, sizeof t_batch.out);
    run(*texture, ripmap, target, t_batch.lookups(false, true), &t_batch);
    assert_memory_equal(t_first.out, t_batch.out, sizeof t_batch.out);
  });
  free_texture(texture);
}

struct lod_case {
  const char* name;
  float j[4];  // dudx, dvdx, dudy, dvdy in base texels of 256 x 64
  double u, v;
};
const float k_inf = INFINITY;
const lod_case k_lods[] = {
    {"lod/zero", {0, 0, 0, 0}, 0, 0},
    {"lod/denormal", {1e-42f, -1e-42f, 1e-42f, 0}, 0, 0},
    {"lod/1e-30", {1e-30f, 1e-30f, 1e-30f, 1e-30f}, 0, 0},
    {"lod/axes", {4, 0, 0, 16}, 2, 4},
    {"lod/swapped", {0, 16, 4, 0}, 2, 4},
    {"lod/diagonal", {4, 4, 4, 4}, 2.5, 2.5},
    {"lod/one_axis", {64, 0, 0, 0}, 6, 0},
    {"lod/larger_than_texture", {1e6f, 0, 0, 1e6f}, 8, 6},
    {"lod/1e30", {1e30f, 1e30f, -1e30f, 1e30f}, 8, 6},
    {"lod/flt_max", {3.4e38f, 3.4e38f, 3.4e38f, -3.4e38f}, 8, 6},
    {"lod/infinite_u", {k_inf, 2, 0, 0}, 8, 1},
    {"lod/infinite_v", {2, 0, 0, -k_inf}, 1, 6},
    {"lod/nan", {NAN, NAN, 2, 4}, 1, 2},
    {"lod/all_nan", {NAN, NAN, NAN, NAN}, 0, 0},
    {"lod/infinite_and_nan", {k_inf, NAN, NAN, 2}, 8, 1},
};

/// A texture with i in red and j in green of level (i, j) shows the levels of detail.
void test_lod(void** state) {
  const auto& c = *static_cast<const lod_case*>(*state);
  Texture* texture = random_ripmap(SHD_FORMAT_RGBA32F, 256, 64, 1, SHD_TABLE_RIPMAP);
  for (uint32_t j = 0; j < texture->ripmap_rows; ++j) {
    for (uint32_t i = 0; i < texture->ripmap_columns; ++i) {
      auto* values = reinterpret_cast<float*>(const_cast<uint8_t*>(shd::texture::ripmap_row(*texture, 0, i, j, 0)));
      const size_t texels = size_t{256u >> i} * (64u >> j);
      for (size_t k = 0; k < texels; ++k) {
        values[4 * k] = static_cast<float>(i);
        values[4 * k + 1] = static_cast<float>(j);
      }
    }
  }
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = SHD_FILTER_RIPMAP;
  desc.profile = SHD_PROFILE_EXACT;
  t_batch.count = 19;
  bool finite = true;
  for (const float entry : c.j) finite = finite && isfinite(entry);
  for (size_t i = 0; i < t_batch.count; ++i) {
    t_batch.u[i] = t_batch.v[i] = 0.3f;
    t_batch.dudx[i] = c.j[0] / 256;
    t_batch.dvdx[i] = c.j[1] / 64;
    t_batch.dudy[i] = c.j[2] / 256;
    t_batch.dvdy[i] = c.j[3] / 64;
  }
  for_each_target([&](int64_t target) {
    const size_t bad = run(*texture, make_sampler(desc), target, t_batch.lookups(true, false), &t_batch);
    assert_int_equal(bad, finite ? 0 : t_batch.count);
    for (size_t i = 0; i < t_batch.count; ++i) {
      shd_assert_close(c.name, i, static_cast<double>(t_batch.out[0][i]), c.u, 2e-6, 0);
      shd_assert_close(c.name, i, static_cast<double>(t_batch.out[1][i]), c.v, 2e-6, 0);
    }
  });
  free_texture(texture);
}

/// A non-finite level counts only if its weight along its axis is not 0.
void test_nonfinite_levels(void**) {
  Texture* texture = random_ripmap(SHD_FORMAT_RGBA32F, 8, 8, 1, SHD_TABLE_RIPMAP);
  for (uint32_t j = 0; j < 4; ++j) {
    auto* values = reinterpret_cast<float*>(const_cast<uint8_t*>(shd::texture::ripmap_row(*texture, 0, 2, j, 0)));
    for (size_t k = 0; k < size_t{4} * 2 * (8u >> j); ++k) values[k] = k % 2 ? NAN : INFINITY;
  }
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = SHD_FILTER_RIPMAP;
  const float lods[] = {0, 1, 1.0000001f, 1.5f, 2, 2.5f, 3, 0.5f};
  t_batch.count = 64;
  for (size_t i = 0; i < t_batch.count; ++i) {
    t_batch.u[i] = t_batch.v[i] = 0.6f;
    t_batch.lod[i] = lods[i % 8];
  }
  for_each_target([&](int64_t target) {
    run(*texture, make_sampler(desc), target, t_batch.lookups(false, true), &t_batch);
    for (size_t i = 0; i < t_batch.count; ++i) {
      const bool reached = lods[i % 8] > 1 && lods[i % 8] < 3;
      assert_true(isinf(t_batch.out[0][i]) == reached);
      assert_true(isnan(t_batch.out[1][i]) == reached);
      assert_true(reached || isfinite(t_batch.out[0][i]));
    }
  });
  free_texture(texture);
}

/// Layers are looked up separately; indices beyond the last layer use the last.
void test_layers(void**) {
  constexpr uint32_t kLayers = 3;
  Texture* texture = random_ripmap(SHD_FORMAT_RGBA8, 17, 12, kLayers, SHD_TABLE_RIPMAP);
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = SHD_FILTER_RIPMAP;
  desc.profile = SHD_PROFILE_EXACT;
  make_points(&t_batch);
  static uint32_t layer[kMaxPoints];
  for (uint32_t k = 0; k < kLayers + 1; ++k) {
    for (uint32_t& l : layer) l = k == kLayers ? 0xffffffffu : k;
    read_levels(*texture, k < kLayers ? k : kLayers - 1);
    for_each_target([&](int64_t target) {
      Lookups lookups = t_batch.lookups(true, false);
      lookups.layer = layer;
      run(*texture, make_sampler(desc), target, lookups, &t_batch);
      check_points(*texture, desc, false);
    });
  }
  free_texture(texture);
}

}  // namespace

int main() {
  CMUnitTest tests[64];
  size_t n = 0;
  for (const SizeCase& c : k_levels) tests[n++] = {c.name, test_levels, nullptr, nullptr, const_cast<SizeCase*>(&c)};
  n += add_sizes("lookup", test_lookup, tests + n);
  for (const lod_case& c : k_lods) tests[n++] = {c.name, test_lod, nullptr, nullptr, const_cast<lod_case*>(&c)};
  tests[n++] = {"memory", test_memory, nullptr, nullptr, nullptr};
  tests[n++] = {"tails", test_tails, nullptr, nullptr, nullptr};
  tests[n++] = {"constant", test_constant, nullptr, nullptr, nullptr};
  tests[n++] = {"whole_levels", test_whole_levels, nullptr, nullptr, nullptr};
  tests[n++] = {"nonfinite_levels", test_nonfinite_levels, nullptr, nullptr, nullptr};
  tests[n++] = {"layers", test_layers, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.ripmap", tests, n, nullptr, nullptr);
}
