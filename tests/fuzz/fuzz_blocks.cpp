// SPDX-License-Identifier: MIT
// Textures of compressed blocks of random bytes. Lookups have the bits of lookups of a texture that is made from the
// texels that nearest lookups of each level give.
#include "host.h"
#include "mutator.h"

namespace shd::fuzz {
namespace {

constexpr uint32_t kMostLevels = 4, kMostSide = 21, kMostLayers = 3, kLookups = 40;

struct Case {
  shd_format format = SHD_FORMAT_BC1_RGB;
  uint32_t width = 1, height = 1, layers = 1, levels = 1;
  shd_sampler_desc sampler = shd_sampler_desc_default();
  uint32_t seed = 0;
  std::vector<float> columns[6];
  std::vector<uint32_t> layer;
};

void choose_case(Source& source, Case& c) {
  c.format = static_cast<shd_format>(SHD_FORMAT_BC1_RGB + source.below(SHD_FORMAT_BC7_SRGB - SHD_FORMAT_BC1_RGB + 1));
  c.width = source.between(1, kMostSide);
  c.height = source.between(1, kMostSide);
  c.layers = source.between(1, kMostLayers);
  c.levels = source.between(1, kMostLevels);
  while (c.levels > 1 && (c.width >> (c.levels - 1)) == 0 && (c.height >> (c.levels - 1)) == 0) --c.levels;
  c.seed = source.word();
  constexpr shd_filter kChoices[] = {SHD_FILTER_NEAREST,   SHD_FILTER_BILINEAR,    SHD_FILTER_BICUBIC,
                                     SHD_FILTER_TRILINEAR, SHD_FILTER_ANISOTROPIC, SHD_FILTER_EWA};
  c.sampler.filter = kChoices[source.below(6)];
  c.sampler.wrap_u = static_cast<shd_wrap>(source.below(5));
  c.sampler.wrap_v = static_cast<shd_wrap>(source.below(5));
  c.sampler.border[3] = 1.0f;  // as the fill of formats without alpha
  for (std::vector<float>& column : c.columns) column.resize(kLookups);
  c.layer.resize(kLookups);
  for (uint32_t i = 0; i < kLookups; ++i) {
    for (uint32_t k = 0; k < 6; ++k) c.columns[k][i] = k < 2 ? 2.0f * source.real() : 0.3f * source.real();
    c.layer[i] = source.below(4);
  }
}

uint32_t side_of(uint32_t side, uint32_t level) {
  return side >> level > 0 ? side >> level : 1;
}

/// Levels of all layers in memory, as blocks or as texels.
struct Levels {
  std::vector<std::vector<uint8_t>> memory;  // [layers][levels]
  std::vector<uint8_t> base;                 // [layers]
  std::vector<shd_image> images;
};

size_t level_bytes(const Case& c, shd_format format, uint32_t level) {
  const size_t width = side_of(c.width, level), height = side_of(c.height, level);
  const size_t block = shd_format_block_size(format);
  return block ? (width + 3) / 4 * ((height + 3) / 4) * block : width * height * shd_format_size(format);
}

/// Completes levels whose memory is filled.
void finish(const Case& c, shd_format format, Levels* out) {
  out->base.clear();
  out->images.clear();
  for (uint32_t i = 0; i < c.layers * c.levels; ++i) {
    const uint32_t level = i % c.levels;
    if (level == 0) {
      out->base.insert(out->base.end(), out->memory[i].begin(), out->memory[i].end());
      continue;
    }
    shd_image image = shd_image_default();
    image.format = format;
    image.width = side_of(c.width, level);
    image.height = side_of(c.height, level);
    image.pixels = out->memory[i].data();
    out->images.push_back(image);
  }
}

shd_texture* make_texture(const Host& host, const Case& c, shd_format format, const Levels& levels) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = format;
  desc.width = c.width;
  desc.height = c.height;
  desc.layer_count = c.layers;
  desc.texels = levels.base.data();
  desc.tables = c.levels > 1 ? SHD_TABLE_MIPMAP : 0;
  desc.level_images = levels.images.empty() ? nullptr : levels.images.data();
  desc.level_count = c.levels - 1;
  shd_texture* texture = nullptr;
  SHD_FUZZ_CHECK(host.ok(shd_texture_create(host.context, &desc, &texture)));
  return texture;
}

std::vector<float> sample(const Host& host, const shd_texture* texture, const shd_sampler_desc& desc,
                          const shd_lookups& lookups) {
  shd_sampler* sampler = nullptr;
  SHD_FUZZ_CHECK(host.ok(shd_sampler_create(host.context, &desc, &sampler)));
  std::vector<float> out(4 * lookups.count);
  shd_texels texels = shd_texels_default();
  for (size_t c = 0; c < 4; ++c) texels.channel[c].data = &out[c * lookups.count];
  SHD_FUZZ_CHECK(host.ok(shd_texture_sample(texture, sampler, &lookups, &texels)));
  shd_sampler_release(sampler);
  return out;
}

bool is_srgb(shd_format format) {
  return format == SHD_FORMAT_BC1_RGB_SRGB || format == SHD_FORMAT_BC1_RGBA_SRGB || format == SHD_FORMAT_BC2_SRGB ||
         format == SHD_FORMAT_BC3_SRGB || format == SHD_FORMAT_BC7_SRGB;
}

/// The format of texels that lookups blend as the decoded blocks.
shd_format plain_of(shd_format format) {
  if (format >= SHD_FORMAT_BC4_SNORM && format != SHD_FORMAT_BC5 && format < SHD_FORMAT_BC7) return SHD_FORMAT_RGBA32F;
  if (format == SHD_FORMAT_BC4 || format == SHD_FORMAT_BC5) return SHD_FORMAT_RGBA16;
  return is_srgb(format) ? SHD_FORMAT_RGBA8_SRGB : SHD_FORMAT_RGBA8;
}

/// Returns the texels of a level of blocks in plain_of(), by nearest lookups of a texture of one level.
std::vector<uint8_t> decoded(const Host& host, const Case& c, const std::vector<uint8_t>& blocks, uint32_t level) {
  Case one = c;
  if (is_srgb(c.format)) one.format = static_cast<shd_format>(c.format - 1);  // codes are those of the linear format
  one.width = side_of(c.width, level);
  one.height = side_of(c.height, level);
  one.layers = one.levels = 1;
  Levels levels;
  levels.memory = {blocks};
  finish(one, one.format, &levels);
  shd_texture* texture = make_texture(host, one, one.format, levels);
  const size_t count = size_t{one.width} * one.height;
  std::vector<float> u(count), v(count);
  for (size_t i = 0; i < count; ++i) {
    u[i] = (static_cast<float>(i % one.width) + 0.5f) / static_cast<float>(one.width);
    v[i] = (static_cast<float>(i / one.width) + 0.5f) / static_cast<float>(one.height);
  }
  shd_lookups lookups = shd_lookups_default();
  lookups.count = count;
  lookups.u.data = u.data(), lookups.v.data = v.data();
  shd_sampler_desc desc = shd_sampler_desc_default();
  desc.filter = SHD_FILTER_NEAREST;
  const std::vector<float> columns = sample(host, texture, desc, lookups);
  shd_texture_release(texture);
  std::vector<float> rgba(4 * count);
  for (size_t i = 0; i < rgba.size(); ++i) rgba[i] = columns[i % 4 * count + i / 4];
  const size_t size = shd_format_size(plain_of(c.format)) / 4;
  std::vector<uint8_t> bytes(rgba.size() * size);
  for (size_t i = 0; i < rgba.size(); ++i) {
    const auto code = size == 4 ? 0u : static_cast<uint32_t>(std::lround(rgba[i] * (size == 1 ? 255.0f : 65535.0f)));
    std::memcpy(&bytes[i * size], size == 4 ? static_cast<const void*>(&rgba[i]) : &code, size);
  }
  return bytes;
}

void check(const Host& host, const Case& c) {
  Levels blocks, texels;
  Random random(c.seed);
  for (uint32_t i = 0; i < c.layers * c.levels; ++i) {
    std::vector<uint8_t> memory(level_bytes(c, c.format, i % c.levels));
    for (uint8_t& byte : memory) byte = static_cast<uint8_t>(random.bits());
    texels.memory.push_back(decoded(host, c, memory, i % c.levels));
    blocks.memory.push_back(std::move(memory));
  }
  finish(c, c.format, &blocks);
  finish(c, plain_of(c.format), &texels);
  shd_texture* const compressed = make_texture(host, c, c.format, blocks);
  shd_texture* const plain = make_texture(host, c, plain_of(c.format), texels);
  shd_lookups lookups = shd_lookups_default();
  shd_f32_in* const in[6] = {&lookups.u, &lookups.v, &lookups.dudx, &lookups.dvdx, &lookups.dudy, &lookups.dvdy};
  lookups.count = kLookups;
  for (size_t k = 0; k < 6; ++k) in[k]->data = c.columns[k].data();
  lookups.layer.data = c.layer.data();
  const std::vector<float> found = sample(host, compressed, c.sampler, lookups);
  const std::vector<float> wanted = sample(host, plain, c.sampler, lookups);
  SHD_FUZZ_CHECK(std::memcmp(found.data(), wanted.data(), found.size() * sizeof(float)) == 0);
  shd_texture_release(compressed);
  shd_texture_release(plain);
}

}  // namespace

void describe(Source& source) {
  Case c;
  choose_case(source, c);
}

}  // namespace shd::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace shd::fuzz;
  Source source(data, size);
  Case c;
  choose_case(source, c);
  for (const shd_simd simd : {SHD_SIMD_BEST, SHD_SIMD_BASELINE}) {
    const Host host(simd, UINT64_MAX);
    check(host, c);
  }
  return 0;
}
