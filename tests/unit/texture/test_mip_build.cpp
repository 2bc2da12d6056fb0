// SPDX-License-Identifier: MIT
// shd_mip_build against its oracle and against the levels of textures; preservation of constants, energy, coverage and
// normals; worker counts.
#define _POSIX_C_SOURCE 200809L
#include "fixture.h"

#include <shd/shd.h>

#include "ref/mip_ref.h"
#include "support/pool.h"

namespace {

using namespace fixture;

/// An image and its levels in separate memory, freed with free_chain.
struct Chain {
  uint32_t count;
  shd_image base, levels[16];
};

Chain* make_chain(shd_format format, uint32_t width, uint32_t height, uint32_t seed) {
  auto* chain = static_cast<Chain*>(calloc(1, sizeof(Chain)));
  for (uint32_t l = 0; l == 0 || (width >> l | height >> l) != 0; ++l) {
    shd_image image = shd_image_default();
    image.format = format;
    image.width = shd::texture::level_size(width, l);
    image.height = shd::texture::level_size(height, l);
    image.pixels = calloc(size_t{image.width} * image.height, shd_format_size(format));
    if (l == 0) {
      random_texels(format, size_t{width} * height, seed, static_cast<uint8_t*>(image.pixels));
      chain->base = image;
    } else {
      chain->levels[l - 1] = image;
      chain->count = l;
    }
  }
  return chain;
}

void free_chain(Chain* chain) {
  free(chain->base.pixels);
  for (uint32_t l = 0; l < chain->count; ++l) free(chain->levels[l].pixels);
  free(chain);
}

void build(Chain* chain, const shd_mip_desc& desc) {
  static shd_context* made = nullptr;
  if (!made) shd_assert_ok(shd_context_create(nullptr, &made));
  shd_assert_ok(shd_mip_build(made, &chain->base, &desc, chain->count, chain->levels));
}

size_t channels_of(const shd_image& image) {
  return shd::image::format_info(image.format).channels;
}
size_t texels_of(const shd_image& image) {
  return size_t{image.width} * image.height;
}

/// Linear value of a channel of texel i; the oracle's decode does not support three channels.
double value_of(const shd_image& image, size_t i, size_t c) {
  const auto info = shd::image::format_info(image.format);
  const auto* texel = static_cast<const uint8_t*>(image.pixels) + i * info.pixel_size + c * info.channel_size;
  switch (info.component) {
    case Component::kUnorm8: return ref::decode(SHD_FORMAT_R8, texel, 0);
    case Component::kSrgb8: return ref::decode(c == 3 ? SHD_FORMAT_R8 : SHD_FORMAT_R8_SRGB, texel, 0);
    case Component::kUnorm16: return ref::decode(SHD_FORMAT_R16, texel, 0);
    case Component::kFloat16: return ref::decode(SHD_FORMAT_R16F, texel, 0);
    default: return ref::decode(SHD_FORMAT_R32F, texel, 0);
  }
}

double* plane_of(const shd_image& image, size_t c) {
  auto* plane = static_cast<double*>(malloc(texels_of(image) * sizeof(double)));
  for (size_t i = 0; i < texels_of(image); ++i) plane[i] = value_of(image, i, c);
  return plane;
}

/// Distance of a stored value from `want` in steps of the format; at most 1/2 if it is rounded once.
double steps_off(Component component, size_t c, double got, double want) {
  switch (component) {
    case Component::kUnorm8: return fabs(got - fmin(fmax(want, 0), 1)) * 255;
    case Component::kUnorm16: return fabs(got - fmin(fmax(want, 0), 1)) * 65535;
    case Component::kSrgb8:
      want = fmin(fmax(want, 0), 1);
      return c == 3 ? fabs(got - want) * 255 : fabs(ref::linear_to_srgb(got) - ref::linear_to_srgb(want)) * 255;
    case Component::kFloat16: return fabs(got - want) / fmax(ldexp(1, -24), ldexp(fmax(fabs(got), fabs(want)), -10));
    default: return fabs(got - want) / (1e-7 * fabs(want) + 1e-7);
  }
}

struct Case {
  const char* name;
  shd_mip_kernel kernel;
};
const Case k_kernels[] = {{"oracle/box", SHD_MIP_KERNEL_BOX},
                          {"oracle/triangle", SHD_MIP_KERNEL_TRIANGLE},
                          {"oracle/kaiser", SHD_MIP_KERNEL_KAISER},
                          {"oracle/lanczos", SHD_MIP_KERNEL_LANCZOS}};
struct Size {
  uint32_t width, height;
};
const Size k_sizes[] = {{1, 1}, {1, 7}, {5, 3}, {64, 64}, {128, 32}, {1023, 511}};
const shd_format k_formats[] = {SHD_FORMAT_RGBA8, SHD_FORMAT_RGB8_SRGB, SHD_FORMAT_RG16, SHD_FORMAT_RGB16F,
                                SHD_FORMAT_R32F};

void compare_with_oracle(const Chain& chain, const shd_mip_desc& desc, uint32_t max_levels) {
  for (uint32_t l = 0; l < chain.count && l < max_levels; ++l) {
    const shd_image& level = chain.levels[l];
    const shd_image& source = desc.source == SHD_MIP_SOURCE_BASE || l == 0 ? chain.base : chain.levels[l - 1];
    for (size_t c = 0; c < channels_of(source); ++c) {
      double* values = plane_of(source, c);
      double* want = ref::mip_filter(desc, values, source.width, source.height, level.width, level.height);
      free(values);
      for (size_t i = 0; i < texels_of(level); ++i) {
        const double got = value_of(level, i, c);
        const double off = steps_off(shd::image::format_info(level.format).component, c, got, want[i]);
        if (!(off <= 0.5001)) {
          fail_msg("format %d, %u x %u, wrap %d, source %d, level %u, texel %zu, channel %zu: %.9g, not %.9g",
                   level.format, chain.base.width, chain.base.height, desc.wrap_u, desc.source, l + 1, i, c, got,
                   want[i]);
        }
      }
      free(want);
    }
  }
}

void test_oracle(void** state) {
  shd_mip_desc desc = shd_mip_desc_default();
  desc.kernel = static_cast<const Case*>(*state)->kernel;
  int chains = 0;
  for (const Size& size : k_sizes) {
    const bool large = size.width > 1000;
    for (const shd_format format : k_formats) {
      if (large && format != SHD_FORMAT_R32F) continue;
      Chain* chain = make_chain(format, size.width, size.height, 7);
      for (int wrap = SHD_WRAP_REPEAT; wrap <= SHD_WRAP_MIRROR_ONCE; ++wrap) {
        desc.wrap_u = static_cast<shd_wrap>(wrap);
        desc.wrap_v = static_cast<shd_wrap>((wrap + 1) % 5);
        for (const shd_mip_source source : {SHD_MIP_SOURCE_BASE, SHD_MIP_SOURCE_PREVIOUS}) {
          if (large && source != SHD_MIP_SOURCE_BASE) continue;
          desc.source = source;
          build(chain, desc);
          if (chains++ % SHD_ORACLE_STRIDE == 0) compare_with_oracle(*chain, desc, large ? 2 : 16);
        }
      }
      free_chain(chain);
    }
  }
}

/// The defaults give the levels that textures build themselves.
void test_as_textures(void**) {
  for (const Size& size : k_sizes) {
    for (const shd_format format : kFormats) {
      Chain* chain = make_chain(format, size.width, size.height, 3);
      build(chain, shd_mip_desc_default());
      Texture* texture =
          make_texture(format, size.width, size.height, static_cast<const uint8_t*>(chain->base.pixels), true);
      assert_int_equal(texture->level_count, chain->count + 1);
      for (uint32_t l = 1; l <= chain->count; ++l) {
        assert_memory_equal(shd::texture::row_of(*texture, 0, l, 0), chain->levels[l - 1].pixels,
                            texels_of(chain->levels[l - 1]) * shd_format_size(format));
      }
      free_texture(texture);
      free_chain(chain);
    }
  }
}

/// Every kernel, wrap and semantic keeps a constant image, bit for bit.
void test_constant(void**) {
  shd_mip_desc desc = shd_mip_desc_default();
  for (const Size& size : k_sizes) {
    for (const shd_format format : k_formats) {
      const size_t bytes = shd_format_size(format);
      Chain* chain = make_chain(format, size.width > 1000 ? 51 : size.width, size.height, 11);
      auto* texels = static_cast<uint8_t*>(chain->base.pixels);
      for (size_t i = 1; i < texels_of(chain->base); ++i) memcpy(texels + i * bytes, texels, bytes);
      for (int i = 0; i < 4 * 5 * 2; ++i) {
        desc.kernel = static_cast<shd_mip_kernel>(i % 4);
        desc.wrap_u = desc.wrap_v = static_cast<shd_wrap>(i / 4 % 5);
        desc.content = i < 20 ? SHD_TEXEL_CONTENT_COLOR : SHD_TEXEL_CONTENT_DATA;
        build(chain, desc);
        for (uint32_t l = 0; l < chain->count; ++l) {
          const auto* level = static_cast<const uint8_t*>(chain->levels[l].pixels);
          for (size_t t = 0; t < texels_of(chain->levels[l]); ++t)
            assert_memory_equal(level + t * bytes, texels, bytes);
        }
      }
      free_chain(chain);
    }
  }
}

double mean_of(const shd_image& image) {
  double sum = 0;
  for (size_t i = 0; i < texels_of(image); ++i) sum += value_of(image, i, 0);
  return sum / static_cast<double>(texels_of(image));
}

/// The mean of every level equals the mean of the base: exactly for the box at any size, and for the triangle with a
/// wrapping border; windowed sincs sum to 1 within a percent.
void test_energy(void**) {
  for (const Size& size : k_sizes) {
    for (const Case& kernel : k_kernels) {
      const bool even = size.width == 64 || size.width == 128;
      if (!even && kernel.kernel != SHD_MIP_KERNEL_BOX) continue;
      shd_mip_desc desc = shd_mip_desc_default();
      desc.kernel = kernel.kernel;
      Chain* chain = make_chain(SHD_FORMAT_R32F, size.width, size.height, 23);
      auto* texels = static_cast<float*>(chain->base.pixels);
      for (size_t i = 0; i < texels_of(chain->base); ++i) texels[i] += 9;
      build(chain, desc);
      const double mean = mean_of(chain->base);
      for (uint32_t l = 0; l < chain->count; ++l) {
        shd_assert_close(kernel.name, l, mean_of(chain->levels[l]), mean, 0,
                         kernel.kernel <= SHD_MIP_KERNEL_TRIANGLE ? 1e-6 : 1e-2);
      }
      free_chain(chain);
    }
  }
}

size_t covered(const shd_image& image, double cutoff) {
  size_t count = 0;
  for (size_t i = 0; i < texels_of(image); ++i) count += value_of(image, i, 3) >= cutoff;
  return count;
}

/// The coverage of every level equals the coverage of the base, to the nearest texel.
void test_coverage(void**) {
  shd_mip_desc desc = shd_mip_desc_default();
  desc.content = SHD_TEXEL_CONTENT_ALPHA_COVERAGE;
  for (const shd_format format :
       {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA16, SHD_FORMAT_RGBA16F, SHD_FORMAT_RGBA32F}) {
    for (const float cutoff : {0.25f, 0.5f, 0.8f}) {
      for (const shd_mip_kernel kernel : {SHD_MIP_KERNEL_TRIANGLE, SHD_MIP_KERNEL_KAISER}) {
        for (const Size& size : {Size{64, 64}, Size{128, 32}, Size{37, 53}}) {
          Chain* chain = make_chain(format, size.width, size.height, 31);
          auto* texels = static_cast<float*>(chain->base.pixels);
          if (format == SHD_FORMAT_RGBA32F) {
            for (size_t i = 0; i < 4 * texels_of(chain->base); ++i) texels[i] = texels[i] / 16 + 0.5f;
          }
          desc.alpha_cutoff = cutoff;
          desc.kernel = kernel;
          build(chain, desc);
          const double part = static_cast<double>(covered(chain->base, static_cast<double>(cutoff))) /
                              static_cast<double>(texels_of(chain->base));
          for (uint32_t l = 0; l < chain->count; ++l) {
            const size_t got = covered(chain->levels[l], static_cast<double>(cutoff));
            const double want = part * static_cast<double>(texels_of(chain->levels[l]));
            if (fabs(static_cast<double>(got) - want) > 1) {
              fail_msg("format %d, cutoff %g, %u x %u, level %u: %zu texels, want %g", format,
                       static_cast<double>(cutoff), size.width, size.height, l + 1, got, want);
            }
          }
          free_chain(chain);
        }
      }
    }
  }
}

/// Random unit vectors around +z, in the base of a chain.
void set_normals(Chain* chain) {
  const auto info = shd::image::format_info(chain->base.format);
  Random random{5};
  for (size_t i = 0; i < texels_of(chain->base); ++i) {
    const double x = static_cast<double>(random.real(-1, 1)), y = static_cast<double>(random.real(-1, 1));
    const double length = sqrt(x * x + y * y + 1), unit[] = {x / length, y / length, 1 / length, 1};
    auto* texel = static_cast<uint8_t*>(chain->base.pixels) + i * info.pixel_size;
    for (size_t c = 0; c < info.channels; ++c) {
      const auto value = static_cast<float>(unit[c]);
      const auto code16 = static_cast<uint16_t>(lrint((unit[c] + 1) / 2 * 65535));
      if (info.component == Component::kFloat32) memcpy(texel + 4 * c, &value, 4);
      if (info.component == Component::kUnorm16) memcpy(texel + 2 * c, &code16, 2);
      if (info.component == Component::kUnorm8) texel[c] = static_cast<uint8_t>(lrint((unit[c] + 1) / 2 * 255));
    }
  }
}

double vector_of(const shd_image& image, size_t i, size_t c) {
  const double value = value_of(image, i, c);
  return shd::image::format_info(image.format).component == Component::kFloat32 ? value : 2 * value - 1;
}

/// Normals of the levels are unit and have the direction of the mean; the fourth channel is the length of the mean.
void test_normals(void**) {
  const struct {
    shd_format format;
    double step;
  } formats[] = {{SHD_FORMAT_RGB8, 2.0 / 255},
                 {SHD_FORMAT_RGBA8, 2.0 / 255},
                 {SHD_FORMAT_RGBA16, 2.0 / 65535},
                 {SHD_FORMAT_RGB32F, 1e-6},
                 {SHD_FORMAT_RGBA32F, 1e-6}};
  shd_mip_desc desc = shd_mip_desc_default();
  desc.content = SHD_TEXEL_CONTENT_NORMAL;
  for (const auto& format : formats) {
    for (const shd_mip_source source : {SHD_MIP_SOURCE_BASE, SHD_MIP_SOURCE_PREVIOUS}) {
      Chain* chain = make_chain(format.format, 32, 32, 1);
      set_normals(chain);
      desc.source = source;
      build(chain, desc);
      for (uint32_t l = 0; l < chain->count; ++l) {
        const shd_image& level = chain->levels[l];
        for (size_t i = 0; i < texels_of(level); ++i) {
          const size_t x = i % level.width, y = i / level.width, block = size_t{32} / level.width;
          double mean[3] = {}, dot = 0, square = 0;
          for (size_t t = 0; t < block * block; ++t) {
            const size_t texel = (y * block + t / block) * 32 + x * block + t % block;
            for (size_t c = 0; c < 3; ++c) {
              mean[c] += vector_of(chain->base, texel, c) / static_cast<double>(block * block);
            }
          }
          const double length = sqrt(mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2]);
          for (size_t c = 0; c < 3; ++c) {
            const double got = vector_of(level, i, c);
            square += got * got;
            dot += got * mean[c] / length;
          }
          shd_assert_close("length", i, sqrt(square), 1, format.step, 0);
          if (channels_of(level) == 4 || source == SHD_MIP_SOURCE_BASE) {
            shd_assert_close("direction", i, dot, 1, 1.5 * format.step, 0);
          }
          if (channels_of(level) == 4) {
            shd_assert_close("mean", i, value_of(level, i, 3), fmin(length, 1), 1.5 * format.step, 0);
          }
        }
      }
      free_chain(chain);
    }
  }
}

/// Opposite vectors have no mean: (0, 0, 1) of length 0.
void test_no_mean(void**) {
  Chain* chain = make_chain(SHD_FORMAT_RGBA32F, 2, 1, 1);
  const float texels[] = {1, 0, 0, 1, -1, 0, 0, 1}, want[] = {0, 0, 1, 0};
  memcpy(chain->base.pixels, texels, sizeof texels);
  shd_mip_desc desc = shd_mip_desc_default();
  desc.content = SHD_TEXEL_CONTENT_NORMAL;
  build(chain, desc);
  assert_memory_equal(chain->levels[0].pixels, want, sizeof want);
  free_chain(chain);
}

/// Data in an sRGB format is filtered as codes, without the sRGB curve.
void test_data(void**) {
  shd_mip_desc desc = shd_mip_desc_default();
  desc.kernel = SHD_MIP_KERNEL_LANCZOS;
  Chain* codes = make_chain(SHD_FORMAT_RGBA8, 37, 20, 9);
  Chain* encoded = make_chain(SHD_FORMAT_RGBA8_SRGB, 37, 20, 9);
  build(codes, desc);
  for (const shd_texel_content semantic : {SHD_TEXEL_CONTENT_DATA, SHD_TEXEL_CONTENT_HEIGHT}) {
    desc.content = semantic;
    build(encoded, desc);
    for (uint32_t l = 0; l < codes->count; ++l) {
      assert_memory_equal(codes->levels[l].pixels, encoded->levels[l].pixels, texels_of(codes->levels[l]) * 4);
    }
  }
  free_chain(codes);
  free_chain(encoded);
}

/// Steps overshoot with negative lobes; the largest floats stay finite.
void test_largest(void**) {
  shd_mip_desc desc = shd_mip_desc_default();
  desc.kernel = SHD_MIP_KERNEL_LANCZOS;
  Chain* chain = make_chain(SHD_FORMAT_R32F, 32, 1, 1);
  auto* texels = static_cast<float*>(chain->base.pixels);
  for (size_t i = 0; i < 32; ++i) texels[i] = i < 16 ? 3.40282347e38f : -3.40282347e38f;
  build(chain, desc);
  for (uint32_t l = 0; l < chain->count; ++l) {
    for (size_t i = 0; i < texels_of(chain->levels[l]); ++i) assert_true(isfinite(value_of(chain->levels[l], i, 0)));
  }
  free_chain(chain);
}

/// The bits are equal for 1 to 8 workers with unusual task orders.
void test_workers(void**) {
  shd_mip_desc desc = shd_mip_desc_default();
  desc.kernel = SHD_MIP_KERNEL_KAISER;
  desc.content = SHD_TEXEL_CONTENT_ALPHA_COVERAGE;
  uint64_t want = 0;
  for (uint32_t workers = 1; workers <= 8; ++workers) {
    shd_pool pool = {workers, static_cast<shd_pool_order>(workers % 3), workers};
    const shd_context_desc settings = shd_pool_context_desc(&pool);
    shd_context* made = nullptr;
    shd_assert_ok(shd_context_create(&settings, &made));
    Chain* chain = make_chain(SHD_FORMAT_RGBA16F, 101, 67, 13);
    shd_assert_ok(shd_mip_build(made, &chain->base, &desc, chain->count, chain->levels));
    uint64_t hash = SHD_HASH_START;
    for (uint32_t l = 0; l < chain->count; ++l) {
      hash = shd_hash(hash, chain->levels[l].pixels, texels_of(chain->levels[l]) * 8);
    }
    if (workers == 1) want = hash;
    assert_true(hash == want);
    free_chain(chain);
    shd_context_release(made);
  }
}

}  // namespace

int main() {
  CMUnitTest tests[16];
  size_t n = 0;
  for (const Case& c : k_kernels) tests[n++] = {c.name, test_oracle, nullptr, nullptr, const_cast<Case*>(&c)};
  tests[n++] = {"as_textures", test_as_textures, nullptr, nullptr, nullptr};
  tests[n++] = {"constant", test_constant, nullptr, nullptr, nullptr};
  tests[n++] = {"energy", test_energy, nullptr, nullptr, nullptr};
  tests[n++] = {"coverage", test_coverage, nullptr, nullptr, nullptr};
  tests[n++] = {"normals", test_normals, nullptr, nullptr, nullptr};
  tests[n++] = {"no_mean", test_no_mean, nullptr, nullptr, nullptr};
  tests[n++] = {"data", test_data, nullptr, nullptr, nullptr};
  tests[n++] = {"largest", test_largest, nullptr, nullptr, nullptr};
  tests[n++] = {"workers", test_workers, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.mip_build", tests, n, nullptr, nullptr);
}
