// SPDX-License-Identifier: MIT
// DDS files as textures. The numbers are those of Microsoft, "DDS_HEADER structure", "DDS_PIXELFORMAT structure" and
// "DDS_HEADER_DXT10 structure".
#include <algorithm>
#include <cstring>

#include "core/failure.h"
#include "io/bitmap/levels.h"
#include "io/container/texture_file.h"
#include "io/file/byte_reader.h"

namespace shd::io {

namespace {

constexpr const char* kDdsName = "DDS";
constexpr uint64_t kDdsHeader = 128;
constexpr uint64_t kHeaderDx10 = 148;
constexpr uint32_t kAlphaPixels = 0x1, kAlpha = 0x2, kFourCc = 0x4, kRgb = 0x40, kLuminance = 0x20000;
constexpr uint32_t kDepthFlag = 0x800000;
constexpr uint32_t kCube = 0x200, kAllFaces = 0xfc00, kVolume = 0x200000;

struct CodeRow {
  char code[5];
  shd_format format;
  bool premultiplied;
};
// RXGB is DXT5 with red in alpha, of normal maps.
constexpr CodeRow kCodes[] = {
    {"DXT1", SHD_FORMAT_BC1_RGBA, false}, {"DXT2", SHD_FORMAT_BC2, true},        {"DXT3", SHD_FORMAT_BC2, false},
    {"DXT4", SHD_FORMAT_BC3, true},       {"DXT5", SHD_FORMAT_BC3, false},       {"ATI1", SHD_FORMAT_BC4, false},
    {"BC4U", SHD_FORMAT_BC4, false},      {"BC4S", SHD_FORMAT_BC4_SNORM, false}, {"ATI2", SHD_FORMAT_BC5, false},
    {"BC5U", SHD_FORMAT_BC5, false},      {"BC5S", SHD_FORMAT_BC5_SNORM, false}, {"RXGB", SHD_FORMAT_BC3, false},
};

struct NumberRow {
  uint32_t code;
  shd_format format;
};
constexpr NumberRow kNumbers[] = {
    // D3DFORMAT
    {36, SHD_FORMAT_RGBA16}, {111, SHD_FORMAT_R16F},  {112, SHD_FORMAT_RG16F},   {113, SHD_FORMAT_RGBA16F},
    {114, SHD_FORMAT_R32F},  {115, SHD_FORMAT_RG32F}, {116, SHD_FORMAT_RGBA32F},
};

void set_swizzle(TextureFile* parsed, shd_channel r, shd_channel g, shd_channel b, shd_channel a) {
  const shd_channel swizzle[4] = {r, g, b, a};
  std::copy(swizzle, swizzle + 4, parsed->swizzle);
}

/// Sizes, format and curve of the second header.
Declared read_dx10(ByteReader& in, TextureFile* parsed) {
  shd_texture_file_info& info = parsed->info;
  if (!in.has(0, kHeaderDx10)) core::refuse(SHD_ERROR_CORRUPT, "DDS: %zu bytes end within the DX10 header", in.size);
  constexpr uint32_t k2d = 3;
  const uint32_t format = in.u32(128), alpha = in.u32(144) & 7;
  const uint32_t dimension = in.u32(132) == 0 ? k2d : in.u32(132);  // some writers leave it out
  info.file_code = format;
  info.layer_count = std::max(in.u32(140), 1u);
  if (info.layer_count > 1) info.flags |= SHD_TEXTURE_FILE_ARRAY;
  info.face_count = in.u32(136) & 4 ? 6 : 1;
  if (dimension < 2 || dimension > 4) {
    core::refuse(SHD_ERROR_CORRUPT, "DDS: resourceDimension %u is not in 2..4", dimension);
  }
  info.depth = dimension == 4 ? std::max(in.u32(24), 1u) : 0;
  if (dimension == 2) info.height = 1;
  parsed->storage = storage_of_dxgi(format);
  if (parsed->storage.format == SHD_FORMAT_NONE) {
    core::refuse(SHD_ERROR_UNSUPPORTED, "DDS: dxgiFormat %u is not a format of shd; docs/compressed.md lists them",
                 format);
  }
  constexpr uint32_t kA8 = 65, kAlphaPremultiplied = 2, kAlphaOpaque = 3;
  if (format == kA8) {
    set_swizzle(parsed, SHD_CHANNEL_FILL, SHD_CHANNEL_FILL, SHD_CHANNEL_FILL, SHD_CHANNEL_R);
  }
  if (alpha == kAlphaPremultiplied) info.flags |= SHD_TEXTURE_FILE_PREMULTIPLIED;
  if (alpha == kAlphaOpaque) {
    set_swizzle(parsed, SHD_CHANNEL_DEFAULT, SHD_CHANNEL_DEFAULT, SHD_CHANNEL_DEFAULT, SHD_CHANNEL_FILL);
  }
  return without_srgb(parsed->storage.format) != parsed->storage.format ? Declared::kSrgb : Declared::kLinear;
}

/// Formats of a code in the first header.
Declared read_code(ByteReader& in, TextureFile* parsed) {
  for (const CodeRow& row : kCodes) {
    if (!in.is(84, row.code, 4)) continue;
    parsed->storage = plain_storage(row.format);
    if (row.premultiplied) parsed->info.flags |= SHD_TEXTURE_FILE_PREMULTIPLIED;
    if (row.code[0] != 'R') return Declared::kNothing;
    set_swizzle(parsed, SHD_CHANNEL_A, SHD_CHANNEL_G, SHD_CHANNEL_B, SHD_CHANNEL_FILL);
    return Declared::kLinear;
  }
  for (const NumberRow& row : kNumbers) {
    if (in.u32(84) != row.code) continue;
    parsed->storage = plain_storage(row.format);
    return Declared::kLinear;
  }
  core::refuse(SHD_ERROR_UNSUPPORTED, "DDS: dwFourCC 0x%08x is not a format of shd; docs/compressed.md lists them",
               in.u32(84));
}

/// Whether the bits of a mask are adjacent and at most eight.
bool is_byte_field(uint32_t mask) {
  if (mask == 0) return true;
  const uint32_t field = mask >> __builtin_ctz(mask);
  return field <= 0xff && (field & (field + 1)) == 0;
}

/// Formats of bit masks in the first header.
Declared read_masks(ByteReader& in, TextureFile* parsed) {
  const uint32_t flags = in.u32(80), bits = in.u32(88);
  const bool luminance = (flags & kLuminance) != 0, rgb = (flags & kRgb) != 0;
  uint32_t masks[4] = {in.u32(92), in.u32(96), in.u32(100), in.u32(104)};
  if (!(flags & (kAlphaPixels | kAlpha))) masks[3] = 0;
  if (!luminance && !rgb) masks[0] = masks[1] = masks[2] = 0;
  if (luminance) masks[1] = masks[2] = 0;
  // Palettes, YUV and signed numbers may have an alpha mask beside.
  constexpr uint32_t kOther = 0x8 | 0x20 | 0x200 | 0x40000 | 0x80000;
  if (flags & kOther) masks[0] = masks[1] = masks[2] = masks[3] = 0;
  const uint32_t all = masks[0] | masks[1] | masks[2] | masks[3];
  const uint64_t beyond = bits < 32 ? uint64_t{all} >> bits : 0;
  if ((bits != 8 && bits != 16 && bits != 24 && bits != 32) || all == 0 || beyond != 0) {
    core::refuse(SHD_ERROR_UNSUPPORTED, "DDS: pixels of %u bits, masks 0x%x, 0x%x, 0x%x, 0x%x and flags 0x%x", bits,
                 masks[0], masks[1], masks[2], masks[3], flags);
  }
  const bool words = masks[0] == 0xffff && masks[2] == 0 && masks[3] == 0;
  if (words && bits == (masks[1] ? 32u : 16u) && (masks[1] == 0 || masks[1] == 0xffff0000)) {
    parsed->storage = plain_storage(masks[1] ? SHD_FORMAT_RG16 : SHD_FORMAT_R16);
    if (luminance) set_swizzle(parsed, SHD_CHANNEL_R, SHD_CHANNEL_R, SHD_CHANNEL_R, SHD_CHANNEL_FILL);
    return Declared::kLinear;
  }
  const bool grey = luminance || (masks[1] == 0xff && masks[2] == 0xff);
  if (bits == 8 && masks[0] == 0xff && masks[1] == masks[2] && all == 0xff && masks[3] == 0) {
    parsed->storage = plain_storage(SHD_FORMAT_R8);
    if (grey) set_swizzle(parsed, SHD_CHANNEL_R, SHD_CHANNEL_R, SHD_CHANNEL_R, SHD_CHANNEL_FILL);
    return Declared::kNothing;
  }
  if (bits == 8 && masks[3] == 0xff && masks[0] == 0) {
    parsed->storage = plain_storage(SHD_FORMAT_R8);
    set_swizzle(parsed, SHD_CHANNEL_FILL, SHD_CHANNEL_FILL, SHD_CHANNEL_FILL, SHD_CHANNEL_R);
    return Declared::kLinear;
  }
  for (const uint32_t mask : masks) {
    if (is_byte_field(mask)) continue;
    core::refuse(SHD_ERROR_UNSUPPORTED, "DDS: the mask 0x%x is not of at most 8 adjacent bits", mask);
  }
  if (luminance) masks[1] = masks[2] = masks[0];
  parsed->storage = plain_storage(SHD_FORMAT_RGBA8);
  parsed->storage.unpack = Unpack::kMasks;
  parsed->storage.unit_size = bits / 8;
  std::copy(masks, masks + 4, parsed->storage.masks);
  return Declared::kNothing;
}

/// Kinds of texture in the first header.
void read_caps(ByteReader& in, TextureFile* parsed) {
  const uint32_t caps = in.u32(112);
  shd_texture_file_info& info = parsed->info;
  if (caps & kCube) {
    info.face_count = 6;
    if ((caps & kAllFaces) != kAllFaces) {
      core::refuse(SHD_ERROR_UNSUPPORTED, "DDS: a cube map without all faces, dwCaps2 0x%x", caps);
    }
  }
  const bool volume = (caps & kVolume) != 0 || ((in.u32(8) & kDepthFlag) != 0 && in.u32(24) > 1);
  if (volume) info.depth = std::max(in.u32(24), 1u);
}

/// Bytes of the first `count` levels of an image.
uint64_t level_bytes(const TextureFile& parsed, uint32_t count) {
  uint64_t size = 0;
  for (uint32_t l = 0; l < count; ++l) size += image_size(parsed, l);
  return size;
}

/// Some writers count the faces of a cube map as layers.
void count_cubes(const ByteReader& in, uint64_t first, uint64_t image, TextureFile* parsed) {
  const shd_texture_file_info& info = parsed->info;
  if (info.face_count != 6 || info.layer_count % 6 != 0 || in.file_has(first, image * parsed->images)) return;
  if (in.file_has(first, image * (parsed->images / 6))) {
    parsed->images /= 6;
    parsed->info.layer_count /= 6;
    if (info.layer_count == 1) parsed->info.flags &= ~uint32_t{SHD_TEXTURE_FILE_ARRAY};
  }
}

/// The images follow one another, each with its `stored` levels.
void place_levels(ByteReader& in, uint64_t first, uint32_t stored, bool partial, TextureFile* parsed) {
  const uint64_t image = level_bytes(*parsed, stored);
  count_cubes(in, first, image, parsed);
  const uint64_t all = image * (parsed->images - 1) + level_bytes(*parsed, parsed->info.level_count);
  if (!in.file_has(first, all)) {
    if (!partial || parsed->images > 1) {
      core::refuse(SHD_ERROR_CORRUPT,
                   "DDS: %llu bytes are below %llu of the header and %llu of %zu levels and %u images",
                   wide(in.file_size()), wide(first), wide(all), parsed->info.level_count, parsed->images);
    }
    size_t& count = parsed->info.level_count;
    while (count > 1 && !in.has(first, level_bytes(*parsed, count))) --count;
    const uint64_t end = first + level_bytes(*parsed, count);
    parsed->absent = end - std::min<uint64_t>(end, in.size);
  }
  for (uint32_t l = 0; l < parsed->info.level_count; ++l) {
    parsed->image_stride[l] = image;
    parsed->levels[l].offset = first + level_bytes(*parsed, l);
    parsed->levels[l].size = image * (parsed->images - 1) + image_size(*parsed, l);
  }
}

}  // namespace

bool is_dds(const unsigned char* bytes, size_t size) {
  return size >= 4 && std::memcmp(bytes, "DDS ", 4) == 0;
}

TextureFile parse_dds(ByteReader in, shd_color_encoding encoding, bool partial, const Limits& limits) {
  if (!in.has(0, kDdsHeader)) core::refuse(SHD_ERROR_CORRUPT, "DDS: %zu bytes end within the header", in.size);
  const uint32_t header = in.u32(4), pixel_format = in.u32(76);
  // Writers that store 0 or 24 as the second size mean the same structure.
  if (header != 124 || (pixel_format != 32 && pixel_format != 24 && pixel_format != 0)) {
    core::refuse(SHD_ERROR_CORRUPT, "DDS: headers of %u and %u bytes, not 124 and 32", header, pixel_format);
  }
  TextureFile parsed;
  shd_texture_file_info& info = parsed.info;
  info.kind = SHD_TEXTURE_FILE_KIND_DDS;
  info.height = in.u32(12);
  info.width = in.u32(16);
  info.layer_count = info.face_count = 1;
  info.level_count = std::max(in.u32(28), 1u);
  const bool code = (in.u32(80) & kFourCc) != 0;
  const bool dx10 = code && in.is(84, "DX10", 4);
  if (!dx10) read_caps(in, &parsed);
  const Declared declared = dx10 ? read_dx10(in, &parsed) : code ? read_code(in, &parsed) : read_masks(in, &parsed);
  const uint32_t stored = info.level_count;
  const bool sized = info.width <= limits.side && info.height <= limits.side && info.depth <= kMaxSide;
  if (sized && stored == whole_level_count(info) + 1) --info.level_count;  // one below 1 x 1
  check_sizes(kDdsName, limits, &parsed);
  place_levels(in, dx10 ? kHeaderDx10 : kDdsHeader, stored, partial, &parsed);
  parsed.storage.format = choose_curve(kDdsName, parsed.storage.format, declared, encoding);
  info.format = parsed.storage.format;
  return parsed;
}

}  // namespace shd::io
