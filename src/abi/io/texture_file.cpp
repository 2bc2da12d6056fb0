// SPDX-License-Identifier: MIT
#include <shd/texture_file.h>

#include <algorithm>
#include <vector>

#include "abi/io/common.h"
#include "abi/io/request.h"
#include "core/read_desc.h"
#include "image/format.h"
#include "io/inflate.h"
#include "io/ktx2_write.h"
#include "io/levels.h"
#include "io/printable.h"
#include "io/read_file.h"
#include "io/texture_file.h"
#include "io/write_file.h"

namespace {

using namespace shd;
using namespace shd::extension;

LoadRequest read_file_load(const shd_load_desc* in) {
  LoadRequest request = read_load_desc(in);
  constexpr uint32_t kFlags = SHD_LOAD_IN_PROCESS | SHD_LOAD_FILE_LEVELS | SHD_LOAD_FLIP_V;
  if (request.desc.flags & ~kFlags) {
    refuse(SHD_ERROR_UNSUPPORTED, "load.flags: bits 0x%x have no meaning for a texture file",
           request.desc.flags & ~kFlags);
  }
  if (request.desc.formats != 0) {
    refuse(SHD_ERROR_UNSUPPORTED, "load.formats: 0x%x, but a texture file is KTX2 or DDS: set 0", request.desc.formats);
  }
  return request;
}

bool is_blocks(shd_format format) {
  return image::block_info(format).block_size != 0;
}

/// The part of the file that becomes the texture.
io::Selection select(const io::TextureFile& parsed, const LoadRequest& request) {
  const shd_texture_file_info& info = parsed.info;
  io::Selection selection;
  selection.image_count = info.faces == 6 ? 6 : info.layers;
  const uint32_t choices = info.faces == 6 ? info.layers : 1;
  if (request.desc.subimage >= choices) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "load.subimage: %u is not in 0..%u of the cube maps of the file",
           request.desc.subimage, choices - 1);
  }
  selection.first_image = request.desc.subimage * selection.image_count;
  selection.level_count = request.desc.tables & SHD_TABLE_MIPMAP ? info.level_count : 1;
  selection.flip_rows = (request.desc.flags & SHD_LOAD_FLIP_V) != 0;
  if (selection.flip_rows && is_blocks(info.format)) {
    refuse(SHD_ERROR_UNSUPPORTED, "load.flags: SHD_LOAD_FLIP_V, but rows within blocks of format %d cannot be reversed",
           static_cast<int>(info.format));
  }
  return selection;
}

/// Images of levels 1 and up, in the order of shd_texture_desc.levels.
std::vector<shd_image> list_levels(const io::TextureFile& parsed, const io::Selection& selection,
                                   const io::TextureTexels& texels) {
  const shd_texture_file_info& info = parsed.info;
  std::vector<shd_image> images;
  const auto add = [&](uint32_t level, const unsigned char* pixels) {
    shd_image image = shd_image_default();
    image.format = info.format;
    image.width = io::level_side(info.width, level);
    image.height = io::level_side(info.height, level);
    image.pixels = const_cast<unsigned char*>(pixels);
    images.push_back(image);
  };
  if (info.depth != 0) {
    for (uint32_t l = 1; l < selection.level_count; ++l) {
      const image::RowLayout rows =
          image::row_layout(info.format, io::level_side(info.width, l), io::level_side(info.height, l));
      const size_t slice = rows.row_size * rows.rows;
      for (uint32_t z = 0; z < io::level_side(info.depth, l); ++z) add(l, texels.levels[l].texels + z * slice);
    }
    return images;
  }
  for (uint32_t i = 0; i < selection.image_count; ++i) {
    for (uint32_t l = 1; l < selection.level_count; ++l) {
      add(l, texels.levels[l].texels + i * texels.levels[l].image_stride);
    }
  }
  return images;
}

shd_result make_texture(shd_context* context, const io::TextureFile& parsed, const io::Selection& selection,
                        const io::TextureTexels& texels, uint32_t tables, shd_texture** out_texture) {
  const shd_texture_file_info& info = parsed.info;
  const std::vector<shd_image> levels = list_levels(parsed, selection, texels);
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = info.format;
  desc.width = info.width;
  desc.height = info.height;
  desc.depth = info.depth;
  desc.layers = selection.image_count;
  desc.projection = info.faces == 6 ? SHD_PROJECTION_CUBE : SHD_PROJECTION_NONE;
  desc.texels = texels.levels[0].texels;
  desc.layer_stride = info.depth != 0 || selection.image_count == 1 ? 0 : texels.levels[0].image_stride;
  desc.level_count = selection.level_count - 1;
  desc.levels = levels.empty() ? nullptr : levels.data();
  desc.tables = tables;
  // Blocks have only the levels of the file.
  if (is_blocks(info.format) && selection.level_count == 1) desc.tables &= ~uint32_t{SHD_TABLE_MIPMAP};
  std::copy(parsed.swizzle, parsed.swizzle + 4, desc.swizzle);
  std::copy(parsed.fill, parsed.fill + 4, desc.fill);
  return shd_texture_create(context, &desc, out_texture);
}

shd_result load_bytes(shd_context* context, const unsigned char* bytes, size_t size, const LoadRequest& request,
                      shd_texture_file_info* out_info, shd_texture** out_texture) {
  const io::Limits& limits = request.options.limits;
  const io::TextureFile parsed = io::parse_texture_file(bytes, size, request.desc.color_space, limits);
  const io::Selection selection = select(parsed, request);
  const io::TextureTexels texels = io::unpack_levels(parsed, bytes, selection, limits, memory_of(context));
  require(make_texture(context, parsed, selection, texels, request.desc.tables, out_texture));
  if (!out_info) return SHD_OK;
  shd_texture_file_info info = parsed.info;
  info.struct_size = shd_texture_file_info_default().struct_size;
  write_desc(info, out_info);
  return SHD_OK;
}

/// Checks what both loads have.
LoadRequest begin_load(shd_context* context, const shd_load_desc* load, shd_texture_file_info* out_info,
                       shd_texture** out_texture) {
  if (!out_texture) refuse(SHD_ERROR_INVALID_ARGUMENT, "out_texture: NULL");
  *out_texture = nullptr;
  if (out_info) require(begin_output("out_info", out_info));
  require_context(context);
  return read_file_load(load);
}

// Writing.

shd_ktx2_desc read_ktx2_desc(const shd_ktx2_desc* in) {
  shd_ktx2_desc desc = shd_ktx2_desc_default();
  read_desc("ktx2", in, &desc);
  const uint32_t scheme = core::enum_bits(desc.supercompression);
  if (scheme > SHD_SUPERCOMPRESSION_ZLIB) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "ktx2.supercompression: %u is not a shd_supercompression", scheme);
  }
  const int32_t most = io::most_effort(desc.supercompression);
  if (desc.supercompression != SHD_SUPERCOMPRESSION_NONE && most == 0) {
    refuse(
        SHD_ERROR_UNSUPPORTED,
        "ktx2.supercompression: %u, but this libshd_io was built without its library (Debian: libzstd-dev, zlib1g-dev)",
        scheme);
  }
  if (desc.effort < 0 || desc.effort > most) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "ktx2.effort: %d is not in 0..%d", desc.effort, most);
  }
  if (desc.channels != 0 && desc.channels != 3) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "ktx2.channels: %u is not 0 or 3", desc.channels);
  }
  return desc;
}

/// The format with the first three channels of four.
shd_format three_channels(shd_format format) {
  switch (format) {
    case SHD_FORMAT_RGBA8: return SHD_FORMAT_RGB8;
    case SHD_FORMAT_RGBA8_SRGB: return SHD_FORMAT_RGB8_SRGB;
    case SHD_FORMAT_RGBA16: return SHD_FORMAT_RGB16;
    case SHD_FORMAT_RGBA16F: return SHD_FORMAT_RGB16F;
    case SHD_FORMAT_RGBA32F: return SHD_FORMAT_RGB32F;
    default:
      refuse(SHD_ERROR_INVALID_ARGUMENT,
             "ktx2.channels: 3, but format %d of the texture has no four channels of "
             "pixels",
             static_cast<int>(format));
  }
}

/// Removes the fourth channel of `pixels` behind `first`.
void drop_alpha(size_t pixel_size, size_t first, std::vector<unsigned char>* pixels) {
  const size_t kept = pixel_size / 4 * 3;
  unsigned char* to = pixels->data() + first;
  for (const unsigned char* from = to; from != pixels->data() + pixels->size(); from += pixel_size, to += kept) {
    std::copy(from, from + kept, to);
  }
  pixels->resize(static_cast<size_t>(to - pixels->data()));
}

/// All images of a level.
std::vector<unsigned char> read_images(const shd_texture* texture, const shd_texture_info& info, uint32_t level,
                                       bool without_alpha) {
  shd_image image = shd_image_default();
  image.format = info.format;
  image.width = io::level_side(info.width, level);
  image.height = io::level_side(info.height, level);
  const image::RowLayout rows = image::row_layout(info.format, image.width, image.height);
  const uint32_t count = info.depth != 0 ? io::level_side(info.depth, level) : info.layers;
  std::vector<unsigned char> pixels;
  pixels.reserve(rows.row_size * rows.rows * count);
  for (uint32_t i = 0; i < count; ++i) {
    const size_t first = pixels.size();
    // The images of a level are packed, and those of numbers of several bytes need aligned memory.
    std::vector<unsigned char> one(rows.row_size * rows.rows);
    image.pixels = one.data();
    require(shd_texture_read_level(texture, i, level, &image));
    pixels.insert(pixels.end(), one.begin(), one.end());
    if (without_alpha) drop_alpha(shd_format_size(info.format), first, &pixels);
  }
  return pixels;
}

io::Ktx2Content read_texture(const shd_texture* texture, const shd_ktx2_desc& desc) {
  shd_texture_info info = shd_texture_info_default();
  require(shd_texture_get_info(texture, &info));
  if (info.projection != SHD_PROJECTION_NONE && info.projection != SHD_PROJECTION_CUBE) {
    refuse(SHD_ERROR_UNSUPPORTED, "texture: KTX2 has no projection %d", static_cast<int>(info.projection));
  }
  const bool cube = info.projection == SHD_PROJECTION_CUBE;
  io::Ktx2Content content;
  content.format = desc.channels == 3 ? three_channels(info.format) : info.format;
  content.width = info.width;
  content.height = info.height;
  content.depth = info.depth;
  content.faces = cube ? 6 : 1;
  content.layers = cube || info.layers == 1 ? 0 : info.layers;
  for (uint32_t l = 0; l < info.level_count; ++l) {
    content.levels.push_back(read_images(texture, info, l, desc.channels == 3));
  }
  return content;
}

}  // namespace

extern "C" {

shd_result shd_texture_load_file(shd_context* context, const char* path, const shd_load_desc* load,
                                 shd_texture_file_info* out_info, shd_texture** out_texture) {
  return guard([&]() -> shd_result {
    const LoadRequest request = begin_load(context, load, out_info, out_texture);
    require_path(path);
    const io::OpenFile file = io::open_file(path, request.options.limits);
    try {
      const io::Buffer bytes = io::read_bytes(file.file.fd, file.size, memory_of(context));
      return load_bytes(context, bytes.data(), bytes.size(), request, out_info, out_texture);
    } catch (const Failure& failure) {
      refuse(failure.code, "\"%s\": %s", io::printable(path).c_str(), failure.what());
    }
  });
}

shd_result shd_texture_load_file_memory(shd_context* context, const void* bytes, size_t size, const shd_load_desc* load,
                                        shd_texture_file_info* out_info, shd_texture** out_texture) {
  return guard([&]() -> shd_result {
    const LoadRequest request = begin_load(context, load, out_info, out_texture);
    if (!bytes) refuse(SHD_ERROR_INVALID_ARGUMENT, "bytes: NULL");
    if (size > request.options.limits.file_bytes) {
      refuse(SHD_ERROR_LIMIT, "size: %zu bytes are above load.max_file_bytes %llu", size,
             static_cast<unsigned long long>(request.options.limits.file_bytes));
    }
    return load_bytes(context, static_cast<const unsigned char*>(bytes), size, request, out_info, out_texture);
  });
}

shd_result shd_texture_save_ktx2(const shd_texture* texture, const char* path, const shd_ktx2_desc* desc) {
  return guard([&]() -> shd_result {
    const shd_ktx2_desc options = read_ktx2_desc(desc);
    require_path(path);
    const std::vector<unsigned char> file =
        io::write_ktx2(read_texture(texture, options), options.supercompression, options.effort);
    io::write_file(path, file.data(), file.size());
    return SHD_OK;
  });
}

}  // extern "C"
