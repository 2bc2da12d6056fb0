// SPDX-License-Identifier: MIT
// Comparison lookups on every target: bits of lookups of a texture whose texels are the numbers 0 and 1 of the
// comparison (ref/comparison_ref.h), in every domain, format and filter, with all wraps, references and tails.
#include <vector>

#include "filter_cases.h"

#include "ref/comparison_ref.h"
#include "texture/store/reader.h"

namespace {

using namespace fixture;

struct TextureCase {
  const char* name;
  uint32_t width, height, layers, depth;
  shd_projection projection;
  std::vector<shd_format> formats;
};
const TextureCase k_textures[] = {
    {"1x1", 1, 1, 1, 0, SHD_PROJECTION_NONE, {SHD_FORMAT_R8, SHD_FORMAT_RGBA32F}},
    {"37x24", 37, 24, 1, 0, SHD_PROJECTION_NONE, {std::begin(kFormats), std::end(kFormats)}},
    {"array", 5, 3, 3, 0, SHD_PROJECTION_NONE, {SHD_FORMAT_R16, SHD_FORMAT_R32F}},
    {"blocks", 13, 9, 2, 0, SHD_PROJECTION_NONE, {SHD_FORMAT_BC4, SHD_FORMAT_BC1_RGB_SRGB}},
    {"3d", 9, 6, 5, 5, SHD_PROJECTION_NONE, {SHD_FORMAT_RG16, SHD_FORMAT_R16F}},
    {"cube", 9, 9, 6, 0, SHD_PROJECTION_CUBE, {SHD_FORMAT_R8, SHD_FORMAT_R32F}},
    {"lat_long", 21, 10, 1, 0, SHD_PROJECTION_LAT_LONG, {SHD_FORMAT_R8, SHD_FORMAT_R32F}},
    {"octahedral", 7, 7, 1, 0, SHD_PROJECTION_OCTAHEDRAL, {SHD_FORMAT_R16}},
    {"mirror_ball", 16, 16, 1, 0, SHD_PROJECTION_MIRROR_BALL, {SHD_FORMAT_R16}},
};
const shd_filter k_filters[] = {SHD_FILTER_NEAREST,           SHD_FILTER_BILINEAR,  SHD_FILTER_NEAREST_MIP,
                                SHD_FILTER_BILINEAR_MIP,      SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC,
                                SHD_FILTER_NEAREST_MIP_LINEAR};
constexpr size_t kReferences = 7;

struct ComparisonBatch : Batch {
  float w[kMaxPoints], dwdx[kMaxPoints], dwdy[kMaxPoints], reference[kMaxPoints];
  uint32_t layer[kMaxPoints];

  Lookups places() const {
    Lookups all = lookups(true, false);
    all.w = w, all.dwdx = dwdx, all.dwdy = dwdy;
    all.layer = layer;
    all.reference = reference;
    return all;
  }
};
ComparisonBatch t_batch, t_wanted;

/// More lookups than a block has.
void make_comparisons(const float (&references)[kReferences], ComparisonBatch* batch) {
  Random random{5};
  make_points(batch);
  batch->count = kMaxPoints - 3;
  for (size_t i = 0; i < kMaxPoints; ++i) {
    const size_t from = i % kPoints;
    for (float* column : {batch->u, batch->v, batch->dudx, batch->dvdx, batch->dudy, batch->dvdy}) {
      column[i] = column[from];
    }
    batch->w[i] = random.real(-2, 3);
    batch->dwdx[i] = 0.1f * batch->dudx[i];
    batch->dwdy[i] = 0.1f * batch->dvdy[i];
    batch->layer[i] = random.next() >> 30;
    batch->reference[i] = references[i % kReferences];
  }
}

shd_texture_desc desc_of(const TextureCase& c, shd_format format, const uint8_t* texels) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = format;
  desc.width = c.width, desc.height = c.height;
  if (c.depth == 0) desc.layer_count = c.layers;
  desc.depth = c.depth;
  desc.projection = c.projection;
  desc.texels = texels;
  desc.tables = shd_format_block_size(format) ? SHD_TABLE_NONE : SHD_TABLE_MIPMAP;
  return desc;
}

Texture* build(const shd_texture_desc& desc) {
  auto* texture = shd::core::create<Texture>(context()->allocator);
  shd::texture::build(*context(), desc, texture);
  return texture;
}

Texture* random_case(const TextureCase& c, shd_format format, bool nonfinite) {
  const size_t count = size_t{c.width} * c.height * c.layers;
  std::vector<uint8_t> texels(count * 16 + SHD_TEXTURE_PADDING);
  const bool blocks = shd_format_block_size(format) != 0;
  random_texels(blocks ? SHD_FORMAT_RGBA8 : format, count, c.width + 7, texels.data());
  if (nonfinite && format == SHD_FORMAT_R32F) {
    const float values[] = {NAN, INFINITY, -INFINITY};
    for (size_t i = 0; i < count; i += 3) memcpy(&texels[4 * i], &values[i / 3 % 3], 4);
  }
  return build(desc_of(c, format, texels.data()));
}

/// Format of decoded texels.
shd_format format_of(const Texture& texture) {
  if (texture.format == SHD_FORMAT_BC4) return SHD_FORMAT_R16;
  return texture.format == SHD_FORMAT_BC1_RGB_SRGB ? SHD_FORMAT_RGBA8_SRGB : texture.format;
}

/// r of a texel of level `level` of a layer or slice.
float texel_value(const Texture& texture, uint32_t image, uint32_t level, uint32_t x, uint32_t y) {
  shd::texture::TexelReader reader(texture);
  const uint8_t* texel =
      reader.at(shd::texture::first_unit(texture, image, level), shd::texture::level_size(texture.width, level), x, y);
  return static_cast<float>(ref::decode(format_of(texture), texel, 0));
}

/// The texture whose texels are the results of comparisons with one reference.
Texture* compared_texture(const TextureCase& c, const Texture& texture, shd_compare compare, float reference) {
  const std::vector<float> zeros(size_t{c.width} * c.height * c.layers + SHD_TEXTURE_PADDING / 4);
  shd_texture_desc desc = desc_of(c, SHD_FORMAT_R32F, reinterpret_cast<const uint8_t*>(zeros.data()));
  if (texture.level_count == 1) desc.tables = SHD_TABLE_NONE;
  Texture* numbers = build(desc);
  assert_int_equal(numbers->level_count, texture.level_count);
  using shd::texture::level_size;
  for (uint32_t level = 0; level < texture.level_count; ++level) {
    const uint32_t width = level_size(texture.width, level), height = level_size(texture.height, level);
    const uint32_t images = texture.depth != 0 ? level_size(texture.depth, level) : texture.layers;
    for (uint32_t i = 0; i < images * height * width; ++i) {
      const uint32_t x = i % width, y = i / width % height, image = i / width / height;
      const float texel = texel_value(texture, image, level, x, y);
      const float number = ref::compare(compare, format_of(texture), reference, texel);
      memcpy(shd::texture::row_of(*numbers, image, level, y) + 4 * x, &number, sizeof number);
    }
  }
  return numbers;
}

shd_sampler_desc sampler_desc(const Texture& texture, shd_filter filter, uint32_t k) {
  shd_sampler_desc desc = wrap_desc(filter, k * 7 % 25);
  desc.wrap_w = static_cast<shd_wrap>(k % 5);
  desc.max_anisotropy = k % 2 ? 16.0f : 2.0f;
  if (texture.depth == 0 && k % 4 == 1) desc.profile = SHD_PROFILE_VULKAN;
  if (k % 3 == 2) desc.magnification = k % 2 ? SHD_MAGNIFICATION_BILINEAR : SHD_MAGNIFICATION_NEAREST;
  return desc;
}

/// Compares the lookups of one sampler with those of the textures of numbers.
void check_case(const TextureCase& c, const Texture& texture, shd_sampler_desc desc, shd_compare compare,
                const float (&references)[kReferences]) {
  shd_sampler_desc comparing = desc;
  comparing.compares = 1;
  comparing.compare = compare;
  comparing.precision = SHD_PRECISION_FAST;  // has no effect
  for (size_t k = 0; k < kReferences; ++k) {
    Texture* numbers = compared_texture(c, texture, compare, references[k]);
    desc.border[0] = ref::compare(compare, format_of(texture), references[k], comparing.border[0]);
    for_each_target([&](int64_t target) {
      run(texture, make_sampler(comparing), target, t_batch.places(), &t_batch);
      run(*numbers, make_sampler(desc), target, t_wanted.places(), &t_wanted);
      for (size_t i = k; i < t_batch.count; i += kReferences) {
        for (size_t channel = 0; channel < 4; ++channel) {
          if (memcmp(&t_batch.out[channel][i], &t_wanted.out[channel][i], sizeof(float)) == 0) continue;
          fail_msg(
              "%s, format %d, filter %d, compare %d, wraps %d %d, reference %g, point %zu, channel %zu: %.9g, not %.9g",
              c.name, texture.format, desc.filter, compare, desc.wrap_u, desc.wrap_v,
              static_cast<double>(references[k]), i, channel, static_cast<double>(t_batch.out[channel][i]),
              static_cast<double>(t_wanted.out[channel][i]));
        }
      }
    });
    free_texture(numbers);
  }
}

void test_numbers(void** state) {
  const auto& c = *static_cast<const TextureCase*>(*state);
  for (const shd_format format : c.formats) {
    for (const bool nonfinite : {false, true}) {
      if (nonfinite && format != SHD_FORMAT_R32F) continue;
      Texture* texture = random_case(c, format, nonfinite);
      const float references[kReferences] = {texel_value(*texture, 0, 0, 0, 0),
                                             texel_value(*texture, 0, 0, c.width / 2, c.height / 2),
                                             nonfinite ? INFINITY : 0.6f,
                                             NAN,
                                             -0.5f,
                                             1.5f,
                                             0.25f};
      make_comparisons(references, &t_batch);
      make_comparisons(references, &t_wanted);
      uint32_t k = 0;
      for (const shd_filter filter : k_filters) {
        for (int compare = SHD_COMPARE_LESS; compare <= SHD_COMPARE_NEVER; ++compare) {
          check_case(c, *texture, sampler_desc(*texture, filter, k++), static_cast<shd_compare>(compare), references);
        }
      }
      free_texture(texture);
    }
  }
}

/// Every tail has the bits of the whole batch, and reads no reference beyond its last one.
void test_tails(void**) {
  const float references[kReferences] = {0.1f, 0.3f, 0.5f, 0.7f, 0.9f, 0.2f, 0.4f};
  make_comparisons(references, &t_batch);
  for (const TextureCase& c : k_textures) {
    Texture* texture = random_case(c, c.formats[0], false);
    for (const shd_filter filter : k_filters) {
      shd_sampler_desc desc = sampler_desc(*texture, filter, 3);
      desc.compares = 1;
      desc.compare = SHD_COMPARE_LESS_EQUAL;
      const Sampler sampler = make_sampler(desc);
      for_each_target([&](int64_t target) {
        run(*texture, sampler, target, t_batch.places(), &t_batch);
        for (size_t count = 0; count <= 35; ++count) {
          const std::vector<float> exact(t_batch.reference, t_batch.reference + count);
          t_wanted.count = count;
          Lookups lookups = t_batch.places();
          lookups.count = count;
          lookups.reference = exact.data();
          run(*texture, sampler, target, lookups, &t_wanted);
          for (size_t k = 0; k < 4; ++k) assert_memory_equal(t_wanted.out[k], t_batch.out[k], count * sizeof(float));
        }
      });
    }
    free_texture(texture);
  }
}

/// An absent column is 0, and unwanted channels are not written.
void test_absent(void**) {
  const uint8_t texels[] = {0, 0, 255, 255};
  Texture* texture = make_texture(SHD_FORMAT_R8, 4, 1, texels, false);
  shd_sampler_desc desc = wrap_desc(SHD_FILTER_NEAREST, 6);
  desc.compares = 1;
  desc.compare = SHD_COMPARE_GREATER_EQUAL;
  t_batch.count = 4;
  for (size_t i = 0; i < 4; ++i) t_batch.u[i] = (static_cast<float>(i) + 0.5f) / 4, t_batch.v[i] = 0.5f;
  for_each_target([&](int64_t target) {
    run(*texture, make_sampler(desc), target, t_batch.lookups(false, false), &t_batch);
    const float want[4][4] = {{1, 1, 0, 0}, {}, {}, {1, 1, 1, 1}};
    for (size_t c = 0; c < 4; ++c) assert_memory_equal(t_batch.out[c], want[c], sizeof want[c]);
    t_batch.set_canaries();
    Texels alpha = {};
    alpha.channel[3] = t_batch.out[3];
    shd::texture::sample(*texture, make_sampler(desc), shd::core::simd_target_from_bit(target),
                         t_batch.lookups(false, false), alpha);
    assert_memory_equal(t_batch.out[3], want[3], sizeof want[3]);
    t_batch.check_canaries();
  });
  free_texture(texture);
}

}  // namespace

int main() {
  CMUnitTest tests[16];
  size_t n = 0;
  for (const TextureCase& c : k_textures) {
    tests[n++] = {c.name, test_numbers, nullptr, nullptr, const_cast<TextureCase*>(&c)};
  }
  tests[n++] = {"tails", test_tails, nullptr, nullptr, nullptr};
  tests[n++] = {"absent", test_absent, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.comparison", tests, n, nullptr, nullptr);
}
