// SPDX-License-Identifier: MIT
// KTX2 and DDS files: textures as stored, and bitmaps of one image.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "image/channel.h"
#include "io/abi/common.h"
#include "io/abi/loads.h"
#include "io/bitmap/levels.h"
#include "io/bitmap/raw_voxels.h"
#include "io/check/sniff.h"
#include "io/container/texture_file.h"

namespace shd::extension {

namespace {

bool is_blocks(shd_format format) {
  return image::block_info(format).block_size != 0;
}

/// Images of levels 1 and up, in the order of shd_texture_desc.level_images: those of a level follow one another in
/// memory.
std::vector<shd_image> list_levels(const io::Bitmap& bitmap) {
  const io::TextureLayout& layout = bitmap.layout;
  const shd_texture_file_info& info = layout.info;
  const auto images_of = [&](uint32_t l) { return info.depth ? io::level_side(info.depth, l) : layout.image_count; };
  std::vector<std::vector<shd_image>> levels;
  unsigned char* next = bitmap.pixels.data();
  for (uint32_t l = 0; l < layout.level_count; ++l) {
    shd_image image = shd_image_default();
    image.format = info.format;
    image.width = io::level_side(info.width, l);
    image.height = io::level_side(info.height, l);
    const image::RowLayout rows = image::row_layout(info.format, image.width, image.height);
    std::vector<shd_image> images;
    for (uint32_t i = 0; i < images_of(l); ++i, next += rows.row_size * rows.rows) {
      image.pixels = next;
      images.push_back(image);
    }
    if (l > 0) levels.push_back(std::move(images));
  }
  std::vector<shd_image> out;
  if (info.depth) {
    for (const auto& images : levels) out.insert(out.end(), images.begin(), images.end());
    return out;
  }
  for (uint32_t i = 0; i < layout.image_count; ++i) {
    for (const auto& images : levels) out.push_back(images[i]);
  }
  return out;
}

shd_result make_texture(shd_context* context, const io::TextureLayout& layout, const void* texels,
                        const std::vector<shd_image>& levels, uint32_t tables, shd_texture** out_texture) {
  shd_texture_desc desc = describe_stored(layout.info, layout.image_count, layout.swizzle, layout.fill);
  desc.texels = texels;
  desc.level_count = layout.level_count - 1;
  desc.level_images = levels.empty() ? nullptr : levels.data();
  desc.tables = tables;
  // Blocks have only the levels of the file.
  if (is_blocks(desc.format) && layout.level_count == 1) desc.tables &= ~uint32_t{SHD_TABLE_MIPMAP};
  return shd_texture_create(context, &desc, out_texture);
}

/// References of one expansion.
struct Lookup {
  shd_texture* texture = nullptr;
  shd_sampler* sampler = nullptr;
  ~Lookup() {
    shd_texture_release(texture);
    shd_sampler_release(sampler);
  }
};

/// Looks up every texel of a texture and stores it as RGBA.
void expand_rows(const Lookup& lookup, bool flip, io::Bitmap* out) {
  // The numbers as they are stored, without the sRGB curve.
  const image::FormatInfo format = image::format_info(io::without_srgb(out->format));
  const size_t pixel = format.pixel_size, width = out->width;
  std::vector<float> columns(6 * width);
  shd_lookups places = shd_lookups_default();
  shd_texels texels = shd_texels_default();
  places.count = width;
  places.u.data = columns.data() + 4 * width;
  places.v.data = columns.data() + 5 * width;
  for (size_t c = 0; c < 4; ++c) texels.channel[c].data = columns.data() + c * width;
  for (size_t x = 0; x < width; ++x) {
    columns[4 * width + x] = static_cast<float>((static_cast<double>(x) + 0.5) / static_cast<double>(width));
  }
  for (uint32_t y = 0; y < out->height; ++y) {
    std::fill_n(columns.begin() + static_cast<std::ptrdiff_t>(5 * width), width,
                static_cast<float>((y + 0.5) / out->height));
    require(shd_texture_sample(lookup.texture, lookup.sampler, &places, &texels));
    unsigned char* to = out->pixels.data() + (flip ? out->height - 1 - y : y) * width * pixel;
    for (size_t x = 0; x < width; ++x) {
      for (size_t c = 0; c < 4; ++c, to += format.channel_size) {
        image::store_channel(format.component, static_cast<double>(columns[c * width + x]), to);
      }
    }
  }
}

}  // namespace

shd_format expanded_format(shd_format stored) {
  const image::Component component =
      is_blocks(stored) ? image::block_info(stored).component : image::format_info(stored).component;
  switch (component) {
    case image::Component::kUnorm8: return SHD_FORMAT_RGBA8;
    case image::Component::kSrgb8: return SHD_FORMAT_RGBA8_SRGB;
    case image::Component::kUnorm16: return SHD_FORMAT_RGBA16;
    case image::Component::kFloat16: return SHD_FORMAT_RGBA16F;
    default: return SHD_FORMAT_RGBA32F;
  }
}

shd_texture_desc describe_stored(const shd_texture_file_info& info, uint32_t image_count, const shd_channel* swizzle,
                                 const float* fill) {
  shd_texture_desc desc = shd_texture_desc_default();
  desc.format = info.format;
  desc.width = info.width;
  desc.height = info.height;
  if (info.depth != 0) {
    desc.kind = SHD_TEXTURE_KIND_3D;
    desc.depth = info.depth;
  } else if (info.face_count == 6 && image_count == 6) {
    desc.kind = SHD_TEXTURE_KIND_DIRECTIONS;
    desc.projection = SHD_PROJECTION_CUBE;
  } else {
    desc.layer_count = image_count;
  }
  if (info.flags & SHD_TEXTURE_FILE_PREMULTIPLIED) desc.flags = SHD_TEXTURE_PREMULTIPLIED;
  std::copy(swizzle, swizzle + 4, desc.swizzle);
  std::copy(fill, fill + 4, desc.fill);
  return desc;
}

shd_result load_stored_texture(shd_context* context, const Input& input, LoadRequest request,
                               shd_texture** out_texture) {
  request.options.parts = io::Parts::kTexture;
  request.options.flags &= ~uint32_t{SHD_LOAD_FILE_LEVELS};
  if (request.desc.tables & SHD_TABLE_MIPMAP) request.options.flags |= SHD_LOAD_FILE_LEVELS;
  const io::Bitmap bitmap = load_input(context, input, request);
  require_format(request, bitmap.info.file_format, bitmap.info.file_format == SHD_FILE_FORMAT_DDS ? "DDS" : "KTX2");
  require(make_texture(context, bitmap.layout, bitmap.pixels.data(), list_levels(bitmap), request.desc.tables,
                       out_texture));
  if (!request.desc.info) return SHD_OK;
  shd_texture_file_info info = bitmap.layout.info;
  info.struct_size = shd_texture_file_info_default().struct_size;
  write_desc(info, request.desc.info);
  return SHD_OK;
}

void require_format(const LoadRequest& request, shd_file_format format, const char* name) {
  if (request.options.formats & (static_cast<uint32_t>(format) | SHD_FILE_FORMAT_ANY)) return;
  refuse(SHD_ERROR_UNSUPPORTED, "the content is %s, which load.formats does not allow", name);
}

io::Bitmap load_bitmap(shd_context* context, const Input& input, LoadRequest request) {
  const io::Container container = container_of(input);
  if (container == io::Container::kGrid) {
    refuse(SHD_ERROR_UNSUPPORTED, "the content is OpenVDB, which is no image: load it as a texture");
  }
  if (container == io::Container::kImage) return load_input(context, input, request);
  if (request.options.parts == io::Parts::kSlices) {
    refuse(SHD_ERROR_UNSUPPORTED, "a stack of one KTX2 or DDS file: load it as a texture");
  }
  request.options.parts = io::Parts::kTextureImage;
  io::Bitmap stored = load_input(context, input, request);
  require_format(request, stored.info.file_format, stored.info.file_format == SHD_FILE_FORMAT_DDS ? "DDS" : "KTX2");
  return expand_stored(context, std::move(stored), request);
}

io::Bitmap expand_stored(shd_context* context, io::Bitmap&& stored, const LoadRequest& request) {
  io::TextureLayout layout = stored.layout;
  const bool flip = (request.desc.flags & SHD_LOAD_FLIP_V) != 0;
  io::Bitmap out;
  out.format = expanded_format(layout.info.format);
  out.width = stored.width;
  out.height = stored.height;
  out.info = stored.info;
  const bool data = request.options.encoding == SHD_COLOR_ENCODING_DATA;
  std::strcpy(out.color_space, out.format == SHD_FORMAT_RGBA8_SRGB ? "sRGB" : data ? "data" : "Linear Rec.709");
  const bool plain = std::all_of(layout.swizzle, layout.swizzle + 4, [](shd_channel c) { return c == 0; });
  if (plain && layout.info.format == out.format) {
    out.pixels = std::move(stored.pixels);
    if (flip) io::flip_rows(out.width * io::bitmap_pixel_size(out.format), out.height, 1, out.pixels.data());
    return out;
  }
  const uint64_t pixels = uint64_t{out.width} * out.height;
  out.pixels = io::Buffer(memory_of(context),
                          io::check_bytes(request.options.limits, pixels, io::bitmap_pixel_size(out.format), SIZE_MAX));
  Lookup lookup;
  layout.info.format = io::without_srgb(layout.info.format);
  layout.info.depth = 0;
  layout.info.face_count = 1;
  require(make_texture(context, layout, stored.pixels.data(), {}, 0, &lookup.texture));
  shd_sampler_desc nearest = shd_sampler_desc_default();
  nearest.filter = SHD_FILTER_NEAREST;
  require(shd_sampler_create(context, &nearest, &lookup.sampler));
  expand_rows(lookup, flip, &out);
  return out;
}

}  // namespace shd::extension
