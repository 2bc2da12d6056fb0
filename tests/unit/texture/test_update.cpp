// SPDX-License-Identifier: MIT
// Updates of a rectangle against textures built from the changed base, byte by byte.
#include "fixture.h"

namespace {

using namespace fixture;

/// Every format; formats of three channels are given and stored as different formats.
constexpr uint32_t kFirstFormat = SHD_FORMAT_R8, kLastFormat = SHD_FORMAT_RGB32F;

struct size_case {
  const char* name;
  uint32_t width, height, updates;
};
const size_case k_sizes[] = {
    {"1x1", 1, 1, 2},       {"1x7", 1, 7, 8},       {"5x3", 5, 3, 12},        {"64x64", 64, 64, 12},
    {"128x32", 128, 32, 8}, {"33x65", 33, 65, 8},   {"96x160", 96, 160, 4},   {"100x36", 100, 36, 6},
    {"600x1", 600, 1, 8},   {"2x1024", 2, 1024, 4}, {"256x256", 256, 256, 2},
};
/// Bases of more than two rounds for every format.
const size_case k_large[] = {{"large/1024x2048", 1024, 2048, 6}, {"large/1000x1025", 1000, 1025, 2}};

constexpr uint32_t kAll = SHD_TABLE_MIPMAP | SHD_TABLE_RIPMAP | SHD_TABLE_SUMMED_AREA;
constexpr uint32_t kLayers = 2;

Texture* build_texture(shd_format format, uint32_t width, uint32_t height, uint32_t tables, const uint8_t* texels,
                       uint32_t layers = kLayers) {
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

struct Rectangle {
  uint32_t layer, x, y, width, height;
};

/// A rectangle: the whole layer, a texel, a corner, or any.
Rectangle pick(Random* random, uint32_t index, uint32_t width, uint32_t height) {
  Rectangle r = {random->next() >> 16 & 1, 0, 0, width, height};
  if (index == 1) return r;
  r.x = static_cast<uint32_t>(uint64_t{random->next()} * width >> 32);
  r.y = static_cast<uint32_t>(uint64_t{random->next()} * height >> 32);
  r.width = r.height = 1;
  if (index % 3 == 0) return r;
  r.width += static_cast<uint32_t>(uint64_t{random->next()} * (width - r.x) >> 32);
  r.height += static_cast<uint32_t>(uint64_t{random->next()} * (height - r.y) >> 32);
  return r;
}

/// Writes random texels to a rectangle of `base`, and to the texture by an update whose rows have a gap.
void change(shd_format format, const Rectangle& r, uint32_t seed, uint32_t width, uint32_t height, uint8_t* base,
            Texture* texture) {
  const size_t size = shd_format_size(format), stride = (r.width + 3) * size;
  auto* patch = static_cast<uint8_t*>(malloc(stride * r.height));
  random_texels(format, size_t{r.width + 3} * r.height, seed, patch);
  for (uint32_t y = 0; y < r.height; ++y) {
    const size_t at = (size_t{r.layer} * height + r.y + y) * width + r.x;
    memcpy(base + at * size, patch + y * stride, r.width * size);
  }
  shd_image image = shd_image_default();
  image.format = format;
  image.width = r.width;
  image.height = r.height;
  image.row_stride = stride;
  image.pixels = patch;
  shd::texture::update(*context(), r.layer, r.x, r.y, image, texture);
  free(patch);
}

/// The table of non-finite texels may exist even if all texels are finite.
void check_sums(const Texture& got, const Texture& want) {
  assert_int_equal(got.sums.size(), want.sums.size());
  if (want.sums.size() == 0) return;
  assert_memory_equal(got.sums.data(), want.sums.data(), want.sums.size());
  assert_memory_equal(got.sum_origins.data(), want.sum_origins.data(), want.sum_origins.size() * sizeof(double));
  const size_t count = got.nonfinite_sums.size();
  assert_true(count >= want.nonfinite_sums.size());
  for (size_t i = 0; i < count; ++i) {
    assert_int_equal(got.nonfinite_sums[i], want.nonfinite_sums.size() ? want.nonfinite_sums[i] : 0);
  }
}

void check_same(const char* what, uint32_t index, const Texture& got, const Texture& want) {
  check_sums(got, want);
  const size_t size = want.texels.size();
  assert_int_equal(got.texels.size(), size);
  if (memcmp(got.texels.data(), want.texels.data(), size) == 0) return;
  size_t at = 0;
  while (got.texels[at] == want.texels[at]) ++at;
  fail_msg("%s format %d tables %u update %u: byte %zu of %zu differs", what, want.given_format, want.tables, index, at,
           size);
}

void check_updates(const size_case& c, shd_format format, uint32_t tables) {
  const size_t count = size_t{c.width} * c.height * kLayers;
  auto* base = static_cast<uint8_t*>(malloc(count * shd_format_size(format)));
  random_texels(format, count, c.width * 31 + c.height, base);
  Texture* texture = build_texture(format, c.width, c.height, tables, base);
  Random random = {c.width + 7 * c.height + 100 * format};
  for (uint32_t i = 0; i < c.updates; ++i) {
    change(format, pick(&random, i, c.width, c.height), 1000 + i, c.width, c.height, base, texture);
    Texture* want = build_texture(format, c.width, c.height, tables, base);
    check_same(c.name, i, *texture, *want);
    free_texture(want);
  }
  free_texture(texture);
  free(base);
}

void test_size(void** state) {
  const auto& c = *static_cast<const size_case*>(*state);
  for (uint32_t format = kFirstFormat; format <= kLastFormat; ++format) {
    for (const uint32_t tables : {uint32_t{SHD_TABLE_NONE}, uint32_t{SHD_TABLE_MIPMAP}, uint32_t{SHD_TABLE_RIPMAP},
                                  uint32_t{SHD_TABLE_SUMMED_AREA}, kAll}) {
      check_updates(c, static_cast<shd_format>(format), tables);
    }
  }
}

void test_large(void** state) {
  const auto& c = *static_cast<const size_case*>(*state);
  for (const shd_format format : {SHD_FORMAT_R8_SRGB, SHD_FORMAT_RGBA8, SHD_FORMAT_R32F}) {
    check_updates(c, format, SHD_TABLE_MIPMAP);
  }
}

/// Updates of layers whose numbers differ by multiples of 32, each once before any is updated again.
void test_many_layers(void**) {
  constexpr uint32_t kMany = 73, kEdge = 64;
  constexpr size_t kCount = size_t{kMany} * kEdge * kEdge;
  auto* base = static_cast<uint8_t*>(malloc(kCount));
  random_texels(SHD_FORMAT_R8, kCount, 3, base);
  Texture* texture = build_texture(SHD_FORMAT_R8, kEdge, kEdge, SHD_TABLE_MIPMAP, base, kMany);
  uint32_t index = 0;
  for (const uint32_t layer : {8u, 40u, 72u, 40u, 8u, 31u, 32u, 0u}) {
    change(SHD_FORMAT_R8, {layer, 7 * index, 5, 2, 3}, 50 + index, kEdge, kEdge, base, texture);
    Texture* want = build_texture(SHD_FORMAT_R8, kEdge, kEdge, SHD_TABLE_MIPMAP, base, kMany);
    check_same("many_layers", index++, *texture, *want);
    free_texture(want);
  }
  free_texture(texture);
  free(base);
}

/// The caller's levels are kept; ripmap levels are rebuilt unless the caller gave them.
void test_given_levels(void**) {
  uint8_t base[8 * 8], first[4 * 4], patch = 200;
  memset(base, 10, sizeof base);
  memset(first, 77, sizeof first);
  shd_image level = shd_image_default();
  level.format = SHD_FORMAT_R8;
  level.width = level.height = 4;
  level.pixels = first;
  level.row_stride = 4;
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = SHD_FORMAT_R8;
  desc.width = desc.height = 8;
  desc.texels = base;
  desc.tables = kAll;
  desc.level_images = &level;
  desc.level_count = 1;
  auto* texture = shd::core::create<Texture>(context()->allocator);
  auto* want = shd::core::create<Texture>(context()->allocator);
  shd::texture::build(*context(), desc, texture);
  shd_image image = level;
  image.width = image.height = image.row_stride = 1;
  image.pixels = &patch;
  shd::texture::update(*context(), 0, 3, 5, image, texture);
  base[8 * 5 + 3] = patch;
  shd::texture::build(*context(), desc, want);
  check_same("given", 0, *texture, *want);
  assert_int_equal(shd::texture::row_of(*texture, 0, 1, 2)[1], 77);
  assert_int_equal(texture->mip_sums.size(), 0);
  free_texture(want);
  free_texture(texture);
}

/// NaN appears and disappears in one layer: the table of non-finite texels is created and kept.
void test_nonfinite(void**) {
  float base[kLayers * 12];
  for (size_t i = 0; i < kLayers * 12; ++i) base[i] = static_cast<float>(i);
  const auto* bytes = reinterpret_cast<const uint8_t*>(base);
  Texture* texture = build_texture(SHD_FORMAT_R32F, 4, 3, SHD_TABLE_SUMMED_AREA, bytes);
  assert_int_equal(texture->nonfinite_sums.size(), 0);
  for (const float value : {NAN, INFINITY, 5.0f}) {
    shd_image image = shd_image_default();
    image.format = SHD_FORMAT_R32F;
    image.width = image.height = 1;
    image.row_stride = sizeof value;
    float patch = value;
    image.pixels = &patch;
    shd::texture::update(*context(), 1, 2, 1, image, texture);
    base[12 + 4 + 2] = value;
    Texture* want = build_texture(SHD_FORMAT_R32F, 4, 3, SHD_TABLE_SUMMED_AREA, bytes);
    assert_int_equal(want->nonfinite_sums.size() > 0, !isfinite(value));
    check_sums(*texture, *want);
    free_texture(want);
  }
  free_texture(texture);
}

/// A texture made from three channels also accepts four; the fourth is not read.
void test_four_for_three(void**) {
  const uint8_t base[2 * 3] = {1, 2, 3, 4, 5, 6}, patch[4] = {7, 8, 9, 10};
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = SHD_FORMAT_RGB8;
  desc.width = 2;
  desc.height = 1;
  desc.texels = base;
  auto* texture = shd::core::create<Texture>(context()->allocator);
  shd::texture::build(*context(), desc, texture);
  shd_image image = shd_image_default();
  image.format = SHD_FORMAT_RGBA8;
  image.width = image.height = 1;
  image.row_stride = 4;
  image.pixels = const_cast<uint8_t*>(patch);
  shd::texture::update(*context(), 0, 1, 0, image, texture);
  const uint8_t want[] = {1, 2, 3, 0, 7, 8, 9, 10};
  assert_memory_equal(texture->texels.data(), want, sizeof want);
  free_texture(texture);
}

/// Memory kept by updates: 1/32 of RGBA8 texels, for one round of 4 steps and one of 5.
void test_memory(void**) {
  uint8_t patch[4] = {};
  Texture* texture = random_texture(SHD_FORMAT_RGBA8, 2048, 2048, true);
  const size_t before = shd::texture::byte_size(*texture);
  shd_image image = shd_image_default();
  image.format = SHD_FORMAT_RGBA8;
  image.width = image.height = 1;
  image.row_stride = 4;
  image.pixels = patch;
  shd::texture::update(*context(), 0, 1, 0, image, texture);
  assert_int_equal(shd::texture::byte_size(*texture) - before, 32 * (128 * 128 + 4 * 4));
  free_texture(texture);
}

}  // namespace

int main() {
  CMUnitTest tests[32];
  size_t n = 0;
  for (const size_case& c : k_sizes) tests[n++] = {c.name, test_size, nullptr, nullptr, const_cast<size_case*>(&c)};
  for (const size_case& c : k_large) tests[n++] = {c.name, test_large, nullptr, nullptr, const_cast<size_case*>(&c)};
  tests[n++] = {"many_layers", test_many_layers, nullptr, nullptr, nullptr};
  tests[n++] = {"given_levels", test_given_levels, nullptr, nullptr, nullptr};
  tests[n++] = {"nonfinite", test_nonfinite, nullptr, nullptr, nullptr};
  tests[n++] = {"four_channels_for_three", test_four_for_three, nullptr, nullptr, nullptr};
  tests[n++] = {"memory", test_memory, nullptr, nullptr, nullptr};
  return _cmocka_run_group_tests("unit.texture.update", tests, n, nullptr, nullptr);
}
