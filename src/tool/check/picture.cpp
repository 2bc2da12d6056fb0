// SPDX-License-Identifier: MIT
#include "tool/check/picture.h"

#include <algorithm>
#include <cstring>

#ifdef SHD_CHECK_WITH_IO
#include <shd/io.h>
#endif

#include "command/failure.h"
#include "image/half.h"
#include "tool/check/npy.h"
#include "tool/check/table.h"

namespace {

/// Formats of each Channel with 1 to 4 channels.
constexpr shd_format kFormats[5][4] = {
    {SHD_FORMAT_R8, SHD_FORMAT_RG8, SHD_FORMAT_RGB8, SHD_FORMAT_RGBA8},
    {SHD_FORMAT_R8_SRGB, SHD_FORMAT_RG8_SRGB, SHD_FORMAT_RGB8_SRGB, SHD_FORMAT_RGBA8_SRGB},
    {SHD_FORMAT_R16, SHD_FORMAT_RG16, SHD_FORMAT_RGB16, SHD_FORMAT_RGBA16},
    {SHD_FORMAT_R16F, SHD_FORMAT_RG16F, SHD_FORMAT_RGB16F, SHD_FORMAT_RGBA16F},
    {SHD_FORMAT_R32F, SHD_FORMAT_RG32F, SHD_FORMAT_RGB32F, SHD_FORMAT_RGBA32F}};

/// The format of a type with a number of channels.
shd_format format_of(const std::string& path, const NpyField& type, size_t channels, bool srgb) {
  if (channels < 1 || channels > 4) throw Failure(kExitInput, path + ": channels are not 1..4");
  if (type.size == 8 || !type.name.empty()) throw Failure(kExitInput, path + ": texels are not |u1, <u2, <f2 or <f4");
  const Channel codes = srgb ? Channel::kSrgb : Channel::kCode;
  if (type.kind == 'u') return format_with(type.size == 1 ? codes : Channel::kU16, channels);
  return format_with(type.size == 2 ? Channel::kHalf : Channel::kFloat, channels);
}

Picture npy_picture(const std::string& path, const std::string& bytes, bool srgb) {
  const Npy array = parse_npy(path, bytes);
  std::vector<size_t> shape = array.shape;
  if (shape.size() == 2) shape.push_back(1);
  if (shape.size() == 3) shape.insert(shape.begin(), 1);
  constexpr size_t kMost = 65536;
  const bool fits =
      shape.size() == 4 && std::all_of(shape.begin(), shape.end(), [](size_t n) { return n > 0 && n <= kMost; });
  if (!fits) throw Failure(kExitInput, path + ": the shape is not [height][width][channels] of 1..65536");
  Picture out = {format_of(path, array.fields.front(), shape[3], srgb),
                 static_cast<uint32_t>(shape[2]),
                 static_cast<uint32_t>(shape[1]),
                 static_cast<uint32_t>(shape[0]),
                 {}};
  const auto* const first = reinterpret_cast<const uint8_t*>(array.data);
  out.texels.assign(first, first + array.count * array.element_size);
  return out;
}

#ifdef SHD_CHECK_WITH_IO
Picture file_picture(shd_context* context, const std::string& path, bool srgb) {
  shd_load_desc desc = shd_load_desc_default();
  desc.encoding = srgb ? SHD_COLOR_ENCODING_SRGB : SHD_COLOR_ENCODING_DATA;
  shd_bitmap* bitmap = nullptr;
  check(shd_bitmap_load(context, path.c_str(), &desc, &bitmap), path, kExitInput);
  shd_image image = shd_image_default();
  check(shd_bitmap_get_image(bitmap, &image), path, kExitInput);
  Picture out = {image.format, image.width, image.height, 1, {}};
  const size_t row = image.width * shd_format_size(image.format), stride = image.row_stride ? image.row_stride : row;
  for (uint32_t y = 0; y < image.height; ++y) {
    const auto* const from = static_cast<const uint8_t*>(image.pixels) + y * stride;
    out.texels.insert(out.texels.end(), from, from + row);
  }
  shd_bitmap_release(bitmap);
  return out;
}
#else
Picture file_picture(shd_context*, const std::string& path, bool) {
  throw Failure(kExitInput, path + ": not a .npy array; this shd-check reads no image files");
}
#endif

/// Row and column of kFormats; a row of 5 for other formats.
struct Kind {
  int row;
  size_t channels;
};

Kind kind_of(shd_format format) {
  for (int row = 0; row < 5; ++row) {
    for (size_t c = 0; c < 4; ++c) {
      if (kFormats[row][c] == format) return {row, c + 1};
    }
  }
  return {5, 4};
}

}  // namespace

shd_format format_with(Channel type, size_t channels) {
  return kFormats[static_cast<int>(type)][channels - 1];
}

Picture read_picture(shd_context* context, const std::string& path, bool srgb) {
  const std::string bytes = read_file(path);
  if (bytes.compare(0, 6, "\x93NUMPY") == 0) return npy_picture(path, bytes, srgb);
  return file_picture(context, path, srgb);
}

Pictures read_pictures(shd_context* context, const Options& options) {
  Pictures out = {read_picture(context, options.texture, options.srgb), {}};
  for (const std::string& path : options.levels) {
    out.levels.push_back(read_picture(context, path, options.srgb));
    if (out.levels.back().layers != out.base.layers) throw Failure(kExitInput, path + ": another number of layers");
  }
  return out;
}

size_t channels_of(const Picture& picture) {
  return kind_of(picture.format).channels;
}

bool has_codes(const Picture& picture) {
  return kind_of(picture.format).row <= 1;
}

bool is_unorm(const Picture& picture) {
  return kind_of(picture.format).row <= 2;
}

std::vector<std::vector<float>> float_columns(const std::string& path, const Picture& picture) {
  const auto [row, channels] = kind_of(picture.format);
  if (row < 3 || row > 4) throw Failure(kExitInput, path + ": results are not floats");
  const size_t size = row == 3 ? 2 : 4;
  std::vector<std::vector<float>> columns(channels);
  for (size_t i = 0; i < picture.texels.size() / size; ++i) {
    float value;
    uint16_t half;
    std::memcpy(&value, picture.texels.data() + i * size, size == 4 ? 4 : 2);
    std::memcpy(&half, picture.texels.data() + i * size, sizeof half);
    columns[i % channels].push_back(size == 4 ? value : shd::image::half_to_float(half));
  }
  return columns;
}
