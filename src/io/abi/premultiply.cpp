// SPDX-License-Identifier: MIT
// Textures whose colours are multiplied by alpha.
#include "io/abi/common.h"
#include "io/abi/linear_texels.h"
#include "io/abi/loads.h"
#include "io/bitmap/levels.h"

namespace shd::extension {

void premultiply(const io::Memory& memory, io::Bitmap* bitmap) {
  if (is_opaque(*bitmap)) return;
  const bool has_floats = bitmap->format == SHD_FORMAT_RGBA32F || bitmap->format == SHD_FORMAT_RGBA16F;
  const shd_format format = has_floats ? bitmap->format : SHD_FORMAT_RGBA16F;
  const size_t from_size = io::bitmap_pixel_size(bitmap->format), to_size = io::bitmap_pixel_size(format);
  const auto count = static_cast<size_t>(io::level_pixels(bitmap->width, bitmap->height, bitmap->level_count));
  io::Buffer pixels(memory, count * to_size);
  for (size_t i = 0; i < count; ++i) {
    Rgba color = load_texel(bitmap->format, bitmap->pixels.data() + i * from_size);
    for (size_t c = 0; c < 3; ++c) color.value[c] *= color.value[3];
    store_texel(format, color, 4, pixels.data() + i * to_size);
  }
  bitmap->pixels = std::move(pixels);
  bitmap->format = format;
  bitmap->info.flags |= SHD_BITMAP_PREMULTIPLIED;
}

}  // namespace shd::extension
