// SPDX-License-Identifier: MIT
// Decoding without OpenImageIO: pictures of one part, which have no mip levels.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

#include "core/failure.h"
#include "io/bitmap/channels.h"
#include "io/bitmap/transfer.h"
#include "io/check/sniff.h"
#include "io/small/rows.h"

namespace shd::io {

namespace {

constexpr size_t kBandBytes = size_t{1} << 18;  // decoded between two checks of the deadline

struct Format {
  shd_file_format format;
  std::unique_ptr<PictureRows> (*open)(const DecodeInput& input);
};

constexpr Format kFormats[] = {
    {SHD_FILE_FORMAT_PNG, open_png},
    {SHD_FILE_FORMAT_JPEG, open_jpeg},
    {SHD_FILE_FORMAT_HDR, open_hdr},
};

std::unique_ptr<PictureRows> open_rows(const DecodeInput& input) {
  for (const Format& row : kFormats) {
    if (row.format == input.format) return row.open(input);
  }
  core::refuse(SHD_ERROR_UNSUPPORTED,
               "the content is %s; this build reads PNG, JPEG and Radiance HDR, because it has no OpenImageIO",
               input.format == SHD_FILE_FORMAT_ANY ? "of no known image format" : format_name(input.format));
}

/// State of one decode.
struct Decoder {
  const LoadOptions& options;
  const Deadline& deadline;
  const Sink* sink;
  PictureRows& rows;
  size_t row_size;  // size of a row of the file [bytes]
  ChannelMap map;
  bool streams;  // rows go to the sink as they are read; otherwise they are placed in the bitmap first
};

size_t sample_size(Sample sample) {
  return sample == Sample::kU8 ? 1 : sample == Sample::kU16 ? 2 : 4;
}

shd_format bitmap_format(Sample sample, bool one_channel) {
  if (sample == Sample::kU8) return one_channel ? SHD_FORMAT_R8 : SHD_FORMAT_RGBA8;
  if (sample == Sample::kU16) return one_channel ? SHD_FORMAT_R16 : SHD_FORMAT_RGBA16;
  return one_channel ? SHD_FORMAT_R32F : SHD_FORMAT_RGBA32F;
}

ChannelMap channel_map(const Picture& picture) {
  const int colors = picture.channels - (picture.alpha ? 1 : 0), alpha = picture.alpha ? colors : -1;
  if (colors == 1) return {{0, 0, 0, alpha}};
  return {{0, 1, colors == 2 ? -1 : 2, alpha}};
}

void describe(const DecodeInput& input, const LoadOptions& options, const Picture& picture, Bitmap* out) {
  const bool one_channel = options.parts != Parts::kImage && picture.channels == 1;
  out->format = bitmap_format(picture.sample, one_channel);
  out->width = picture.turn.columns ? picture.height : picture.width;
  out->height = picture.turn.columns ? picture.width : picture.height;
  out->info.file_format = input.format;
  out->info.channel_count = static_cast<uint32_t>(picture.channels);
  if (!input.complete) out->info.flags |= SHD_BITMAP_PARTIAL;
  const std::string name =
      name_color_space(options.encoding, picture.color_space, picture.sample != Sample::kFloat, nullptr);
  std::memcpy(out->color_space, name.c_str(), std::min(name.size(), sizeof out->color_space - 1));
  if (name != "sRGB" || picture.sample != Sample::kU8) return;
  out->format = one_channel ? SHD_FORMAT_R8_SRGB : SHD_FORMAT_RGBA8_SRGB;
}

/// Where pixel x of row y of the file is in the bitmap.
size_t place_of(const Decoder& d, const Bitmap& out, size_t x, size_t y) {
  const Turn& turn = d.rows.picture.turn;
  if (turn.columns) std::swap(x, y);
  if (turn.mirror_x) x = out.width - 1 - x;
  if (turn.mirror_y != ((d.options.flags & SHD_LOAD_FLIP_V) != 0)) y = out.height - 1 - y;
  return y * out.width + x;
}

void place_row(const Decoder& d, const unsigned char* row, size_t y, const Bitmap& out) {
  const Picture& picture = d.rows.picture;
  const size_t pixel = bitmap_pixel_size(out.format), channels = static_cast<size_t>(picture.channels);
  const auto expand = [&](const unsigned char* in, size_t count, unsigned char* to) {
    if (has_one_channel(out.format)) {
      std::memcpy(to, in, count * pixel);
    } else {
      expand_pixels(d.map, 0, in, channels, count, out.format, to);
    }
  };
  if (!picture.turn.columns && !picture.turn.mirror_x) {
    expand(row, picture.width, out.pixels.data() + place_of(d, out, 0, y) * pixel);
    return;
  }
  const size_t step = channels * sample_size(picture.sample);
  for (size_t x = 0; x < picture.width; ++x) {
    expand(row + x * step, 1, out.pixels.data() + place_of(d, out, x, y) * pixel);
  }
}

/// Reads rows [y, end) and gives them to the sink or the bitmap. Returns false if SHD_LOAD_PARTIAL is set and rows are
/// missing.
bool read_band(const Decoder& d, const Memory& memory, uint32_t y, uint32_t end, const Bitmap& out) {
  const size_t size = d.row_size * (end - y);
  const Buffer own(memory, d.streams ? 0 : d.row_size);
  unsigned char* row = d.streams ? d.sink->room(d.sink->owner, size) : own.data();
  unsigned char* const band = row;
  for (; y < end; ++y) {
    try {
      d.rows.read(row);
    } catch (const core::Failure& failure) {
      if (!(d.options.flags & SHD_LOAD_PARTIAL) || failure.code != SHD_ERROR_CORRUPT) throw;
      return false;
    }
    if (d.streams) {
      row += d.row_size;
    } else {
      place_row(d, row, y, out);
    }
  }
  if (d.streams) d.sink->take(d.sink->owner, band, size);
  return true;
}

void read_rows(const Decoder& d, const Memory& memory, Bitmap* out) {
  const uint32_t height = d.rows.picture.height;
  const auto step = static_cast<uint32_t>(std::clamp<size_t>(kBandBytes / d.row_size, 1, 1024));
  for (uint32_t y = 0; y < height; y += step) {
    d.deadline.check();
    if (read_band(d, memory, y, std::min(height, y + step), *out)) continue;
    out->info.flags |= SHD_BITMAP_PARTIAL;
    break;
  }
  if (d.sink && !d.streams) d.sink->take(d.sink->owner, out->pixels.data(), out->pixels.size());
}

}  // namespace

std::string gamma_space(double gamma) {
  const double exponent = std::round(100.0 / gamma) / 100;
  if (exponent == 1) return "Linear";
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", exponent);
  for (char* c = text; *c; ++c) {
    if (*c == ',') *c = '.';  // the host's locale may have a comma
  }
  return std::string("Gamma") + text;
}

Bitmap decode(const DecodeInput& input, const LoadOptions& options, const Memory& memory, const Deadline& deadline,
              const Sink* sink) {
  const std::unique_ptr<PictureRows> rows = open_rows(input);
  const Picture& picture = rows->picture;
  check_extent(options.limits, "image", picture.width, picture.height);
  if (options.subimage > 0) {
    core::refuse(SHD_ERROR_NOT_FOUND, "load.subimage: the file has no part %u", options.subimage);
  }
  Bitmap out;
  describe(input, options, picture, &out);
  const bool one_channel = has_one_channel(out.format);
  const bool plain = (options.flags & (SHD_LOAD_FLIP_V | SHD_LOAD_PARTIAL)) == 0 && !picture.turn.any();
  const Decoder decoder = {options,
                           deadline,
                           sink,
                           *rows,
                           size_t{picture.width} * static_cast<size_t>(picture.channels) * sample_size(picture.sample),
                           channel_map(picture),
                           sink && plain};
  const size_t bytes =
      check_bytes(options.limits, uint64_t{out.width} * out.height, bitmap_pixel_size(out.format), input.file_size);
  if (!decoder.streams) {
    out.pixels = Buffer(memory, bytes);
    if (!memory.zeroed) std::memset(out.pixels.data(), 0, bytes);
  }
  const Packing packing = one_channel ? kSingle : !decoder.streams ? kExpanded : Packing{picture.channels, decoder.map};
  if (sink) sink->begin(sink->owner, out, packing);
  read_rows(decoder, memory, &out);
  return out;
}

void prepare_process() {}

void limit_process(uint64_t) {}

}  // namespace shd::io
