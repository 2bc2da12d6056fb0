// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/io.h>

#include "io/file/byte_reader.h"
#include "io/file/limits.h"
#include "io/file/memory.h"

namespace shd::io {

/// Levels below a base of 2^20 texels, the base included.
constexpr uint32_t kMaxFileLevels = 21;

/// Conversion of the texels of a file to those of the texture.
enum class Unpack : uint32_t {
  kNone,      // as they are
  kSwapRgba,  // four channels of 8 bits: b, g, r, a
  kSwapRgb,   // three channels of 8 bits: b, g, r
  kSwapRgbx,  // as kSwapRgba, and the fourth byte has no meaning
  kMasks,     // bit fields of a small pixel to RGBA8
  kAstc,      // ASTC blocks to four channels
};

/// Storage of the texels of a file. A "unit" is a pixel, or a block of block_width x block_height texels.
struct Storage {
  shd_format format = SHD_FORMAT_NONE;  // storage in the texture
  Unpack unpack = Unpack::kNone;
  uint32_t unit_size = 0;  // bytes
  uint32_t block_width = 1, block_height = 1;
  uint32_t masks[4] = {};  // bits of r, g, b, a with Unpack::kMasks
};

/// A part of the file, or of unpacked memory.
struct Span {
  uint64_t offset = 0, size = 0;
};

/// The curve that a file declares for r, g and b.
enum class Declared { kNothing, kLinear, kSrgb, kOther };

/// A parsed file. All sizes are checked. An image is a layer of a level, with all slices of a 3D texture.
struct TextureFile {
  shd_texture_file_info info = {};
  Storage storage;
  uint32_t images = 1;  // layers * faces
  shd_channel swizzle[4] = {};
  float fill[4] = {0, 0, 0, 1};
  Span levels[kMaxFileLevels];                 // all images of a level that the file stores together
  uint64_t image_stride[kMaxFileLevels] = {};  // between the images of a level, before supercompression
  uint64_t absent = 0;                         // bytes that lie behind the end of the file, with SHD_LOAD_PARTIAL
};

/// Size of one image of a level in bytes. Cannot overflow after check_sizes().
uint64_t image_size(const TextureFile& parsed, uint32_t level);

/// Bytes of an image of a level in the texture.
size_t unpacked_size(const TextureFile& parsed, uint32_t level);

/// Number of levels down to 1 x 1 x 1.
uint32_t whole_level_count(const shd_texture_file_info& info);

/// Checks sides, layers, faces, levels and texels of a file against the limits of textures and the budgets, and
/// computes `images`. Throws Failure.
void check_sizes(const char* file, const Limits& limits, TextureFile* parsed);

/// Storage of a VkFormat or a DXGI_FORMAT; SHD_FORMAT_NONE if textures cannot have it.
Storage storage_of_vulkan(uint32_t format);
Storage storage_of_dxgi(uint32_t format);

/// Storage of a format without unpacking.
Storage plain_storage(shd_format format);

/// The _SRGB format of the same storage, and the other one; SHD_FORMAT_NONE if there is no _SRGB format.
shd_format with_srgb(shd_format format);
shd_format without_srgb(shd_format format);

/// The format of the texture: `stored` with the curve that the caller wants, or that the file declares. Throws Failure.
shd_format choose_curve(const char* file, shd_format stored, Declared declared, shd_color_encoding encoding);

/// Whether the bytes begin as a file of this kind.
bool is_ktx2(const unsigned char* bytes, size_t size);
bool is_dds(const unsigned char* bytes, size_t size);

/// Parses a file (Khronos, "KTX File Format Specification 2.0", 2021). Levels may lie behind the bytes that are here.
/// Throws Failure.
TextureFile parse_ktx2(ByteReader in, shd_color_encoding encoding, const Limits& limits);

/// Parses a file (Microsoft, "Programming Guide for DDS"). `partial`: levels may be cut off. Throws Failure.
TextureFile parse_dds(ByteReader in, shd_color_encoding encoding, bool partial, const Limits& limits);

/// Either of both, by content. `behind`: bytes of the file behind the `size` bytes.
TextureFile parse_texture_file(const unsigned char* bytes, size_t size, shd_color_encoding encoding, bool partial,
                               const Limits& limits, uint64_t behind = 0);

/// Where the texels of the texture are.
struct LevelTexels {
  const unsigned char* texels = nullptr;  // the first image that is read
  size_t image_stride = 0;                // bytes
};

/// Texels of a texture, in the file's bytes or in memory of their own.
struct TextureTexels {
  LevelTexels levels[kMaxFileLevels];
  Buffer memory;
};

/// The part of a parsed file that is read.
struct Selection {
  uint32_t first_image = 0, image_count = 1;
  uint32_t level_count = 1;
  bool flip_rows = false;
};

/// Decompresses and unpacks levels. The file's bytes are used in place where they are the texels and are aligned.
/// Throws Failure.
TextureTexels unpack_levels(const TextureFile& parsed, const unsigned char* bytes, const Selection& selection,
                            const Limits& limits, const Memory& memory);

}  // namespace shd::io
