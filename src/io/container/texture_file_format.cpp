// SPDX-License-Identifier: MIT
#include "core/failure.h"
#include "image/format.h"
#include "io/container/texture_file.h"

namespace shd::io {

namespace {

struct FormatRow {
  uint32_t code;
  shd_format format;
  Unpack unpack = Unpack::kNone;
};

// Vulkan 1.3, VkFormat.
constexpr FormatRow kVulkan[] = {
    {9, SHD_FORMAT_R8},
    {15, SHD_FORMAT_R8_SRGB},
    {16, SHD_FORMAT_RG8},
    {22, SHD_FORMAT_RG8_SRGB},
    {23, SHD_FORMAT_RGB8},
    {29, SHD_FORMAT_RGB8_SRGB},
    {30, SHD_FORMAT_RGB8, Unpack::kSwapRgb},
    {36, SHD_FORMAT_RGB8_SRGB, Unpack::kSwapRgb},
    {37, SHD_FORMAT_RGBA8},
    {43, SHD_FORMAT_RGBA8_SRGB},
    {44, SHD_FORMAT_RGBA8, Unpack::kSwapRgba},
    {50, SHD_FORMAT_RGBA8_SRGB, Unpack::kSwapRgba},
    {70, SHD_FORMAT_R16},
    {76, SHD_FORMAT_R16F},
    {77, SHD_FORMAT_RG16},
    {83, SHD_FORMAT_RG16F},
    {84, SHD_FORMAT_RGB16},
    {90, SHD_FORMAT_RGB16F},
    {91, SHD_FORMAT_RGBA16},
    {97, SHD_FORMAT_RGBA16F},
    {100, SHD_FORMAT_R32F},
    {103, SHD_FORMAT_RG32F},
    {106, SHD_FORMAT_RGB32F},
    {109, SHD_FORMAT_RGBA32F},
    {123, SHD_FORMAT_RGB9E5},
    {131, SHD_FORMAT_BC1_RGB},
    {132, SHD_FORMAT_BC1_RGB_SRGB},
    {133, SHD_FORMAT_BC1_RGBA},
    {134, SHD_FORMAT_BC1_RGBA_SRGB},
    {135, SHD_FORMAT_BC2},
    {136, SHD_FORMAT_BC2_SRGB},
    {137, SHD_FORMAT_BC3},
    {138, SHD_FORMAT_BC3_SRGB},
    {139, SHD_FORMAT_BC4},
    {140, SHD_FORMAT_BC4_SNORM},
    {141, SHD_FORMAT_BC5},
    {142, SHD_FORMAT_BC5_SNORM},
    {143, SHD_FORMAT_BC6H_UFLOAT},
    {144, SHD_FORMAT_BC6H_SFLOAT},
    {145, SHD_FORMAT_BC7},
    {146, SHD_FORMAT_BC7_SRGB},
};

// Microsoft, "DXGI_FORMAT".
constexpr FormatRow kDxgi[] = {
    {2, SHD_FORMAT_RGBA32F},
    {6, SHD_FORMAT_RGB32F},
    {10, SHD_FORMAT_RGBA16F},
    {11, SHD_FORMAT_RGBA16},
    {16, SHD_FORMAT_RG32F},
    {28, SHD_FORMAT_RGBA8},
    {29, SHD_FORMAT_RGBA8_SRGB},
    {34, SHD_FORMAT_RG16F},
    {35, SHD_FORMAT_RG16},
    {41, SHD_FORMAT_R32F},
    {49, SHD_FORMAT_RG8},
    {54, SHD_FORMAT_R16F},
    {56, SHD_FORMAT_R16},
    {61, SHD_FORMAT_R8},
    {65, SHD_FORMAT_R8},  // A8: the parser sets the swizzle
    {67, SHD_FORMAT_RGB9E5},
    {71, SHD_FORMAT_BC1_RGBA},
    {72, SHD_FORMAT_BC1_RGBA_SRGB},
    {74, SHD_FORMAT_BC2},
    {75, SHD_FORMAT_BC2_SRGB},
    {77, SHD_FORMAT_BC3},
    {78, SHD_FORMAT_BC3_SRGB},
    {80, SHD_FORMAT_BC4},
    {81, SHD_FORMAT_BC4_SNORM},
    {83, SHD_FORMAT_BC5},
    {84, SHD_FORMAT_BC5_SNORM},
    {87, SHD_FORMAT_RGBA8, Unpack::kSwapRgba},
    {88, SHD_FORMAT_RGBA8, Unpack::kSwapRgbx},
    {91, SHD_FORMAT_RGBA8_SRGB, Unpack::kSwapRgba},
    {93, SHD_FORMAT_RGBA8_SRGB, Unpack::kSwapRgbx},
    {95, SHD_FORMAT_BC6H_UFLOAT},
    {96, SHD_FORMAT_BC6H_SFLOAT},
    {98, SHD_FORMAT_BC7},
    {99, SHD_FORMAT_BC7_SRGB},
};

constexpr uint32_t kAstcLdr = 157;         // VK_FORMAT_ASTC_4x4_UNORM_BLOCK; the sRGB format of a size follows it
constexpr uint32_t kAstcHdr = 1000066000;  // VK_FORMAT_ASTC_4x4_SFLOAT_BLOCK
constexpr uint32_t kAstcSizes = 14;
constexpr unsigned char kAstcBlock[kAstcSizes][2] = {{4, 4}, {5, 4},  {5, 5},  {6, 5},  {6, 6},   {8, 5},   {8, 6},
                                                     {8, 8}, {10, 5}, {10, 6}, {10, 8}, {10, 10}, {12, 10}, {12, 12}};

Storage astc_storage(shd_format format, uint32_t size) {
  Storage storage;
  storage.format = format;
  storage.unpack = Unpack::kAstc;
  storage.unit_size = 16;
  storage.block_width = kAstcBlock[size][0];
  storage.block_height = kAstcBlock[size][1];
  return storage;
}

template <size_t kCount>
Storage find_storage(const FormatRow (&rows)[kCount], uint32_t code) {
  for (const FormatRow& row : rows) {
    if (row.code != code) continue;
    Storage storage = plain_storage(row.format);
    storage.unpack = row.unpack;
    return storage;
  }
  return {};
}

struct CurvePair {
  shd_format linear, srgb;
};
constexpr CurvePair kCurves[] = {
    {SHD_FORMAT_R8, SHD_FORMAT_R8_SRGB},           {SHD_FORMAT_RG8, SHD_FORMAT_RG8_SRGB},
    {SHD_FORMAT_RGB8, SHD_FORMAT_RGB8_SRGB},       {SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8_SRGB},
    {SHD_FORMAT_BC1_RGB, SHD_FORMAT_BC1_RGB_SRGB}, {SHD_FORMAT_BC1_RGBA, SHD_FORMAT_BC1_RGBA_SRGB},
    {SHD_FORMAT_BC2, SHD_FORMAT_BC2_SRGB},         {SHD_FORMAT_BC3, SHD_FORMAT_BC3_SRGB},
    {SHD_FORMAT_BC7, SHD_FORMAT_BC7_SRGB},
};

}  // namespace

Storage plain_storage(shd_format format) {
  Storage storage;
  storage.format = format;
  const size_t block = image::block_info(format).block_size;
  storage.unit_size = static_cast<uint32_t>(block ? block : image::format_info(format).pixel_size);
  storage.block_width = storage.block_height = block ? image::kBlockSide : 1;
  return storage;
}

Storage storage_of_vulkan(uint32_t format) {
  if (format >= kAstcLdr && format - kAstcLdr < 2 * kAstcSizes) {
    const bool srgb = (format - kAstcLdr) % 2 != 0;
    return astc_storage(srgb ? SHD_FORMAT_RGBA8_SRGB : SHD_FORMAT_RGBA8, (format - kAstcLdr) / 2);
  }
  if (format >= kAstcHdr && format - kAstcHdr < kAstcSizes) return astc_storage(SHD_FORMAT_RGBA16F, format - kAstcHdr);
  return find_storage(kVulkan, format);
}

Storage storage_of_dxgi(uint32_t format) {
  return find_storage(kDxgi, format);
}

shd_format with_srgb(shd_format format) {
  for (const CurvePair& pair : kCurves) {
    if (pair.linear == format || pair.srgb == format) return pair.srgb;
  }
  return SHD_FORMAT_NONE;
}

shd_format without_srgb(shd_format format) {
  for (const CurvePair& pair : kCurves) {
    if (pair.srgb == format) return pair.linear;
  }
  return format;
}

shd_format choose_curve(const char* file, shd_format stored, Declared declared, shd_color_encoding encoding) {
  const shd_format srgb = with_srgb(stored);
  if (encoding == SHD_COLOR_ENCODING_LINEAR || encoding == SHD_COLOR_ENCODING_DATA) return without_srgb(stored);
  if (encoding == SHD_COLOR_ENCODING_SRGB) {
    if (srgb != SHD_FORMAT_NONE) return srgb;
    core::refuse(SHD_ERROR_UNSUPPORTED, "load.encoding: SRGB, but format %d of the %s file has no _SRGB format",
                 static_cast<int>(stored), file);
  }
  switch (declared) {
    case Declared::kLinear: return without_srgb(stored);
    case Declared::kNothing: return srgb != SHD_FORMAT_NONE ? srgb : stored;
    case Declared::kSrgb:
      if (srgb != SHD_FORMAT_NONE) return srgb;
      core::refuse(SHD_ERROR_UNSUPPORTED,
                   "%s: the sRGB curve with format %d, which has no _SRGB format: set color_space", file,
                   static_cast<int>(stored));
    default:
      core::refuse(SHD_ERROR_UNSUPPORTED, "%s: a transfer curve that is neither sRGB nor linear: set color_space",
                   file);
  }
}

}  // namespace shd::io
