// SPDX-License-Identifier: MIT
// Mip levels against area averages of the base.
#include "fixture.h"

#include <new>

#include "image/srgb.h"

namespace {

using namespace fixture;

struct size_case {
  const char* name;
  uint32_t width, height;
};
const size_case k_sizes[] = {
    {"box/1x1", 1, 1},       {"box/1x7", 1, 7},         {"box/5x3", 5, 3},     {"box/2x1", 2, 1},
    {"box/64x64", 64, 64},   {"box/128x32", 128, 32},   {"box/33x65", 33, 65}, {"box/96x160", 96, 160},
    {"box/100x36", 100, 36}, {"box/4096x1", 4096, 1},   {"box/1x512", 1, 512}, {"box/256x128", 256, 128},
    {"box/127x4", 127, 4},   {"box/1000x24", 1000, 24},
};

/// Whether a stored value is nearest to `average`, or one step away if `average` is within the oracle's error of a tie.
bool is_rounded(shd_format format, const uint8_t* texel, int c, double average) {
  const ref::Layout layout = ref::layout(format);
  double maximum = 255;
  uint16_t wide = 0;
  memcpy(&wide, texel + layout.size * c, layout.size == 1 ? 1 : 2);
  double code = layout.size == 1 ? texel[c] : wide;
  switch (layout.component) {
    case ref::Layout::kFloat32: return shd_is_close(ref::decode(format, texel, c), average, 1e-13, 6.0e-8);
    case ref::Layout::kFloat16: {
      const double ulp = fmax(ldexp(1, -24), ldexp(fabs(average), -10));
      return fabs(ref::half_value(wide) - average) <= ulp / 2 + 1e-12;
    }
    case ref::Layout::kRgb9e5: {
      uint32_t word;
      memcpy(&word, texel, 4);
      const uint32_t largest = std::max(word & 511, std::max(word >> 9 & 511, word >> 18 & 511));
      return fabs(ref::rgb9e5_value(word, c) - average) <= ref::rgb9e5_unit(word) / 2 + 1e-12 &&
             (largest > 255 || word >> 27 == 0);
    }
    case ref::Layout::kSrgb8:
      if (c < 3) return fabs(code - 255 * ref::linear_to_srgb(average)) <= 0.50001;
      break;
    case ref::Layout::kUnorm16: maximum = 65535; break;
    default: break;
  }
  const double nearest = nearbyint(maximum * average);  // nearest even, as in the library
  return fabs(code - maximum * average) <= 0.5 + 1e-9 &&
         (fabs(fabs(nearest - maximum * average) - 0.5) < 1e-9 || code == nearest);
}

void test_box(void** state) {
  const auto* size = static_cast<const size_case*>(*state);
  const shd_sampler_desc sampler = shd_sampler_desc_default();
  for (const shd_format format : kFormats) {
    Texture* texture = random_texture(format, size->width, size->height, true);
    ref::Level levels[shd::texture::kMaxLevels];
    oracle_image(*texture, sampler, levels);
    const size_t bytes = shd_format_size(format);
    const int channels = static_cast<int>(shd::image::format_info(format).channels);
    const ref::Level& last = levels[texture->level_count - 1];
    assert_true(last.width == 1 && last.height == 1);
    for (uint32_t l = 1; l < texture->level_count; ++l) {
      for (int64_t y = 0; y < levels[l].height; ++y) {
        for (int64_t x = 0; x < levels[l].width; ++x) {
          const uint8_t* texel = levels[l].texels + static_cast<size_t>(y * levels[l].width + x) * bytes;
          for (int c = 0; c < channels; ++c) {
            const double want = ref::box(format, levels[0], levels[l].width, levels[l].height, x, y, c);
            if (!is_rounded(format, texel, c, want)) {
              fail_msg("format %d level %u (%d, %d) channel %d: stored %.9g, average %.9g", format, l,
                       static_cast<int>(x), static_cast<int>(y), c, ref::decode(format, texel, c), want);
            }
          }
        }
      }
    }
    free_texture(texture);
  }
}

/// Ties of 8-bit texels: the mean of 4, 4, 5, 5 is 4.5, the mean of 5, 5, 6, 6 is 5.5.
void test_ties_to_even(void**) {
  const uint8_t texels[] = {4, 5, 5, 6, 5, 4, 6, 5};
  Texture* texture = make_texture(SHD_FORMAT_R8, 4, 2, texels, true);
  const uint8_t* level = shd::texture::row_of(*texture, 0, 1, 0);
  assert_int_equal(level[0], 4);
  assert_int_equal(level[1], 6);
  free_texture(texture);
}

/// A binary16 average just above a tie must not be rounded twice.
void test_half_rounds_once(void**) {
  const uint16_t halves[] = {0x4000, 0x4001, 0x0001, 0x0000};  // 2, 2 + 2^-9, 2^-24, 0
  uint16_t texels[16];
  for (size_t i = 0; i < 16; ++i) texels[i] = halves[i / 4];
  Texture* texture = make_texture(SHD_FORMAT_RGBA16F, 4, 1, reinterpret_cast<const uint8_t*>(texels), true);
  uint16_t got;
  memcpy(&got, shd::texture::row_of(*texture, 0, 2, 0), 2);
  assert_int_equal(got, 0x3c01);  // 1 + 2^-11 is a tie between 0x3c00 and 0x3c01; the mean is 2^-26 above
  free_texture(texture);
}

void test_constant(void**) {
  const size_case sizes[] = {{"", 64, 64}, {"", 37, 23}, {"", 1023, 5}, {"", 48, 7}};
  for (const shd_format format : kFormats) {
    for (const size_case& size : sizes) {
      const size_t bytes = shd_format_size(format), count = size_t{size.width} * size.height;
      auto* texels = static_cast<uint8_t*>(malloc(count * bytes));
      random_texels(format, 1, 77, texels);
      for (size_t i = 1; i < count; ++i) memcpy(texels + i * bytes, texels, bytes);
      Texture* texture = make_texture(format, size.width, size.height, texels, true);
      for (size_t i = 0; i < shd::texture::byte_size(*texture); i += bytes) {
        assert_memory_equal(texture->texels.data() + i, texels, bytes);
      }
      free_texture(texture);
      free(texels);
    }
  }
}

/// Infinities and NaN reach exactly the texels above them.
void test_nonfinite(void**) {
  const float values[] = {INFINITY, -INFINITY, NAN};
  for (const uint32_t size : {8u, 7u}) {
    for (const float value : values) {
      auto* texels = static_cast<float*>(calloc(size_t{size} * size, 16));
      texels[0] = value;
      Texture* texture = make_texture(SHD_FORMAT_RGBA32F, size, size, reinterpret_cast<uint8_t*>(texels), true);
      for (uint32_t l = 1; l < texture->level_count; ++l) {
        float texel[8];
        memcpy(texel, shd::texture::row_of(*texture, 0, l, 0), l + 1 < texture->level_count ? 32 : 16);
        assert_true(isnan(value) ? isnan(texel[0]) : texel[0] == value);
        assert_true(texel[1] == 0);
        if (l + 1 < texture->level_count) assert_true(texel[4] == 0);
      }
      free_texture(texture);
      free(texels);
    }
  }
}

/// The largest floats average to themselves, not to infinity.
void test_largest(void**) {
  for (const uint32_t size : {16u, 9u}) {
    auto* texels = static_cast<float*>(malloc(size_t{size} * size * 16));
    for (size_t i = 0; i < size_t{size} * size * 4; ++i) texels[i] = 3.40282347e38f;
    Texture* texture = make_texture(SHD_FORMAT_RGBA32F, size, size, reinterpret_cast<uint8_t*>(texels), true);
    for (size_t i = 0; i < shd::texture::byte_size(*texture); i += 4) {
      assert_memory_equal(texture->texels.data() + i, texels, 4);
    }
    free_texture(texture);
    free(texels);
  }
}

void test_strided_rows(void**) {
  const uint8_t padded[] = {1, 2, 3, 99, 4, 5, 6, 99};
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = SHD_FORMAT_R8;
  desc.width = 3;
  desc.height = 2;
  desc.texels = padded;
  desc.row_stride = 4;
  auto* texture = shd::core::create<Texture>(context()->allocator);
  shd::texture::build(*context(), desc, texture);
  const uint8_t want[] = {1, 2, 3, 4, 5, 6};
  assert_memory_equal(texture->texels.data(), want, sizeof want);
  assert_int_equal(texture->level_count, 1);
  free_texture(texture);
}

void test_task_order(void**) {
  shd::core::Context* backwards = backwards_context();
  for (const size_case& size : k_sizes) {
    auto* texels = static_cast<uint8_t*>(malloc(size_t{size.width} * size.height * 16));
    random_texels(SHD_FORMAT_RGBA32F, size_t{size.width} * size.height, 5, texels);
    Texture* forwards = make_texture(SHD_FORMAT_RGBA32F, size.width, size.height, texels, true);
    shd_texture_desc td = shd_texture_desc_default();
    td.format = SHD_FORMAT_RGBA32F;
    td.width = size.width;
    td.height = size.height;
    td.texels = texels;
    td.tables = SHD_TABLE_MIPMAP;
    auto* other = shd::core::create<Texture>(backwards->allocator);
    shd::texture::build(*backwards, td, other);
    assert_memory_equal(forwards->texels.data(), other->texels.data(), shd::texture::byte_size(*forwards));
    free_texture(forwards);
    shd::core::destroy(backwards->allocator, other);
    free(texels);
  }
  shd::core::release(*backwards);
}

}  // namespace

int main() {
  CMUnitTest tests[32];
  size_t n = 0;
  for (const size_case& c : k_sizes) tests[n++] = {c.name, test_box, nullptr, nullptr, const_cast<size_case*>(&c)};
  tests[n++] = {"round/ties_to_even", test_ties_to_even, nullptr, nullptr, nullptr};
  tests[n++] = {"round/half_once", test_half_rounds_once, nullptr, nullptr, nullptr};
  tests[n++] = {"constant", test_constant, nullptr, nullptr, nullptr};
  tests[n++] = {"nonfinite", test_nonfinite, nullptr, nullptr, nullptr};
  tests[n++] = {"largest", test_largest, nullptr, nullptr, nullptr};
  tests[n++] = {"strided_rows", test_strided_rows, nullptr, nullptr, nullptr};
  tests[n++] = {"task_order", test_task_order, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.mip", tests, n, nullptr, nullptr);
}
