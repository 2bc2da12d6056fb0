// SPDX-License-Identifier: MIT
/// @file
/// A decoded file, the options of a load, and the receiver of the pixels.
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/io.h>

#include "io/bitmap/channels.h"
#include "io/file/limits.h"
#include "io/file/memory.h"

namespace shd::io {

/// Parts of a file that a load reads.
enum class Parts : uint32_t {
  kImage,         // part `subimage`, as RGBA
  kSlice,         // part `subimage`; one channel stays one
  kSlices,        // all parts from `subimage` on, as the slices of a volume; one channel stays one
  kGrid,          // a grid of an OpenVDB file, as a volume of one channel
  kTexture,       // a KTX2 or DDS file as it is stored; SHD_LOAD_FILE_LEVELS: with its levels
  kTextureImage,  // image `subimage` of the base level of such a file
};

/// Grid and box of a load of Parts::kGrid.
struct GridRequest {
  uint32_t flags = SHD_VDB_NONE;
  int32_t box_min[3] = {}, box_max[3] = {};
  char name[256] = {};  // "" = the first grid of float or double
};

/// Properties of a loaded grid.
struct GridInfo {
  int32_t index_min[3] = {};
  float background = 0;
  uint32_t grid_class = SHD_VDB_CLASS_UNKNOWN;
  uint32_t reserved = 0;
  uint64_t active_voxels = 0;
  double index_to_world[16] = {};  // column-major
  char name[64] = {};
};

/// A load desc with its defaults filled in.
struct LoadOptions {
  Parts parts = Parts::kImage;
  uint32_t formats = SHD_FILE_FORMAT_DEFAULT;
  uint32_t flags = SHD_LOAD_NONE;
  shd_color_encoding encoding = SHD_COLOR_ENCODING_AUTO;
  uint32_t subimage = 0;
  GridRequest grid;
  Limits limits;
};

/// Contents of a bitmap of Parts::kTexture and kTextureImage: the images of each level one after the other, level 0
/// first, packed as a texture of info.format stores them.
struct TextureLayout {
  shd_texture_file_info info = {};  // the whole file
  uint32_t image_count = 0;         // layers or faces; 0 = the bitmap is no texture
  uint32_t level_count = 0;
  shd_channel swizzle[4] = {};
  float fill[4] = {0, 0, 0, 1};
  uint64_t size = 0;  // bytes
};

/// A decoded file. pixels: [depth][height][width] of `format`, packed, row 0 on top; the same of every further level
/// behind it. With SHD_LOAD_PARTIAL the buffer may be longer.
struct Bitmap {
  shd_format format = SHD_FORMAT_NONE;
  uint32_t width = 0;
  uint32_t height = 0;
  uint32_t depth = 1;        // slices; above 1 only without mip levels
  uint32_t level_count = 1;  // mip levels, the base included; sizes as in io/bitmap/levels.h
  shd_bitmap_info info = {};
  char color_space[64] = {};  // printable ASCII
  GridInfo grid;              // with Parts::kGrid
  TextureLayout layout;       // with Parts::kTexture and kTextureImage
  Buffer pixels;
};

/// Receives the pixels of a bitmap while it is decoded. The bitmap itself may have none.
struct Sink {
  void* owner;
  /// The description is complete, and the pixels will have this packing. Later, damage may add SHD_BITMAP_PARTIAL and
  /// lower level_count.
  void (*begin)(void* owner, const Bitmap& bitmap, const Packing& packing);
  /// Memory for the next bytes of the pixels. It is used again after some more calls.
  unsigned char* (*room)(void* owner, size_t size);
  /// The next bytes of the pixels, in memory from room() or of the bitmap, which does not change any more.
  void (*take)(void* owner, const unsigned char* bytes, size_t size);
};

/// Size of one pixel of a bitmap in bytes; 0 for formats that bitmaps cannot have.
inline size_t bitmap_pixel_size(shd_format format) {
  switch (format) {
    case SHD_FORMAT_R8:
    case SHD_FORMAT_R8_SRGB: return 1;
    case SHD_FORMAT_R16:
    case SHD_FORMAT_R16F: return 2;
    case SHD_FORMAT_R32F:
    case SHD_FORMAT_RGBA8:
    case SHD_FORMAT_RGBA8_SRGB: return 4;
    case SHD_FORMAT_RGBA16:
    case SHD_FORMAT_RGBA16F: return 8;
    case SHD_FORMAT_RGBA32F: return 16;
    default: return 0;
  }
}

/// Whether the pixels of a bitmap have one channel.
inline bool has_one_channel(shd_format format) {
  return format == SHD_FORMAT_R8 || format == SHD_FORMAT_R8_SRGB || format == SHD_FORMAT_R16 ||
         format == SHD_FORMAT_R16F || format == SHD_FORMAT_R32F;
}

}  // namespace shd::io
