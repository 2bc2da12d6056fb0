// SPDX-License-Identifier: MIT
// Lookups of compressed textures against lookups of textures made from their decoded texels: equal bits for every
// filter, format, target and split of a batch, with a cache of many places and of few.
#include <vector>

#include "points.h"

#include "texture/format/bc/decode.h"
#include "texture/store/bc/levels.h"

namespace {

using namespace fixture;

struct size_case {
  const char* name;
  uint32_t width, height, layers, levels;
};
const size_case k_sizes[] = {
    {"1x1", 1, 1, 1, 0},     {"7x1", 7, 1, 1, 2},          {"5x13", 5, 13, 3, 3},
    {"64x64", 64, 64, 1, 6}, {"4099x37", 4099, 37, 1, 12},
};

constexpr shd_format kBlockFormats[] = {
    SHD_FORMAT_BC1_RGB,     SHD_FORMAT_BC1_RGB_SRGB, SHD_FORMAT_BC1_RGBA, SHD_FORMAT_BC1_RGBA_SRGB,
    SHD_FORMAT_BC2,         SHD_FORMAT_BC2_SRGB,     SHD_FORMAT_BC3,      SHD_FORMAT_BC3_SRGB,
    SHD_FORMAT_BC4,         SHD_FORMAT_BC4_SNORM,    SHD_FORMAT_BC5,      SHD_FORMAT_BC5_SNORM,
    SHD_FORMAT_BC6H_UFLOAT, SHD_FORMAT_BC6H_SFLOAT,  SHD_FORMAT_BC7,      SHD_FORMAT_BC7_SRGB};

Batch t_batch, t_wanted;
float t_gradient[2][2][4][kMaxPoints];

/// Blocks of all levels of all layers, and their decoded texels.
struct Levels {
  std::vector<std::vector<uint8_t>> blocks, texels;  // [layers][levels + 1]
  std::vector<shd_image> block_images, texel_images;
  std::vector<uint8_t> base_blocks, base_texels;  // base levels of all layers
};

shd_format decoded_format(shd_format format) {
  const shd::image::BlockInfo info = shd::image::block_info(format);
  switch (info.component) {
    case Component::kUnorm8: return SHD_FORMAT_RGBA8;
    case Component::kSrgb8: return SHD_FORMAT_RGBA8_SRGB;
    case Component::kUnorm16: return info.stored == 1 ? SHD_FORMAT_R16 : SHD_FORMAT_RG16;
    case Component::kFloat16: return SHD_FORMAT_RGBA16F;
    default: return info.stored == 1 ? SHD_FORMAT_R32F : SHD_FORMAT_RG32F;
  }
}

void decode_level(shd_format format, const std::vector<uint8_t>& blocks, uint32_t width, uint32_t height,
                  std::vector<uint8_t>* texels) {
  const size_t size = shd_format_size(decoded_format(format)), block_size = shd_format_block_size(format);
  texels->resize(size_t{width} * height * size);
  for (uint32_t y = 0; y < height; ++y) {
    for (uint32_t x = 0; x < width; ++x) {
      uint8_t block[16 * 8];
      const size_t i = size_t{y / 4} * ((width + 3) / 4) + x / 4;
      shd::texture::decoder_of(format)(&blocks[i * block_size], block, 4 * size);
      memcpy(&(*texels)[(size_t{y} * width + x) * size], block + (y % 4 * 4 + x % 4) * size, size);
    }
  }
}

void make_levels(const size_case& c, shd_format format, Levels* out) {
  Random random{c.width + 977u * static_cast<uint32_t>(format)};
  for (uint32_t i = 0; i < c.layers * (c.levels + 1); ++i) {
    const uint32_t level = i % (c.levels + 1);
    shd_image image = shd_image_default();
    image.width = shd::texture::level_size(c.width, level);
    image.height = shd::texture::level_size(c.height, level);
    std::vector<uint8_t> blocks(size_t{(image.width + 3) / 4} * ((image.height + 3) / 4) *
                                shd_format_block_size(format));
    for (uint8_t& byte : blocks) byte = static_cast<uint8_t>(random.next() >> 24);
    out->blocks.push_back(blocks);
    out->texels.emplace_back();
    decode_level(format, blocks, image.width, image.height, &out->texels.back());
    if (level == 0) {
      out->base_blocks.insert(out->base_blocks.end(), blocks.begin(), blocks.end());
      out->base_texels.insert(out->base_texels.end(), out->texels.back().begin(), out->texels.back().end());
      continue;
    }
    image.format = format;
    out->block_images.push_back(image);
    image.format = decoded_format(format);
    out->texel_images.push_back(image);
  }
  for (size_t i = 0, k = 0; i < out->blocks.size(); ++i) {
    if (i % (c.levels + 1) == 0) continue;
    out->block_images[k].pixels = out->blocks[i].data();
    out->texel_images[k].pixels = out->texels[i].data();
    ++k;
  }
}

Texture* build_texture(const size_case& c, shd_format format, const uint8_t* base, const shd_image* levels,
                       bool three_channels) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = format;
  desc.width = c.width;
  desc.height = c.height;
  desc.layer_count = c.layers;
  desc.texels = base;
  desc.tables = SHD_TABLE_MIPMAP;
  desc.level_count = c.levels;
  desc.level_images = levels;
  desc.fill[3] = 0.625f;
  if (three_channels) desc.swizzle[3] = SHD_CHANNEL_FILL;
  auto* texture = shd::core::create<Texture>(context()->allocator);
  shd::texture::build(*context(), desc, texture);
  return texture;
}

/// Runs a batch in parts whose sizes change.
void run_split(const Texture& texture, const Sampler& sampler, int64_t target, const Lookups& lookups) {
  const Texels out = {{t_batch.out[0], t_batch.out[1], t_batch.out[2], t_batch.out[3]}, {}, {}};
  for (size_t first = 0, size = 1; first < lookups.count; first += size, size = size % 37 + 5) {
    const size_t count = lookups.count - first < size ? lookups.count - first : size;
    shd::texture::sample(texture, sampler, shd::core::simd_target_from_bit(target),
                         shd::texture::part_of(lookups, first, count), shd::texture::part_of(out, first));
  }
}

void check_equal(const Texture& blocks, const shd_sampler_desc& desc, const char* what) {
  for (size_t c = 0; c < 4; ++c) {
    for (size_t i = 0; i < t_batch.count; ++i) {
      if (memcmp(&t_batch.out[c][i], &t_wanted.out[c][i], sizeof(float)) == 0) continue;
      fail_msg("%s: filter %d format %d wraps %d %d lookup %zu channel %zu (%g, %g): %g, not %g", what, desc.filter,
               blocks.format, desc.wrap_u, desc.wrap_v, i, c, static_cast<double>(t_batch.u[i]),
               static_cast<double>(t_batch.v[i]), static_cast<double>(t_batch.out[c][i]),
               static_cast<double>(t_wanted.out[c][i]));
    }
  }
}

void check_sampler(const Texture& texels, Texture* blocks, const shd_sampler_desc& desc, const Lookups& lookups) {
  const Sampler sampler = make_sampler(desc);
  shd::core::CachePool* const pool = blocks->bc.caches;
  for_each_target([&](int64_t target) {
    const size_t nonfinite = run(texels, sampler, target, lookups, &t_batch);
    memcpy(t_wanted.out, t_batch.out, sizeof t_batch.out);
    assert_int_equal(run(*blocks, sampler, target, lookups, &t_batch), nonfinite);
    check_equal(*blocks, desc, "many places");
    blocks->bc.caches = nullptr;
    run(*blocks, sampler, target, lookups, &t_batch);
    check_equal(*blocks, desc, "few places");
    blocks->bc.caches = pool;
    run_split(*blocks, sampler, target, lookups);
    check_equal(*blocks, desc, "split");
    if (!shd::texture::has_gradient(desc.filter)) return;
    run_gradient(texels, sampler, target, lookups, t_gradient[0]);
    run_gradient(*blocks, sampler, target, lookups, t_gradient[1]);
    assert_memory_equal(t_gradient[0], t_gradient[1], sizeof t_gradient[0]);
  });
}

void check_filter(const Texture& texels, Texture* blocks, shd_sampler_desc desc, const uint32_t* layer) {
  desc.cubic = desc.filter == SHD_FILTER_STOCHASTIC ? SHD_CUBIC_B_SPLINE : SHD_CUBIC_CATMULL_ROM;
  const shd_wrap pairs[][2] = {
      {SHD_WRAP_REPEAT, SHD_WRAP_REPEAT}, {SHD_WRAP_CLAMP, SHD_WRAP_MIRROR}, {SHD_WRAP_BORDER, SHD_WRAP_MIRROR_ONCE}};
  for (size_t k = 0; k < (desc.filter == SHD_FILTER_EXACT ? 1 : 3); ++k) {
    desc.wrap_u = pairs[k][0];
    desc.wrap_v = pairs[k][1];
    for (size_t i = 0; i < 4; ++i) desc.border[i] = 0.25f * static_cast<float>(i + 1);
    Lookups lookups = t_batch.lookups(true, false);
    lookups.layer = layer;
    check_sampler(texels, blocks, desc, lookups);
  }
}

/// The points of other tests, then lines along rows and across them, as pictures have.
void make_lines() {
  make_points(&t_batch);
  for (size_t i = kPoints; i < kMaxPoints; ++i) {
    const size_t line = i / 64, k = i % 64;
    const float step = 0.001f * static_cast<float>(line % 3 + 1), along = static_cast<float>(k) * step;
    t_batch.u[i] = 0.1f * static_cast<float>(line) + (line % 2 ? along : 0.2f * along);
    t_batch.v[i] = 0.07f * static_cast<float>(line) + (line % 4 < 2 ? 0.0f : along);
    t_batch.dudx[i] = step;
    t_batch.dvdy[i] = line % 3 == 0 ? 5.0f * step : step;
    t_batch.dvdx[i] = t_batch.dudy[i] = 0.0f;
    t_batch.lod[i] = 0.5f;
  }
  t_batch.count = kMaxPoints - 3;
}

void test_filters(void** state) {
  const auto& c = *static_cast<const size_case*>(*state);
  make_lines();
  static uint32_t layers[kMaxPoints];
  for (uint32_t i = 0; i < kMaxPoints; ++i) layers[i] = i / 48 % 3 + (i % 97 == 0 ? 9 : 0);  // too large: the last one
  for (const shd_format format : kBlockFormats) {
    Levels levels;
    make_levels(c, format, &levels);
    const bool three = shd::image::block_info(format).channels == 3;
    Texture* texels =
        build_texture(c, decoded_format(format), levels.base_texels.data(), levels.texel_images.data(), three);
    Texture* blocks = build_texture(c, format, levels.base_blocks.data(), levels.block_images.data(), false);
    assert_int_equal(blocks->store, shd::texture::Store::kBc);
    for (uint32_t filter = SHD_FILTER_TRILINEAR; filter <= SHD_FILTER_EXACT; ++filter) {
      if (filter == SHD_FILTER_RIPMAP || filter == SHD_FILTER_SUMMED_AREA) continue;
      if (filter == SHD_FILTER_EXACT && c.width > 64) continue;  // slow
      shd_sampler_desc desc = shd_sampler_desc_default();
      desc.filter = static_cast<shd_filter>(filter);
      if (filter == SHD_FILTER_STOCHASTIC) desc.stochastic_filter = SHD_FILTER_EWA;
      check_filter(*texels, blocks, desc, c.layers > 1 ? layers : nullptr);
      desc.precision = SHD_PRECISION_FAST;  // no effect on blocks
      const Sampler fast = make_sampler(desc);
      desc.precision = SHD_PRECISION_FULL;
      const Sampler full = make_sampler(desc);
      const int64_t target = hwy::SupportedAndGeneratedTargets().front();
      run(*blocks, full, target, t_batch.lookups(true, false), &t_batch);
      memcpy(t_wanted.out, t_batch.out, sizeof t_batch.out);
      run(*blocks, fast, target, t_batch.lookups(true, false), &t_batch);
      check_equal(*blocks, desc, "fast");
    }
    free_texture(texels);
    free_texture(blocks);
  }
}

}  // namespace

int main() {
  constexpr size_t kCount = sizeof k_sizes / sizeof *k_sizes;
  CMUnitTest tests[kCount];
  for (size_t i = 0; i < kCount; ++i) {
    tests[i] = cmocka_unit_test_prestate(test_filters, const_cast<size_case*>(&k_sizes[i]));
    tests[i].name = k_sizes[i].name;
  }
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
