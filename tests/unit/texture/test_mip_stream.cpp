// SPDX-License-Identifier: MIT
// Levels of rows that arrive in strips, against shd_mip_build and the levels of textures, for every format.
#include "fixture.h"

#include <cstring>
#include <vector>

#include <shd/shd.h>

#include "texture/table/mip_stream.h"

namespace {

using namespace fixture;
using namespace shd::texture;

constexpr shd_format kFormats[] = {SHD_FORMAT_R8,      SHD_FORMAT_RG8,      SHD_FORMAT_RGB8,      SHD_FORMAT_RGBA8,
                                   SHD_FORMAT_R8_SRGB, SHD_FORMAT_RG8_SRGB, SHD_FORMAT_RGB8_SRGB, SHD_FORMAT_RGBA8_SRGB,
                                   SHD_FORMAT_R16,     SHD_FORMAT_RG16,     SHD_FORMAT_RGB16,     SHD_FORMAT_RGBA16,
                                   SHD_FORMAT_R16F,    SHD_FORMAT_RG16F,    SHD_FORMAT_RGB16F,    SHD_FORMAT_RGBA16F,
                                   SHD_FORMAT_R32F,    SHD_FORMAT_RG32F,    SHD_FORMAT_RGB32F,    SHD_FORMAT_RGBA32F};
constexpr uint32_t kSizes[][2] = {{1, 1},    {2, 2},    {64, 64},   {256, 128}, {1, 64},    {128, 1},  {3, 5},
                                  {96, 160}, {127, 33}, {1280, 72}, {2048, 20}, {257, 256}, {16, 512}, {1030, 6}};

struct Serial {
  template <class Body>
  void operator()(size_t count, const Body& body) const {
    for (size_t i = 0; i < count; ++i) body(i);
  }
};

using Levels = std::vector<std::vector<uint8_t>>;

Levels make_levels(shd_format format, uint32_t width, uint32_t height) {
  Levels levels;
  for (uint32_t l = 1; l < full_level_count(width, height); ++l) {
    levels.emplace_back(size_t{level_size(width, l)} * level_size(height, l) * shd_format_size(format));
  }
  return levels;
}

/// Levels by the stream, from strips of `strip` rows. The stream is replaced by a copy after every strip.
template <class Stream>
Levels stream_levels(const TexelCodec& codec, shd_format format, const uint32_t* size, uint32_t strip,
                     const uint8_t* texels) {
  const uint32_t width = size[0], height = size[1];
  Levels levels = make_levels(format, width, height);
  const size_t row = width * shd_format_size(format);
  std::vector<double> state;
  for (uint32_t y = 0; y < height; y += strip) {
    Stream stream(codec, width, height);
    if (y > 0) stream.state() = state;
    std::vector<uint8_t*> out;
    for (uint32_t l = 1; l <= levels.size(); ++l) {
      const size_t done = completed_rows(height, l, y);
      out.push_back(levels[l - 1].data() + done * level_size(width, l) * shd_format_size(format));
    }
    stream.push({texels + y * row, row, y, height - y < strip ? height - y : strip}, out.data(), Serial());
    state = stream.state();
  }
  return levels;
}

shd_context* context() {
  static shd_context* made = nullptr;
  if (!made) shd_assert_ok(shd_context_create(nullptr, &made));
  return made;
}

Levels texture_levels(shd_format format, uint32_t width, uint32_t height, const uint8_t* texels) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = format;
  desc.width = width;
  desc.height = height;
  desc.texels = texels;
  desc.tables = SHD_TABLE_MIPMAP;
  shd_texture* texture = nullptr;
  shd_assert_ok(shd_texture_create(context(), &desc, &texture));
  shd_texture_info info = shd_texture_info_default();
  shd_assert_ok(shd_texture_get_info(texture, &info));
  const size_t from = shd_format_size(info.format), to = shd_format_size(format);
  Levels levels = make_levels(format, width, height);
  for (uint32_t l = 1; l <= levels.size(); ++l) {
    shd_image image = shd_image_default();
    image.format = info.format;
    image.width = level_size(width, l);
    image.height = level_size(height, l);
    std::vector<uint8_t> read(size_t{image.width} * image.height * from);
    image.pixels = read.data();
    shd_assert_ok(shd_texture_read_level(texture, 0, l, &image));
    for (size_t i = 0; i < read.size() / from; ++i) memcpy(&levels[l - 1][i * to], &read[i * from], to);
  }
  shd_texture_release(texture);
  return levels;
}

Levels built_normals(shd_format format, uint32_t width, uint32_t height, uint8_t* texels) {
  Levels levels = make_levels(format, width, height);
  shd_mip_desc desc = shd_mip_desc_default();
  desc.content = SHD_TEXEL_CONTENT_NORMAL;
  std::vector<shd_image> images(levels.size() + 1, shd_image_default());
  for (uint32_t l = 0; l <= levels.size(); ++l) {
    images[l].format = format;
    images[l].width = level_size(width, l);
    images[l].height = level_size(height, l);
    images[l].pixels = l ? levels[l - 1].data() : texels;
  }
  shd_assert_ok(shd_mip_build(context(), &images[0], &desc, static_cast<uint32_t>(levels.size()), &images[1]));
  return levels;
}

void expect_equal(const Levels& a, const Levels& b, shd_format format, const uint32_t* size) {
  for (size_t l = 0; l < a.size(); ++l) {
    if (memcmp(a[l].data(), b[l].data(), a[l].size()) == 0) continue;
    fail_msg("format %d, %u x %u: level %zu differs", format, size[0], size[1], l + 1);
  }
}

template <class Check>
void for_images(const Check& check) {
  for (const shd_format format : kFormats) {
    for (const auto& size : kSizes) {
      std::vector<uint8_t> texels(size_t{size[0]} * size[1] * shd_format_size(format));
      random_texels(format, size_t{size[0]} * size[1], 7 + size[0], texels.data());
      check(format, size, texels.data());
    }
  }
}

void streams_colours(void**) {
  for_images([](shd_format format, const uint32_t* size, uint8_t* texels) {
    const Levels wanted = texture_levels(format, size[0], size[1], texels);
    const shd::image::FormatInfo info = shd::image::format_info(format);
    const TexelCodec& codec = codec_of(info.component, info.channels);
    for (const uint32_t strip : {2u, 16u, 48u, 64u, 1024u}) {
      expect_equal(stream_levels<MipStream>(codec, format, size, strip, texels), wanted, format, size);
    }
  });
}

void streams_normals(void**) {
  for_images([](shd_format format, const uint32_t* size, uint8_t* texels) {
    const shd::image::FormatInfo info = shd::image::format_info(format);
    if (info.channels < 3) return;
    const auto component =
        info.component == shd::image::Component::kSrgb8 ? shd::image::Component::kUnorm8 : info.component;
    const Levels wanted = built_normals(format, size[0], size[1], texels);
    const TexelCodec& codec = codec_of(component, info.channels);
    for (const uint32_t strip : {2u, 48u, 1024u}) {
      expect_equal(stream_levels<NormalStream>(codec, format, size, strip, texels), wanted, format, size);
    }
  });
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(streams_colours), cmocka_unit_test(streams_normals)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
