// SPDX-License-Identifier: MIT
#include "io/container/texture_load.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/failure.h"
#include "image/format.h"
#include "io/container/texture_file.h"
#include "io/file/byte_reader.h"

namespace shd::io {

namespace {

bool is_blocks(shd_format format) {
  return image::block_info(format).block_size != 0;
}

/// The part of the file that becomes the texture.
Selection select_texture(const shd_texture_file_info& info, const LoadOptions& options) {
  Selection selection;
  selection.image_count = info.face_count == 6 ? 6 : info.layer_count;
  const uint32_t choices = info.face_count == 6 ? info.layer_count : 1;
  if (options.subimage >= choices) {
    core::refuse(SHD_ERROR_INVALID_ARGUMENT, "load.subimage: %u is not in 0..%u of the cube maps of the file",
                 options.subimage, choices - 1);
  }
  selection.first_image = options.subimage * selection.image_count;
  selection.level_count = options.flags & SHD_LOAD_FILE_LEVELS ? info.level_count : 1;
  selection.flip_rows = (options.flags & SHD_LOAD_FLIP_V) != 0;
  if (selection.flip_rows && is_blocks(info.format)) {
    core::refuse(SHD_ERROR_UNSUPPORTED,
                 "load.flags: SHD_LOAD_FLIP_V, but rows within blocks of format %d cannot be "
                 "reversed",
                 static_cast<int>(info.format));
  }
  return selection;
}

/// The image that becomes a bitmap.
Selection select_image(const shd_texture_file_info& info, const LoadOptions& options) {
  if (info.depth > 1) core::refuse(SHD_ERROR_UNSUPPORTED, "volumes are not supported");
  Selection selection;
  selection.first_image = options.subimage;
  if (options.subimage >= info.layer_count * info.face_count) {
    core::refuse(SHD_ERROR_NOT_FOUND, "load.subimage: the file has no image %u", options.subimage);
  }
  return selection;
}

TextureLayout describe(const TextureFile& parsed, const Selection& selection) {
  TextureLayout layout;
  layout.info = parsed.info;
  layout.image_count = selection.image_count;
  layout.level_count = selection.level_count;
  std::copy(parsed.swizzle, parsed.swizzle + 4, layout.swizzle);
  std::copy(parsed.fill, parsed.fill + 4, layout.fill);
  for (uint32_t l = 0; l < selection.level_count; ++l) {
    layout.size += uint64_t{unpacked_size(parsed, l)} * selection.image_count;
  }
  return layout;
}

/// Calls take(bytes, size) for the texels of all levels and images in order.
template <class Take>
void visit_texels(const TextureFile& parsed, const Selection& selection, const TextureTexels& texels, Take&& take) {
  for (uint32_t l = 0; l < selection.level_count; ++l) {
    const LevelTexels& level = texels.levels[l];
    const size_t image = unpacked_size(parsed, l);
    if (level.image_stride == image) {
      take(level.texels, image * selection.image_count);
      continue;
    }
    for (uint32_t i = 0; i < selection.image_count; ++i) take(level.texels + i * level.image_stride, image);
  }
}

shd_bitmap_info info_of(const TextureFile& parsed) {
  const shd_format format = parsed.info.format;
  shd_bitmap_info info = {};
  info.file_format = parsed.info.kind == SHD_TEXTURE_FILE_KIND_DDS ? SHD_FILE_FORMAT_DDS : SHD_FILE_FORMAT_KTX2;
  const size_t channels = is_blocks(format) ? image::block_info(format).channels : image::format_info(format).channels;
  info.channel_count = static_cast<uint32_t>(channels);
  if (parsed.info.flags & SHD_TEXTURE_FILE_PREMULTIPLIED) info.flags |= SHD_BITMAP_PREMULTIPLIED;
  if (parsed.absent > 0) info.flags |= SHD_BITMAP_PARTIAL;
  return info;
}

}  // namespace

Container container_of(const unsigned char* bytes, size_t size) {
  const ByteReader in{bytes, size, false};
  if (is_ktx2(bytes, size) || is_dds(bytes, size)) return Container::kTexture;
  return in.is(0, " BDV\0\0\0\0", 8) ? Container::kGrid : Container::kImage;
}

Bitmap load_texture_file(const unsigned char* bytes, size_t size, const LoadOptions& options, const Memory& memory,
                         const Sink* sink) {
  const bool partial = (options.flags & SHD_LOAD_PARTIAL) != 0;
  const TextureFile parsed = parse_texture_file(bytes, size, options.encoding, partial, options.limits);
  const bool whole = options.parts == Parts::kTexture;
  const Selection selection = whole ? select_texture(parsed.info, options) : select_image(parsed.info, options);
  Buffer padded;
  if (parsed.absent > 0) {
    padded = Buffer(memory, size + static_cast<size_t>(parsed.absent));
    std::memcpy(padded.data(), bytes, size);
    std::memset(padded.data() + size, 0, static_cast<size_t>(parsed.absent));
    bytes = padded.data();
  }
  TextureTexels texels = unpack_levels(parsed, bytes, selection, options.limits, memory);
  Bitmap out;
  out.format = parsed.info.format;
  out.width = parsed.info.width;
  out.height = parsed.info.height;
  out.layout = describe(parsed, selection);
  out.info = info_of(parsed);
  if (sink) sink->begin(sink->owner, out, kSingle);
  if (sink && padded.size() == 0) {
    visit_texels(parsed, selection, texels,
                 [&](const unsigned char* from, size_t count) { sink->take(sink->owner, from, count); });
  }
  if (texels.memory.size()) {
    out.pixels = std::move(texels.memory);
  } else if (!sink || padded.size()) {
    out.pixels = Buffer(memory, static_cast<size_t>(out.layout.size));
    unsigned char* to = out.pixels.data();
    visit_texels(parsed, selection, texels, [&](const unsigned char* from, size_t count) {
      std::memcpy(to, from, count);
      to += count;
    });
  }
  if (sink && padded.size()) sink->take(sink->owner, out.pixels.data(), out.pixels.size());
  return out;
}

void check_layout(const TextureLayout& layout, const LoadOptions& options) {
  const shd_texture_file_info& info = layout.info;
  const auto format = static_cast<uint32_t>(info.format);
  bool good = info.kind == SHD_TEXTURE_FILE_KIND_KTX2 || info.kind == SHD_TEXTURE_FILE_KIND_DDS;
  good = good && static_cast<uint32_t>(info.supercompression) <= SHD_SUPERCOMPRESSION_ZLIB && info.flags < 16;
  good = good && (image::is_format(format) || image::is_block_format(format));
  for (const shd_channel channel : layout.swizzle) good = good && static_cast<uint32_t>(channel) <= SHD_CHANNEL_FILL;
  for (const float value : layout.fill) good = good && std::isfinite(value);
  if (!good) core::refuse(SHD_ERROR_CORRUPT, "the decoder sent a wrong texture");
  TextureFile parsed;
  parsed.info = info;
  parsed.storage = plain_storage(info.format);
  check_sizes("the texture of the decoder", options.limits, &parsed);
  const bool whole = options.parts == Parts::kTexture;
  const Selection selection = whole ? select_texture(info, options) : select_image(info, options);
  std::copy(layout.swizzle, layout.swizzle + 4, parsed.swizzle);
  std::copy(layout.fill, layout.fill + 4, parsed.fill);
  const TextureLayout expected = describe(parsed, selection);
  if (layout.image_count != expected.image_count || layout.level_count != expected.level_count ||
      layout.size != expected.size) {
    core::refuse(SHD_ERROR_CORRUPT, "the decoder sent a wrong size");
  }
}

}  // namespace shd::io
