// SPDX-License-Identifier: MIT
/// @file
/// Stage contract: io, files in and out.
///
/// Input:      untrusted bytes; rows of pixels to store.
/// Output:     Bitmap, rows from the top in one of libshd's formats: RGBA, or one channel of volumes; whole files.
/// Invariants: no file of this folder calls libshd, so that the worker process does not need it; failures are thrown by
///             core::refuse(); sizes are checked against the Limits before memory is allocated; OpenImageIO is given
///             memory, and open files only by oiio_tiles.cpp, whose files are trusted; files are opened by
///             core/regular_file.h and write_file.cpp alone; only the worker sets the process-wide attributes of
///             OpenImageIO; what a child of the worker sends is untrusted.
///
/// | file             | contents                                                             |
/// |------------------|----------------------------------------------------------------------|
/// | printable.h      | texts of files and of the system, made safe for messages             |
/// | memory.h         | Buffer, memory of the host's allocator                               |
/// | byte_reader.h    | numbers at checked places of untrusted bytes                         |
/// | file_descriptor.h| descriptors with an owner; failures of the system                    |
/// | memory_file.h    | an anonymous file for decoders that need a path                      |
/// | limits.h         | budgets: checked sizes, deadline                                     |
/// | read_file.h      | a regular file as bytes                                              |
/// | write_file.h     | atomic writing of a file                                             |
/// | sniff.h          | format and declared size from the first bytes                        |
/// | exr_header.h     | checks of an OpenEXR header                                          |
/// | bmp_header.h     | checks of a BMP header and its palette                               |
/// | hdr_header.h     | order of the pixels of a Radiance HDR file                           |
/// | jpeg_header.h    | checks of a JPEG frame header and the number of scans                |
/// | tga_header.h     | checks of a TGA header, its palette and its packets                  |
/// | scrub.h          | removal of metadata that decoders would parse                        |
/// | levels.h         | sizes of mip levels                                                  |
/// | raw_voxels.h     | numbers of a file of voxels in this machine's byte order             |
/// | numbered_path.h  | paths of a numbered series of files                                  |
/// | texture_file.h   | KTX2 and DDS files as textures: formats, parsing, unpacking           |
/// | texture_load.h   | such a file as a bitmap, and the checks of one that a worker sends    |
/// | texture_tiles.h  | such a file that stays open, and the texels of its tiles             |
/// | ktx2.h           | parts of a KTX2 file (ktx2*.cpp); dds_file.cpp parses DDS            |
/// | ktx2_write.h     | a KTX2 file from texels                                              |
/// | inflate.h        | Zstandard and zlib                                                   |
/// | astc.h           | ASTC blocks, the only user of libastcenc                             |
/// | tiff_pages.h     | the chain of pages of a TIFF                                         |
/// | channels.h       | selection of the channels r, g, b, a, and expansion to RGBA          |
/// | transfer.h       | colour-space names and transfer curves                               |
/// | plane_rows.h     | planes of a framebuffer as rows of a file                            |
/// | oiio.h           | decode and encode (oiio_encode.cpp) by OpenImageIO                   |
/// | oiio_tiles.h     | tiles of files that stay open, by OpenImageIO                        |
/// | udim.h           | the files of a UDIM set                                              |
/// | oiio_handle.h    | an input or output that prints nothing                               |
/// | oiio_module.h    | both in a module that a shared libshd_io opens at the first use      |
/// | vdb_header.h     | the grids of an OpenVDB file                                         |
/// | vdb.h            | decode_grid; vdb.cpp is the only user of OpenVDB                     |
/// | vdb_module.h     | decode_grid in a module                                              |
/// | module.h         | opening of modules                                                   |
/// | silence.h        | no messages of libtiff on stderr                                     |
/// | load.h           | the pipeline: sniff, scrub, check, decode                            |
/// | isolate.h        | the pipeline in a child of the worker                                |
/// | worker_link.h    | the worker of this process: started, connected, replaced             |
/// | worker_path.h    | where the program shd-io-worker is                                   |
/// | worker_protocol.h| messages between this process and its worker                         |
/// | packet.h         | sending and receiving with deadlines                                 |
/// | child_process.h  | starting and ending a program                                        |
/// | worker_job.h     | the worker: the server (worker_serve.cpp) and its children           |
/// | worker_memory.h  | memory of these children; worker_confine.h: limits by the system     |
#pragma once

#include <cstddef>
#include <cstdint>

#include <shd/io.h>

#include "io/channels.h"
#include "io/limits.h"
#include "io/memory.h"

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
  uint32_t flags = SHD_VDB_DEFAULT;
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
  uint32_t flags = SHD_LOAD_DEFAULT;
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
  uint32_t level_count = 1;  // mip levels, the base included; sizes as in io/levels.h
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
