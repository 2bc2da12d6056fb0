// SPDX-License-Identifier: MIT
// Images as textures.
#include <cstring>

#include "io/abi/common.h"
#include "io/abi/loads.h"
#include "io/bitmap/levels.h"
#include "io/bitmap/transfer.h"

namespace shd::extension {

namespace {

constexpr uint32_t kMaxLevels = 16;  // below a base of io::kMaxSide

shd_result make_texture(shd_context* context, const io::Bitmap& bitmap, uint32_t tables, shd_texture** out_texture) {
  shd_texture_desc texture = shd_texture_desc_default();
  texture.format = bitmap.format;
  texture.width = bitmap.width;
  texture.height = bitmap.height;
  texture.texels = bitmap.pixels.data();
  texture.tables = tables;
  if (bitmap.info.flags & SHD_BITMAP_PREMULTIPLIED) texture.flags |= SHD_TEXTURE_PREMULTIPLIED;
  shd_image levels[kMaxLevels];
  texture.level_count = bitmap.level_count - 1;
  texture.level_images = bitmap.level_count > 1 ? levels : nullptr;
  const size_t pixel = shd_format_size(texture.format);
  const auto* next = static_cast<const unsigned char*>(texture.texels);
  for (uint32_t l = 1; l < bitmap.level_count; ++l) {
    next += pixel * io::level_side(bitmap.width, l - 1) * io::level_side(bitmap.height, l - 1);
    shd_image& level = levels[l - 1] = shd_image_default();
    level.format = texture.format;
    level.width = io::level_side(bitmap.width, l);
    level.height = io::level_side(bitmap.height, l);
    level.pixels = const_cast<unsigned char*>(next);
  }
  return shd_texture_create(context, &texture, out_texture);
}

}  // namespace

void make_linear(const io::Memory& memory, io::Bitmap* bitmap) {
  const io::Transfer transfer = io::transfer_of(bitmap->color_space);
  if (transfer.curve == io::Curve::kUnknown) {
    refuse(SHD_ERROR_UNSUPPORTED, "colour space \"%s\" of the file is not known: set load.color_space",
           bitmap->color_space);
  }
  const bool as_stored = transfer.curve == io::Curve::kLinear && bitmap->format != SHD_FORMAT_RGBA16;
  if (as_stored || bitmap->format == SHD_FORMAT_RGBA8_SRGB) return;
  const auto pixels = static_cast<size_t>(io::level_pixels(bitmap->width, bitmap->height, bitmap->level_count));
  io::Buffer texels(memory, pixels * 16);
  io::linearise(transfer, bitmap->format, bitmap->pixels.data(), pixels, reinterpret_cast<float*>(texels.data()));
  bitmap->pixels = std::move(texels);
  bitmap->format = SHD_FORMAT_RGBA32F;
  std::memset(bitmap->color_space, 0, sizeof bitmap->color_space);
  std::strcpy(bitmap->color_space, "Linear Rec.709");
}

shd_result load_image_texture(shd_context* context, const Input& input, const LoadRequest& request,
                              shd_texture** out_texture) {
  if ((request.desc.flags & SHD_LOAD_FILE_LEVELS) && !(request.desc.tables & SHD_TABLE_MIPMAP)) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "load.flags: SHD_LOAD_FILE_LEVELS, but load.tables 0x%x has no SHD_TABLE_MIPMAP",
           request.desc.tables);
  }
  io::Bitmap bitmap = load_input(context, input, request);
  make_linear(memory_of(context), &bitmap);
  const bool straight = !(bitmap.info.flags & SHD_BITMAP_PREMULTIPLIED);
  if (straight && request.desc.flags & SHD_LOAD_PREMULTIPLY) premultiply(memory_of(context), &bitmap);
  if (straight && request.desc.flags & SHD_LOAD_ALPHA_WEIGHTED && bitmap.level_count == 1) {
    weight_by_alpha(context, (request.desc.tables & SHD_TABLE_MIPMAP) != 0, &bitmap);
  }
  return make_texture(context, bitmap, request.desc.tables, out_texture);
}

}  // namespace shd::extension
