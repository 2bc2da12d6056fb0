// SPDX-License-Identifier: MIT
// Updates of textures and mip levels of images. An updated texture has the bits of a new one with the changed base
// level, a refused update changes nothing, levels of finite texels are finite, and nothing but the pixels is written.
#include "mutator.h"
#include "texture_case.h"

namespace shd::fuzz {
namespace {

constexpr uint8_t kCanaryByte = 0xa5;
constexpr size_t kMaxUpdates = 3;

struct Update {
  uint32_t layer, x, y, width, height, seed;
  size_t gap;
  shd_format format;
};

struct Case {
  TextureCase texture;
  Update updates[kMaxUpdates];
  size_t update_count = 0;
  std::vector<Palette> palette;
  shd_mip_desc mip = shd_mip_desc_default();
  uint32_t level_count = 0;
  size_t gap = 0;
  shd_format moments = SHD_FORMAT_NONE;
  uint64_t budget = 0;
};

void choose_update(Source& source, const shd_texture_desc& texture, Update& u) {
  u.layer = source.below(texture.layer_count - 1 < 3 ? texture.layer_count + (source.one_in(32) ? 1 : 0) : 1);
  const bool inside = !source.one_in(16);
  const uint32_t width = texture.width - 1 < 64 ? texture.width : 1;
  const uint32_t height = texture.height - 1 < 64 ? texture.height : 1;
  u.x = source.below(64) % width;
  u.y = source.below(64) % height;
  u.width = source.below(64) % (inside ? width - u.x : 64) + (inside ? 1 : 0);
  u.height = source.below(64) % (inside ? height - u.y : 64) + (inside ? 1 : 0);
  u.seed = source.below(256);
  u.gap = source.one_in(4) ? 4 * source.below(4) : 0;
  u.format = source.one_in(32) ? source.constant<shd_format>(kFormats) : texture.format;
}

void choose_case(Source& source, Case& c) {
  c.budget = choose_budget(source);
  choose_texture(source, c.texture, source.one_in(16) ? 36 : 6);
  c.palette.emplace_back(source);
  c.update_count = source.below(kMaxUpdates + 1);
  for (size_t i = 0; i < c.update_count; ++i) choose_update(source, c.texture.desc, c.updates[i]);
  c.mip.content = source.constant<shd_texel_content>(5);
  c.mip.kernel = source.constant<shd_mip_kernel>(4);
  c.mip.source = source.constant<shd_mip_source>(2);
  c.mip.wrap_u = source.constant<shd_wrap>(5);
  c.mip.wrap_v = source.constant<shd_wrap>(5);
  c.mip.alpha_cutoff = source.real(0, 1);
  c.level_count = source.below(8);
  c.gap = 4 * source.below(3);
  c.moments = source.one_in(8)   ? source.constant<shd_format>(kFormats)
              : source.one_in(2) ? SHD_FORMAT_RGBA16F
                                 : SHD_FORMAT_RGBA32F;
}

/// Pixels with canaries between and behind the rows.
struct Pixels {
  std::vector<uint8_t> bytes;
  shd_image image = shd_image_default();
  size_t row = 0;

  Pixels(shd_format format, uint32_t width, uint32_t height, size_t gap) {
    row = width * shd_format_size(format);
    bytes.assign(height * (row + gap) + 4, kCanaryByte);
    image.format = format;
    image.width = width;
    image.height = height;
    image.row_stride = gap ? row + gap : 0;
    image.pixels = bytes.data();
  }
  void check_canaries() const {
    const size_t stride = image.row_stride ? image.row_stride : row;
    for (size_t i = 0; i < bytes.size(); ++i) {
      const bool pixel = i < stride * image.height && i % stride < row;
      if (!pixel) SHD_FUZZ_CHECK(bytes[i] == kCanaryByte);
    }
  }
  void check_untouched() const {
    for (const uint8_t byte : bytes) SHD_FUZZ_CHECK(byte == kCanaryByte);
  }
  bool finite() const {
    const size_t stride = image.row_stride ? image.row_stride : row;
    const size_t size = is_float(image.format) ? 4 : is_half(image.format) ? 2 : row + 1;
    for (uint32_t y = 0; y < image.height; ++y) {
      for (size_t x = 0; x + size <= row; x += size) {
        uint32_t bits = 0;
        std::memcpy(&bits, &bytes[y * stride + x], size);
        if (size == 4 ? (bits & 0x7f800000u) == 0x7f800000u : (bits & 0x7c00u) == 0x7c00u) return false;
      }
    }
    return true;
  }
};

/// Levels and lookups of a texture.
struct Content {
  std::vector<uint8_t> bytes;  // all levels as stored
  std::vector<float> values;   // lookups with the filters that read the other tables
};

void sample_table(const Host& host, const shd_texture* texture, shd_filter filter, std::vector<float>& values) {
  const float u[4] = {0.1f, 0.6f, 0.35f, 0.9f}, v[4] = {0.2f, 0.5f, 0.8f, 0.95f};
  const float dudx[4] = {0.9f, 0.2f, 0.5f, 0.01f}, dvdy[4] = {0.1f, 0.8f, 0.4f, 0.7f};
  const uint32_t layer[4] = {0, 1, 2, 0};
  shd_lookups lookups = shd_lookups_default();
  lookups.count = 4;
  lookups.u.data = u, lookups.v.data = v, lookups.dudx.data = dudx, lookups.dvdy.data = dvdy;
  lookups.layer.data = layer;
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = filter;
  shd_sampler* sampler = nullptr;
  if (!host.ok(shd_sampler_create(host.context, &desc, &sampler))) return;
  float out[16];
  shd_texels texels = shd_texels_default();
  for (int k = 0; k < 4; ++k) texels.channel[k].data = out + 4 * k;
  if (host.ok(shd_texture_sample(texture, sampler, &lookups, &texels))) {
    values.insert(values.end(), out, out + 16);
  }
  shd_sampler_release(sampler);
}

Content read_texture(const Host& host, const shd_texture* texture) {
  Content content;
  shd_texture_info info = shd_texture_info_default();
  SHD_FUZZ_CHECK(shd_texture_get_info(texture, &info) == SHD_OK);
  for (uint32_t i = 0; i < info.layer_count * info.level_count; ++i) {
    const uint32_t layer = i / info.level_count, level = i % info.level_count;
    const uint32_t width = info.width >> level, height = info.height >> level;
    Pixels out(info.format, width ? width : 1, height ? height : 1, 0);
    SHD_FUZZ_CHECK(shd_texture_read_level(texture, layer, level, &out.image) == SHD_OK);
    out.check_canaries();
    content.bytes.insert(content.bytes.end(), out.bytes.begin(), out.bytes.end());
  }
  if (info.tables & SHD_TABLE_RIPMAP) sample_table(host, texture, SHD_FILTER_RIPMAP, content.values);
  if (info.tables & SHD_TABLE_SUMMED_AREA) sample_table(host, texture, SHD_FILTER_SUMMED_AREA, content.values);
  return content;
}

void check_same(const Host& host, const Content& a, const Content& b) {
  SHD_FUZZ_CHECK(a.bytes == b.bytes);
  if (host.memory.budget != 0) SHD_FUZZ_CHECK(same_values(a.values, b.values));
}

/// Copies the rectangle of an update into the base level.
void patch(const shd_texture_desc& desc, const Update& u, const Pixels& pixels, std::vector<uint8_t>& base) {
  const size_t pixel = shd_format_size(desc.format);
  const size_t stride = desc.row_stride ? desc.row_stride : desc.width * pixel;
  for (uint32_t y = 0; y < u.height; ++y) {
    uint8_t* const to = &base[(size_t{u.layer} * desc.height + u.y + y) * stride + u.x * pixel];
    std::memcpy(to, &pixels.bytes[y * (pixels.row + u.gap)], pixels.row);
  }
}

/// Returns whether the update was accepted; then `base` has its texels.
bool update(const Host& host, const Case& c, const Update& u, shd_texture* texture, std::vector<uint8_t>& base) {
  Pixels pixels(u.format, u.width, u.height, u.gap);
  std::vector<uint8_t> packed(pixels.row * u.height);
  c.palette[0].fill(u.format, packed, u.seed);
  for (uint32_t y = 0; y < u.height && pixels.row; ++y) {
    std::memcpy(&pixels.bytes[y * (pixels.row + u.gap)], &packed[y * pixels.row], pixels.row);
  }
  if (c.texture.desc.flags & SHD_TEXTURE_BORROW) {
    // The caller writes borrowed texels before the call, also where the call is refused.
    const uint32_t width = c.texture.desc.width, height = c.texture.desc.height;
    if (u.format != c.texture.desc.format || u.x + u.width > width || u.y + u.height > height || u.layer != 0 ||
        u.width == 0 || u.height == 0 || host.memory.budget < 64) {
      return false;
    }
    patch(c.texture.desc, u, pixels, base);
    pixels.image.pixels = nullptr;
    pixels.image.row_stride = 0;
    SHD_FUZZ_CHECK(shd_texture_update(texture, u.layer, u.x, u.y, &pixels.image) == SHD_OK);
    return true;
  }
  if (!host.ok(shd_texture_update(texture, u.layer, u.x, u.y, &pixels.image))) return false;
  if (u.format == c.texture.desc.format) patch(c.texture.desc, u, pixels, base);
  return true;
}

/// Updates a texture and compares it with a new one. Returns the content at the end.
Content run_updates(const Host& host, const Case& c) {
  std::vector<uint8_t> base = c.texture.texels, scratch;
  shd_texture_desc desc = c.texture.desc;
  if (desc.texels) desc.texels = base.data();
  shd_texture* texture = nullptr;
  if (!host.ok(shd_texture_create(host.context, &desc, &texture))) {
    SHD_FUZZ_CHECK(!texture);
    return {};
  }
  Content content = read_texture(host, texture);
  bool comparable = true;
  for (size_t i = 0; i < c.update_count; ++i) {
    const bool accepted = update(host, c, c.updates[i], texture, base);
    comparable = comparable && (!accepted || c.updates[i].format == desc.format);
    Content now = read_texture(host, texture);
    if (!accepted) check_same(host, content, now);
    content = std::move(now);
  }
  shd_texture* fresh = nullptr;
  if (comparable && c.update_count > 0 && host.ok(shd_texture_create(host.context, &desc, &fresh))) {
    check_same(host, content, read_texture(host, fresh));
  }
  shd_texture_release(fresh);
  shd_texture_release(texture);
  return content;
}

/// Mip levels and slope moments in the caller's memory.
void run_mip(const Host& host, const Case& c, Content& content) {
  const shd_texture_desc& texture = c.texture.desc;
  if (texture.width - 1 >= 64 || texture.height - 1 >= 64 || shd_format_size(texture.format) == 0) return;
  Pixels base(texture.format, texture.width, texture.height, c.gap);
  const bool finite = c.palette[0].fill(texture.format, base.bytes, 1);
  const std::vector<uint8_t> before = base.bytes;
  std::vector<Pixels> levels;
  std::vector<shd_image> images;
  for (uint32_t level = 1; level <= c.level_count; ++level) {
    const uint32_t width = texture.width >> level, height = texture.height >> level;
    levels.emplace_back(texture.format, width ? width : 1, height ? height : 1, c.gap);
  }
  for (Pixels& level : levels) {
    level.image.pixels = level.bytes.data();
    images.push_back(level.image);
  }
  const bool made = host.ok(shd_mip_build(host.context, &base.image, &c.mip, c.level_count, images.data()));
  for (const Pixels& level : levels) {
    level.check_canaries();
    if (!made && host.memory.budget != 0) level.check_untouched();
    if (made && finite) SHD_FUZZ_CHECK(level.finite());
    if (made) content.bytes.insert(content.bytes.end(), level.bytes.begin(), level.bytes.end());
  }
  Pixels moments(c.moments, texture.width, texture.height, c.gap);
  Pixels mixed(c.moments == SHD_FORMAT_RGBA16F ? SHD_FORMAT_R16F : SHD_FORMAT_R32F, texture.width, texture.height,
               c.gap);
  shd_image* const wanted = texture.width % 2 == 0 ? &mixed.image : nullptr;
  if (host.ok(shd_mip_build_moments(host.context, &base.image, &moments.image, wanted))) {
    SHD_FUZZ_CHECK(moments.finite() && (!wanted || mixed.finite()));
    for (const Pixels* out : {&moments, &mixed}) {
      content.bytes.insert(content.bytes.end(), out->bytes.begin(), out->bytes.end());
    }
  }
  moments.check_canaries();
  mixed.check_canaries();
  SHD_FUZZ_CHECK(base.bytes == before);
}

void run(const Case& c, shd_simd simd, Content& content) {
  Host host(simd, c.budget);
  if (!host.context) return;
  content = run_updates(host, c);
  run_mip(host, c, content);
}

}  // namespace

void describe(Source& source) {
  Case c;
  choose_case(source, c);
}

}  // namespace shd::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace shd::fuzz;
  compare_targets<Case, Content>(data, size, choose_case, run, [](const Content& best, const Content& baseline) {
    SHD_FUZZ_CHECK(best.bytes == baseline.bytes);
    SHD_FUZZ_CHECK(same_values(best.values, baseline.values));
  });
  return 0;
}
