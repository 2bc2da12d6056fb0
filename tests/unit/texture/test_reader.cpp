// SPDX-License-Identifier: MIT
// TexelReader against the bytes that made the texture, for every store: memory and borrowed memory of 2D textures,
// arrays and slices, blocks against their decoder, and tiles whose callback computes each texel.
#include <algorithm>
#include <vector>

#include "fixture.h"

#include <shd/shd.h>

#include "core/object.h"
#include "support/context.h"
#include "texture/format/bc/decode.h"
#include "texture/store/reader.h"

namespace {

using shd::tests::g_context;
using shd::texture::TexelReader;

/// Byte `b` of a texel: all texels of all levels differ.
uint8_t byte_of(uint32_t image, uint32_t level, uint32_t x, uint32_t y, size_t b) {
  const uint32_t number = (((image * 31 + level) * 4099 + y) * 4099 + x) * 16 + static_cast<uint32_t>(b);
  return static_cast<uint8_t>((number * 2654435761u) >> 21 & 0x7f);
}

uint32_t size_at(uint32_t base, uint32_t level) {
  return std::max(1u, base >> level);
}

struct reader_case {
  const char* name;
  shd_format format;
  uint32_t width, height, layers, depth;
  bool borrowed;
};
const reader_case k_cases[] = {
    {"one", SHD_FORMAT_R8, 1, 1, 1, 0, false},          {"odd", SHD_FORMAT_RGBA8, 37, 21, 1, 0, false},
    {"layers", SHD_FORMAT_RG16, 17, 5, 3, 0, false},    {"floats", SHD_FORMAT_RGBA32F, 9, 33, 1, 0, false},
    {"slices", SHD_FORMAT_RG8, 7, 5, 1, 9, false},      {"thin_slices", SHD_FORMAT_R16, 1, 2, 1, 13, false},
    {"borrowed", SHD_FORMAT_RGBA8, 12, 10, 1, 0, true},
};

/// Levels of every image, whose bytes are byte_of().
struct Levels {
  std::vector<std::vector<uint8_t>> bytes;  // level by level of each layer; of a 3D texture all slices of a level
  std::vector<shd_image> images;            // without the base
  std::vector<uint8_t> base;
  uint32_t count = 1;

  Levels(const reader_case& row, size_t size) {
    const uint32_t longest = std::max(std::max(row.width, row.height), row.depth);
    while (longest >> count) ++count;
    bytes.reserve(size_t{row.layers} * count);
    for (uint32_t layer = 0; layer < row.layers; ++layer) {
      for (uint32_t level = 0; level < count; ++level) add(row, layer, level, size);
    }
  }

 private:
  void add(const reader_case& row, uint32_t layer, uint32_t level, size_t size) {
    const uint32_t w = size_at(row.width, level), h = size_at(row.height, level);
    const uint32_t slices = row.depth ? size_at(row.depth, level) : 1;
    bytes.emplace_back();
    for (uint32_t z = 0; z < slices; ++z) {
      for (size_t i = 0; i < size_t{w} * h * size; ++i) {
        const auto texel = static_cast<uint32_t>(i / size);
        bytes.back().push_back(byte_of(row.depth ? z : layer, level, texel % w, texel / w, i % size));
      }
    }
    if (level == 0) {
      base.insert(base.end(), bytes.back().begin(), bytes.back().end());
      return;
    }
    const size_t slice = size_t{w} * h * size;
    for (uint32_t z = 0; z < slices; ++z) {
      shd_image image = shd_image_default();
      image.format = row.format, image.width = w, image.height = h;
      image.pixels = bytes.back().data() + z * slice;
      images.push_back(image);
    }
  }
};

const shd::texture::Texture& body(const shd_texture* texture) {
  const auto* object = reinterpret_cast<const shd::core::Object*>(texture);
  void* const found = shd::core::body_of(object, static_cast<uint32_t>(shd::core::ObjectType::kTexture));
  assert_non_null(found);
  return *static_cast<const shd::texture::Texture*>(found);
}

const uint8_t* texel_of(TexelReader* reader, const shd::texture::Texture& texture, uint32_t image, uint32_t level,
                        uint32_t x, uint32_t y) {
  return reader->at(shd::texture::first_unit(texture, image, level), size_at(texture.width, level), x, y);
}

void check_texels(const char* name, const shd::texture::Texture& texture, size_t size) {
  TexelReader reader(texture);
  for (uint32_t level = 0; level < texture.level_count; ++level) {
    const uint32_t images = texture.depth ? size_at(texture.depth, level) : texture.layers;
    for (uint32_t image = 0; image < images; ++image) {
      for (uint32_t y = 0; y < size_at(texture.height, level); ++y) {
        for (uint32_t x = 0; x < size_at(texture.width, level); ++x) {
          const uint8_t* const texel = texel_of(&reader, texture, image, level, x, y);
          for (size_t b = 0; b < size; ++b) {
            if (texel[b] == byte_of(image, level, x, y, b)) continue;
            fail_msg("%s: image %u, level %u, texel (%u, %u), byte %zu is %d", name, image, level, x, y, b, texel[b]);
          }
        }
      }
    }
  }
}

void test_memory(void**) {
  for (const reader_case& row : k_cases) {
    const size_t size = shd_format_size(row.format);
    Levels levels(row, size);
    levels.base.resize(levels.base.size() + SHD_TEXTURE_PADDING);
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = row.format, desc.width = row.width, desc.height = row.height, desc.layer_count = row.layers;
    if (row.depth) desc.kind = SHD_TEXTURE_KIND_3D;
    desc.depth = row.depth, desc.texels = levels.base.data(), desc.tables = SHD_TABLE_MIPMAP;
    desc.level_images = levels.images.data(), desc.level_count = levels.count - 1;
    if (row.borrowed) desc.flags = SHD_TEXTURE_BORROW;
    shd_texture* texture = nullptr;
    shd_assert_ok(shd_texture_create(g_context, &desc, &texture));
    assert_int_equal(body(texture).borrowed != nullptr, row.borrowed);
    check_texels(row.name, body(texture), size);
    shd_texture_release(texture);
  }
}

void test_blocks(void**) {
  constexpr uint32_t kWidth = 13, kHeight = 7, kAcross = 4, kDown = 2, kLayers = 2;
  for (const shd_format format : {SHD_FORMAT_BC1_RGBA, SHD_FORMAT_BC5_SNORM, SHD_FORMAT_BC6H_UFLOAT, SHD_FORMAT_BC7}) {
    const size_t block_size = shd_format_block_size(format), layer = block_size * kAcross * kDown;
    std::vector<uint8_t> blocks(layer * kLayers);
    for (size_t i = 0; i < blocks.size(); ++i) blocks[i] = static_cast<uint8_t>((i * 2654435761u) >> 17);
    shd_texture_desc desc = shd_texture_desc_default();
    desc.format = format, desc.width = kWidth, desc.height = kHeight, desc.layer_count = kLayers;
    desc.texels = blocks.data(), desc.tables = 0;
    shd_texture* texture = nullptr;
    shd_assert_ok(shd_texture_create(g_context, &desc, &texture));
    const size_t size = shd::texture::texel_size(body(texture));
    TexelReader reader(body(texture));
    for (uint32_t i = 0; i < kLayers * kWidth * kHeight; ++i) {
      // An order that leaves the block and comes back.
      const uint32_t n = i * 37 % (kLayers * kWidth * kHeight);
      const uint32_t x = n % kWidth, y = n / kWidth % kHeight, of = n / (kWidth * kHeight);
      uint8_t decoded[16 * 8];
      const size_t block = of * layer + (y / 4 * kAcross + x / 4) * block_size;
      shd::texture::decoder_of(format)(&blocks[block], decoded, 4 * size);
      assert_memory_equal(texel_of(&reader, body(texture), of, 0, x, y), decoded + (y % 4 * 4 + x % 4) * size, size);
    }
    shd_texture_release(texture);
  }
}

/// A source that computes its texels, and fails for one level.
struct Computed {
  size_t size;
  int failing_level = -1;
  int calls = 0;

  static shd_result load(const shd_tile* tiles, size_t count, void* user_data) {
    auto& self = *static_cast<Computed*>(user_data);
    ++self.calls;
    for (size_t i = 0; i < count; ++i) {
      const shd_tile& tile = tiles[i];
      if (static_cast<int>(tile.level) == self.failing_level) return SHD_ERROR_IO;
      for (uint32_t y = 0; y < tile.area.height; ++y) {
        uint8_t* const row = static_cast<uint8_t*>(tile.texels) + y * tile.row_stride;
        for (size_t b = 0; b < tile.area.width * self.size; ++b) {
          row[b] = byte_of(tile.layer, tile.level, tile.area.x + static_cast<uint32_t>(b / self.size), tile.area.y + y,
                           b % self.size);
        }
      }
    }
    return SHD_OK;
  }
};

shd_texture* make_tiled(shd_format format, uint32_t width, uint32_t height, uint32_t layers, shd_tile_cache* cache,
                        Computed* source) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = format, desc.width = width, desc.height = height, desc.layer_count = layers;
  desc.tables = SHD_TABLE_MIPMAP;
  desc.tiles = {cache, Computed::load, nullptr, source};
  shd_texture* texture = nullptr;
  shd_assert_ok(shd_texture_create(g_context, &desc, &texture));
  return texture;
}

shd_tile_cache* make_cache() {
  shd_tile_cache_desc desc = shd_tile_cache_desc_default();
  desc.tile_bytes = 4096;
  desc.budget_bytes = 4u << 20;
  shd_tile_cache* cache = nullptr;
  shd_assert_ok(shd_tile_cache_create(g_context, &desc, &cache));
  return cache;
}

void test_tiles(void**) {
  shd_tile_cache* const cache = make_cache();
  for (const shd_format format : {SHD_FORMAT_R8, SHD_FORMAT_RGBA8, SHD_FORMAT_RG16, SHD_FORMAT_RGBA32F}) {
    Computed source{shd_format_size(format)};
    shd_texture* const texture = make_tiled(format, 301, 77, 2, cache, &source);
    check_texels("tiles", body(texture), source.size);
    assert_true(source.calls > 0);
    shd_texture_release(texture);
  }
  shd_tile_cache_release(cache);
}

void test_failing_tile(void**) {
  shd_tile_cache* const cache = make_cache();
  Computed source{shd_format_size(SHD_FORMAT_RGBA8), 1};
  shd_texture* const texture = make_tiled(SHD_FORMAT_RGBA8, 128, 128, 1, cache, &source);
  TexelReader reader(body(texture));
  assert_int_equal(*texel_of(&reader, body(texture), 0, 0, 5, 6), byte_of(0, 0, 5, 6, 0));
  shd_result result = SHD_OK;
  try {
    texel_of(&reader, body(texture), 0, 1, 5, 6);
  } catch (const shd::core::Failure& failure) {
    result = failure.code;
  }
  assert_int_equal(result, SHD_ERROR_CALLBACK);
  // Nothing stays locked: the next load succeeds.
  source.failing_level = -1;
  assert_int_equal(*texel_of(&reader, body(texture), 0, 1, 5, 6), byte_of(0, 1, 5, 6, 0));
  shd_texture_release(texture);
  shd_tile_cache_release(cache);
}

}  // namespace

int main() {
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_memory), cmocka_unit_test(test_blocks),
                                     cmocka_unit_test(test_tiles), cmocka_unit_test(test_failing_tile)};
  return cmocka_run_group_tests(tests, shd::tests::set_up, shd::tests::tear_down);
}
