// SPDX-License-Identifier: MIT
// Decoding by OpenImageIO.
#include "io/codec/codec.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstring>

#include "core/failure.h"
#include "io/bitmap/channels.h"
#include "io/bitmap/levels.h"
#include "io/bitmap/transfer.h"
#include "io/check/bmp_header.h"
#include "io/check/hdr_header.h"
#include "io/check/sniff.h"
#include "io/check/tiff_pages.h"
#include "io/file/memory_file.h"
#include "io/file/printable.h"
#include "io/oiio/handle.h"
#include "io/oiio/silence.h"

namespace shd::io {

namespace {

constexpr int kMaxChannels = 1024;
// Decoded between two checks of the deadline. Small bands keep the child of a worker and its host busy concurrently.
// The formats with blocks of rows get larger ones, which OpenEXR decodes by several threads.
constexpr size_t kBandBytes = size_t{1} << 18;
constexpr size_t kMaxBandBytes = size_t{1} << 22;

struct Reader {
  shd_file_format format;
  const char* name;  // name of the format in OpenImageIO
};

constexpr Reader kReaders[] = {
    {SHD_FILE_FORMAT_PNG, "png"},   {SHD_FILE_FORMAT_JPEG, "jpeg"}, {SHD_FILE_FORMAT_EXR, "openexr"},
    {SHD_FILE_FORMAT_TIFF, "tiff"}, {SHD_FILE_FORMAT_HDR, "hdr"},   {SHD_FILE_FORMAT_TGA, "targa"},
    {SHD_FILE_FORMAT_BMP, "bmp"},   {SHD_FILE_FORMAT_WEBP, "webp"}, {SHD_FILE_FORMAT_PNM, "pnm"},
    {SHD_FILE_FORMAT_PSD, "psd"},   {SHD_FILE_FORMAT_DPX, "dpx"},   {SHD_FILE_FORMAT_GIF, "gif"},
};

/// State of one decode.
struct Decoder {
  const DecodeInput& file;
  const LoadOptions& options;
  const Deadline& deadline;
  const Sink* sink;
  OIIO::Filesystem::IOMemReader* proxy;
  const MemoryFile& memory_file;
  Quiet<OIIO::ImageInput> input;
  OIIO::ImageSpec spec;      // describes `level` of `part`
  int level = 0;             // mip level of the file
  uint32_t part = 0;         // subimage of the file
  bool one_channel = false;  // the bitmap has one channel, as the file
  ChannelMap map = {};
  int first = 0;  // channels [first, end) of the file are read
  int end = 0;
  OIIO::TypeDesc type;
  OIIO::TypeDesc request;  // `type`, or unknown if the file has no other: then OpenImageIO does not convert
  bool streams = false;    // rows go to the sink as they are read; otherwise they are placed in the bitmap first
  size_t sent = 0;         // bytes of the bitmap that the sink has got, unless `streams`
  Turn turn;               // order of the pixels of the file; the bitmap is upright
};

/// Why OpenImageIO refused the last call.
std::string reason(Decoder& d) {
  return printable(d.memory_file.without_path(d.input.error()));
}

[[noreturn]] void refuse_decode(Decoder& d, const char* action) {
  if (d.level > 0) {
    core::refuse(SHD_ERROR_CORRUPT, "%s: mip level %d: %s: %s", format_name(d.file.format), d.level, action,
                 reason(d).c_str());
  }
  core::refuse(SHD_ERROR_CORRUPT, "%s: %s: %s", format_name(d.file.format), action, reason(d).c_str());
}

/// Checks every field of the spec before it is used, and refuses images that this library does not support.
void check_spec(const Decoder& d) {
  const OIIO::ImageSpec& spec = d.spec;
  const Limits& limits = d.options.limits;
  if (spec.deep) core::refuse(SHD_ERROR_UNSUPPORTED, "deep images are not supported");
  if (spec.depth > 1 || spec.full_depth > 1) core::refuse(SHD_ERROR_UNSUPPORTED, "volumes are not supported");
  if (spec.nchannels < 1) core::refuse(SHD_ERROR_CORRUPT, "%d channels", spec.nchannels);
  if (spec.nchannels > kMaxChannels)
    core::refuse(SHD_ERROR_LIMIT, "%d channels are above %d", spec.nchannels, kMaxChannels);
  const auto side = [](int value) { return static_cast<uint64_t>(value < 0 ? 0 : value); };
  check_extent(limits, "image", side(spec.width), side(spec.height));
  check_extent(limits, "display window", side(spec.full_width), side(spec.full_height));
  if (spec.tile_width < 0 || spec.tile_height < 0 || spec.tile_depth > 1)
    core::refuse(SHD_ERROR_CORRUPT, "bad tile size");
  const uint64_t tile = side(spec.tile_width) * side(spec.tile_height);
  const uint64_t row = std::max(tile, side(spec.width)) * side(spec.nchannels) * 8;
  if (tile > limits.pixels || row > std::max(limits.bytes, uint64_t{1} << 26)) {
    core::refuse(SHD_ERROR_LIMIT, "a tile or row of the file is above load.max_bytes");
  }
}

/// OpenImageIO 2.5 compares the size in some headers with its own limits, which limit_process() sets.
[[noreturn]] void refuse_open(Decoder& d) {
  const std::string why = reason(d);
  if (why.find("\"limits:") != std::string::npos) {
    d.spec = d.input.handle->spec();
    check_spec(d);
    core::refuse(SHD_ERROR_LIMIT, "%s: the image is above load.max_bytes", format_name(d.file.format));
  }
  core::refuse(SHD_ERROR_CORRUPT, "%s: cannot open: %s", format_name(d.file.format), why.c_str());
}

void open_input(Decoder& d) {
  const core::ForkGate::Scope inside(g_image_files);
  silence_libtiff(reinterpret_cast<const void*>(OIIO::openimageio_version));
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  if (d.file.format == SHD_FILE_FORMAT_ANY) {
    d.input.handle = OIIO::ImageInput::open(d.memory_file.path(), &config);
    if (!d.input.handle) {
      core::refuse(SHD_ERROR_UNSUPPORTED, "OpenImageIO has no reader for the file: %s", reason(d).c_str());
    }
    d.spec = d.input.handle->spec();
    return;
  }
  const auto* reader = std::find_if(std::begin(kReaders), std::end(kReaders),
                                    [&](const Reader& row) { return row.format == d.file.format; });
  d.input.handle = OIIO::ImageInput::create(reader->name, false, nullptr, nullptr, "");
  if (!d.input.handle)
    core::refuse(SHD_ERROR_UNSUPPORTED, "%s: OpenImageIO was built without this format", format_name(d.file.format));
  OIIO::Filesystem::IOProxy* proxy = d.proxy;
  config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
  if (!d.input.handle->open(std::string("memory.") + reader->name, d.spec, config)) refuse_open(d);
}

void choose_channels(Decoder& d) {
  const OIIO::ImageSpec& spec = d.spec;
  std::vector<std::string> names(spec.channelnames.begin(), spec.channelnames.end());
  names.resize(static_cast<size_t>(spec.nchannels));
  int alpha = spec.alpha_channel < spec.nchannels ? spec.alpha_channel : -1;
  if (d.file.format == SHD_FILE_FORMAT_TGA && spec.nchannels == 2) {  // OpenImageIO 2.4 calls grey and alpha R and G
    names = {"Y", "A"};
    alpha = 1;
  }
  d.map = map_channels(names, alpha);
  if (d.file.format == SHD_FILE_FORMAT_BMP && bmp_has_unused_byte(d.file.bytes, d.file.size)) d.map.index[3] = -1;
  d.first = spec.nchannels;
  d.type = OIIO::TypeUInt8;
  for (const int index : d.map.index) {
    if (index < 0) continue;
    d.first = std::min(d.first, index);
    d.end = std::max(d.end, index + 1);
    const auto base = static_cast<OIIO::TypeDesc::BASETYPE>(spec.channelformat(index).basetype);
    const bool narrow = base == OIIO::TypeDesc::UINT8;
    const bool words = base == OIIO::TypeDesc::UINT16;
    const bool halves = base == OIIO::TypeDesc::HALF;
    if (narrow) continue;
    const bool first_choice = d.type == OIIO::TypeUInt8;
    if (words && (first_choice || d.type == OIIO::TypeUInt16)) {
      d.type = OIIO::TypeUInt16;
    } else if (halves && (first_choice || d.type == OIIO::TypeHalf)) {
      d.type = OIIO::TypeHalf;
    } else {
      d.type = OIIO::TypeFloat;
    }
  }
}

shd_format bitmap_format(const Decoder& d) {
  if (d.type == OIIO::TypeUInt8) return d.one_channel ? SHD_FORMAT_R8 : SHD_FORMAT_RGBA8;
  if (d.type == OIIO::TypeUInt16) return d.one_channel ? SHD_FORMAT_R16 : SHD_FORMAT_RGBA16;
  if (d.type == OIIO::TypeHalf) return d.one_channel ? SHD_FORMAT_R16F : SHD_FORMAT_RGBA16F;
  return d.one_channel ? SHD_FORMAT_R32F : SHD_FORMAT_RGBA32F;
}

bool fills_window(const OIIO::ImageSpec& spec) {
  return spec.x == spec.full_x && spec.y == spec.full_y && spec.width == spec.full_width &&
         spec.height == spec.full_height;
}

/// Finds out whether rows can be read as the file stores them, and whether they can go to the sink like that: all of
/// the picture from the top, or nothing.
void choose_path(Decoder& d) {
  const OIIO::ImageSpec& spec = d.spec;
  d.request = spec.channelformats.empty() && spec.format == d.type ? OIIO::TypeDesc(OIIO::TypeUnknown) : d.type;
  const bool plain = (d.options.flags & (SHD_LOAD_FLIP_V | SHD_LOAD_PARTIAL)) == 0;
  d.streams = d.sink && plain && fills_window(spec) && d.end - d.first <= 4 && !d.turn.any();
}

Packing packing_of(const Decoder& d) {
  if (d.one_channel) return kSingle;
  if (!d.streams) return kExpanded;
  Packing packing = {d.end - d.first, d.map};
  for (int& index : packing.map.index) index = index < 0 ? -1 : index - d.first;
  return packing;
}

/// Codes of WebP as in the file: OpenImageIO 2 multiplies them by alpha. Colours of alpha 0 are lost.
void divide_by_alpha(unsigned char* rgba, size_t count) {
  for (; count > 0; --count, rgba += 4) {
    const unsigned alpha = rgba[3];
    for (int c = 0; c < 3 && alpha > 0 && alpha < 255; ++c) {
      rgba[c] = static_cast<unsigned char>(std::min((rgba[c] * 255u + alpha / 2) / alpha, 255u));
    }
  }
}

/// Reads rows [y, y_end) of the file into `band`; row 0 is the first row of the data window.
bool read_rows(Decoder& d, int y, int y_end, unsigned char* band) {
  const core::ForkGate::Scope inside(g_image_files);
  const OIIO::ImageSpec& spec = d.spec;
  const int subimage = static_cast<int>(d.part);
  if (spec.tile_width > 0) {
    return d.input.handle->read_tiles(subimage, d.level, spec.x, spec.x + spec.width, spec.y + y, spec.y + y_end,
                                      spec.z, spec.z + 1, d.first, d.end, d.request, band);
  }
  const bool read = d.input.handle->read_scanlines(subimage, d.level, spec.y + y, spec.y + y_end, spec.z, d.first,
                                                   d.end, d.request, band);
  const bool multiplied = d.file.format == SHD_FILE_FORMAT_WEBP && !spec.get_int_attribute("oiio:UnassociatedAlpha", 0);
  if (read && multiplied && d.end - d.first == 4) {
    divide_by_alpha(band, static_cast<size_t>(y_end - y) * static_cast<size_t>(spec.width));
  }
  return read;
}

/// Number of rows read between two checks of the deadline: whole tiles, otherwise a multiple of 64 rows, OpenEXR's
/// usual blocks, or of 16 rows of formats without blocks, if they fit.
int band_height(const Decoder& d) {
  const OIIO::ImageSpec& spec = d.spec;
  const size_t row = static_cast<size_t>(spec.width) * static_cast<size_t>(spec.nchannels) * d.type.size();
  const auto rows_of = [&](size_t bytes) { return static_cast<int>(std::clamp<size_t>(bytes / row, 1, kMaxSide)); };
  const bool tiled = spec.tile_width > 0;
  const bool blocks = tiled || d.file.format == SHD_FILE_FORMAT_EXR || d.file.format == SHD_FILE_FORMAT_TIFF ||
                      d.file.format == SHD_FILE_FORMAT_ANY;
  const int step = tiled ? std::max(spec.tile_height, 1) : blocks ? 64 : 16;
  const int rows = std::max(rows_of(blocks ? kMaxBandBytes : kBandBytes) / step, 1) * step;
  return tiled ? rows : std::min(rows, rows_of(kMaxBandBytes));
}

/// Copies rows of the data window to their position in the display window `out`.
void place_rows(const Decoder& d, const unsigned char* band, int y, int y_end, unsigned char* out) {
  const OIIO::ImageSpec& spec = d.spec;
  const shd_format format = bitmap_format(d);
  const size_t pixel = bitmap_pixel_size(format);
  const auto channels = static_cast<size_t>(d.end - d.first);
  const int64_t shift_x = int64_t{spec.x} - spec.full_x;
  const int64_t shift_y = int64_t{spec.y} - spec.full_y;
  const int64_t begin = std::max<int64_t>(0, -shift_x);
  const int64_t end = std::min<int64_t>(spec.width, int64_t{spec.full_width} - shift_x);
  if (begin >= end) return;
  for (int row = y; row < y_end; ++row) {
    int64_t target = row + shift_y;
    if (target < 0 || target >= spec.full_height) continue;
    if ((d.options.flags & SHD_LOAD_FLIP_V) && !d.turn.any()) target = spec.full_height - 1 - target;
    const unsigned char* in =
        band + (static_cast<size_t>(row - y) * static_cast<size_t>(spec.width) + static_cast<size_t>(begin)) *
                   channels * d.type.size();
    unsigned char* to = out + (static_cast<size_t>(target) * static_cast<size_t>(spec.full_width) +
                               static_cast<size_t>(begin + shift_x)) *
                                  pixel;
    const auto count = static_cast<size_t>(end - begin);
    if (d.one_channel) {
      std::memcpy(to, in, count * pixel);
    } else {
      expand_pixels(d.map, d.first, in, channels, count, format, to);
    }
  }
}

/// Reads the rows of a damaged band one by one, up to the damage.
void salvage_rows(Decoder& d, unsigned char* band, int y, int y_end, unsigned char* out) {
  if (d.spec.tile_width > 0) return;
  for (int row = y; row < y_end && read_rows(d, row, row + 1, band); ++row) place_rows(d, band, row, row + 1, out);
}

/// Pixels of a bitmap before those of the current level and part.
uint64_t pixels_above(const Decoder& d, const Bitmap& out) {
  const uint64_t slice = uint64_t{out.width} * out.height;
  return (d.part - d.options.subimage) * slice + level_pixels(out.width, out.height, static_cast<uint32_t>(d.level));
}

/// Sends the pixels of the current level that are final: those above row y_end of the file, or all of them. Rows that
/// SHD_LOAD_FLIP_V stores from the bottom are sent at the end of their level.
void advance(Decoder& d, const Bitmap& out, int y_end, bool all) {
  if (!d.sink || d.streams || (!all && ((d.options.flags & SHD_LOAD_FLIP_V) || d.turn.any()))) return;
  const OIIO::ImageSpec& spec = d.spec;
  const int64_t rows =
      all ? spec.full_height : std::clamp<int64_t>(y_end + int64_t{spec.y} - spec.full_y, 0, spec.full_height);
  const uint64_t pixels = pixels_above(d, out) + static_cast<uint64_t>(rows) * static_cast<uint64_t>(spec.full_width);
  const size_t end = static_cast<size_t>(pixels) * bitmap_pixel_size(out.format);
  if (end > d.sent) d.sink->take(d.sink->owner, out.pixels.data() + d.sent, end - d.sent);
  d.sent = end;
}

/// Reads the pixels of the current level. Returns false if SHD_LOAD_PARTIAL is set and rows are missing.
bool read_pixels(Decoder& d, const Memory& memory, const Bitmap& out) {
  const OIIO::ImageSpec& spec = d.spec;
  const int step = band_height(d);
  const size_t row = static_cast<size_t>(spec.width) * static_cast<size_t>(d.end - d.first) * d.type.size();
  const Buffer own(memory, d.streams ? 0 : row * static_cast<size_t>(std::min(step, spec.height)));
  const auto above = static_cast<size_t>(pixels_above(d, out));
  unsigned char* const pixels = d.streams ? nullptr : out.pixels.data() + above * bitmap_pixel_size(out.format);
  for (int y = 0; y < spec.height; y += step) {
    d.deadline.check();
    const int y_end = std::min(spec.height, y + step);
    const size_t size = row * static_cast<size_t>(y_end - y);
    unsigned char* const band = d.streams ? d.sink->room(d.sink->owner, size) : own.data();
    std::memset(band, 0, size);  // a decoder may succeed without writing all of it
    if (!read_rows(d, y, y_end, band)) {
      if (!(d.options.flags & SHD_LOAD_PARTIAL)) refuse_decode(d, "damaged");
      salvage_rows(d, band, y, y_end, pixels);
      return false;
    }
    if (d.streams) {
      d.sink->take(d.sink->owner, band, size);
    } else {
      place_rows(d, band, y, y_end, pixels);
      advance(d, out, y_end, false);
    }
  }
  return true;
}

/// Makes a level of the current part the current one. Returns false if there is none.
bool seek_level(Decoder& d, int level) {
  d.level = level;
  {
    const core::ForkGate::Scope inside(g_image_files);
    if (!d.input.handle->seek_subimage(static_cast<int>(d.part), level)) return false;
    d.spec = d.input.handle->spec();
  }
  check_spec(d);
  return true;
}

/// Refuses a level that cannot be one of a texture with this base.
void check_level(const Decoder& d, const OIIO::ImageSpec& base) {
  const auto level = static_cast<uint32_t>(d.level);
  const uint32_t width = level_side(static_cast<uint32_t>(base.width), level);
  const uint32_t height = level_side(static_cast<uint32_t>(base.height), level);
  if (!fills_window(base) || !fills_window(d.spec)) {
    core::refuse(SHD_ERROR_UNSUPPORTED, "mip levels of a file whose data window is not its display window");
  }
  if (static_cast<uint32_t>(d.spec.width) != width || static_cast<uint32_t>(d.spec.height) != height) {
    core::refuse(SHD_ERROR_UNSUPPORTED, "mip level %u has %d x %d pixels, not %u x %u (rounded down)", level,
                 d.spec.width, d.spec.height, width, height);
  }
  bool same = d.spec.nchannels == base.nchannels;
  for (int c = 0; same && c < base.nchannels; ++c) same = d.spec.channelformat(c) == base.channelformat(c);
  if (!same) core::refuse(SHD_ERROR_UNSUPPORTED, "mip level %u has other channels than the base", level);
}

/// Number of levels that the load takes from the file, the base included. The base is current, before and after.
uint32_t count_levels(Decoder& d) {
  const bool may = d.file.format == SHD_FILE_FORMAT_EXR || d.file.format == SHD_FILE_FORMAT_TIFF ||
                   d.file.format == SHD_FILE_FORMAT_ANY;
  if (!may || !(d.options.flags & SHD_LOAD_FILE_LEVELS)) return 1;
  const OIIO::ImageSpec base = d.spec;
  const uint32_t full = full_level_count(static_cast<uint32_t>(base.width), static_cast<uint32_t>(base.height));
  uint32_t count = 1;
  for (; count < full && seek_level(d, static_cast<int>(count)); ++count) check_level(d, base);
  (void)d.input.error();  // the reason why there is no further level
  if (!seek_level(d, 0)) refuse_decode(d, "cannot read");
  return count;
}

bool same_window(const OIIO::ImageSpec& a, const OIIO::ImageSpec& b) {
  return a.width == b.width && a.height == b.height && a.full_width == b.full_width && a.full_height == b.full_height &&
         a.x - a.full_x == b.x - b.full_x && a.y - a.full_y == b.y - b.full_y;
}

/// Refuses a part that cannot be a slice below `base`.
void check_slice(const Decoder& d, const OIIO::ImageSpec& base) {
  if (!same_window(d.spec, base)) {
    core::refuse(SHD_ERROR_CORRUPT, "slice %u has %d x %d pixels, slice 0 has %d x %d", d.part - d.options.subimage,
                 d.spec.width, d.spec.height, base.width, base.height);
  }
  bool same = d.spec.nchannels == base.nchannels && d.spec.tile_width == base.tile_width &&
              d.spec.tile_height == base.tile_height;
  for (int c = 0; same && c < base.nchannels; ++c) {
    same = d.spec.channelformat(c) == base.channelformat(c) && d.spec.channel_name(c) == base.channel_name(c);
  }
  if (!same) {
    core::refuse(SHD_ERROR_CORRUPT, "slice %u has other channels or tiles than slice 0", d.part - d.options.subimage);
  }
}

/// Number of parts that the load takes from the file. The first one is current, before and after.
uint32_t count_slices(Decoder& d) {
  if (d.options.parts != Parts::kSlices) return 1;
  const OIIO::ImageSpec base = d.spec;
  const uint32_t first = d.options.subimage;
  for (d.part = first + 1; d.part - first <= kMaxSide && seek_level(d, 0); ++d.part) check_slice(d, base);
  (void)d.input.error();  // the reason why there is no further part
  const uint32_t count = d.part - first;
  d.part = first;
  if (!seek_level(d, 0)) refuse_decode(d, "cannot read");
  const bool strict = (d.options.flags & SHD_LOAD_PARTIAL) == 0;
  if (strict && d.file.format == SHD_FILE_FORMAT_TIFF && count_tiff_pages(d.file.bytes, d.file.size) != first + count) {
    core::refuse(SHD_ERROR_CORRUPT, "TIFF: page %u cannot be read", first + count);
  }
  return count;
}

/// Reads all slices of `out`. With SHD_LOAD_PARTIAL, rows from the damage of a slice on are left out.
void read_slices(Decoder& d, const Memory& memory, Bitmap* out) {
  for (uint32_t slice = 0; slice < out->depth; ++slice) {
    d.part = d.options.subimage + slice;
    if (slice > 0 && !seek_level(d, 0)) refuse_decode(d, "cannot read");
    if (!read_pixels(d, memory, *out)) out->info.flags |= SHD_BITMAP_PARTIAL;
    advance(d, *out, 0, true);
  }
}

/// Brings pixels in the order of the file into that of the bitmap.
void turn_pixels(const Decoder& d, const Memory& memory, Bitmap* out) {
  const size_t pixel = bitmap_pixel_size(out->format);
  const bool flip = (d.options.flags & SHD_LOAD_FLIP_V) != 0;
  Buffer upright(memory, out->pixels.size());
  for (size_t y = 0; y < out->height; ++y) {
    for (size_t x = 0; x < out->width; ++x) {
      const size_t u = d.turn.mirror_x ? out->width - 1 - x : x;
      const size_t v = d.turn.mirror_y != flip ? out->height - 1 - y : y;
      const size_t from = d.turn.columns ? u * out->height + v : v * out->width + u;
      std::memcpy(upright.data() + (y * out->width + x) * pixel, out->pixels.data() + from * pixel, pixel);
    }
  }
  out->pixels = std::move(upright);
}

/// Reads all levels of `out`. With SHD_LOAD_PARTIAL, levels from the first damaged one on are left out.
void read_levels(Decoder& d, const Memory& memory, Bitmap* out) {
  if (!read_pixels(d, memory, *out)) out->info.flags |= SHD_BITMAP_PARTIAL;
  if (d.turn.any()) turn_pixels(d, memory, out);
  advance(d, *out, 0, true);
  for (uint32_t l = 1; l < out->level_count; ++l) {
    const bool found = seek_level(d, static_cast<int>(l));
    if (!found && !(d.options.flags & SHD_LOAD_PARTIAL)) refuse_decode(d, "damaged");
    if (found && read_pixels(d, memory, *out)) {
      advance(d, *out, 0, true);
      continue;
    }
    out->info.flags |= SHD_BITMAP_PARTIAL;
    out->level_count = l;
  }
}

void describe(const Decoder& d, Bitmap* out) {
  const OIIO::ImageSpec& spec = d.spec;
  const bool integers = d.type == OIIO::TypeUInt8 || d.type == OIIO::TypeUInt16;
  const OIIO::ParamValue* primaries = spec.find_attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8));
  // Integers of PNM have the curve of Rec. 709, floats (PFM) are light. OpenImageIO gives both that curve.
  const bool is_pfm = d.file.format == SHD_FILE_FORMAT_PNM && !integers;
  const std::string said = is_pfm ? std::string() : std::string(spec.get_string_attribute("oiio:ColorSpace"));
  const std::string name = name_color_space(d.options.encoding, said, integers,
                                            primaries ? static_cast<const float*>(primaries->data()) : nullptr);
  std::memcpy(out->color_space, name.c_str(), std::min(name.size(), sizeof out->color_space - 1));
  if (out->format == SHD_FORMAT_RGBA8 && name == "sRGB") out->format = SHD_FORMAT_RGBA8_SRGB;
  if (out->format == SHD_FORMAT_R8 && name == "sRGB") out->format = SHD_FORMAT_R8_SRGB;
  const bool straight = spec.get_int_attribute("oiio:UnassociatedAlpha", 0) != 0;
  const bool always = d.file.format == SHD_FILE_FORMAT_EXR;
  const bool may = always || d.file.format == SHD_FILE_FORMAT_TIFF || d.file.format == SHD_FILE_FORMAT_ANY;
  out->info.file_format = d.file.format;
  out->info.channel_count = static_cast<uint32_t>(spec.nchannels);
  if (d.map.index[3] >= 0 && (always || (may && !straight))) out->info.flags |= SHD_BITMAP_PREMULTIPLIED;
}

Bitmap decode_with(Decoder& d, const Memory& memory) {
  if (d.file.format == SHD_FILE_FORMAT_HDR) d.turn = read_hdr_header(d.file.bytes, d.file.size);
  open_input(d);
  d.input.handle->threads(1);
  begin_pixels(d.input.handle->format_name());
  check_spec(d);
  d.part = d.options.subimage;
  if (d.part > 0) {
    if (!seek_level(d, 0)) {
      core::refuse(SHD_ERROR_NOT_FOUND, "load.subimage: the file has no part %u", d.options.subimage);
    }
  }
  choose_channels(d);
  d.one_channel = d.options.parts != Parts::kImage && d.spec.nchannels == 1;
  Bitmap out;
  out.format = bitmap_format(d);
  out.width = static_cast<uint32_t>(d.spec.full_width);
  out.height = static_cast<uint32_t>(d.spec.full_height);
  if (d.turn.columns) std::swap(out.width, out.height);
  out.level_count = count_levels(d);
  out.depth = count_slices(d);
  if (out.depth > 1) check_volume(d.options.limits, out.width, out.height, out.depth);
  const size_t pixel = bitmap_pixel_size(out.format);
  check_bytes(d.options.limits, static_cast<uint64_t>(d.spec.width) * static_cast<uint64_t>(d.spec.height), pixel,
              d.file.file_size);
  const size_t bytes = check_bytes(d.options.limits, bitmap_pixels(out), pixel, d.file.file_size);
  choose_path(d);
  if (!d.streams) {
    out.pixels = Buffer(memory, bytes);
    if (!memory.zeroed) std::memset(out.pixels.data(), 0, bytes);
  }
  describe(d, &out);
  if (!d.file.complete) out.info.flags |= SHD_BITMAP_PARTIAL;
  if (d.sink) d.sink->begin(d.sink->owner, out, packing_of(d));
  if (d.options.parts == Parts::kSlices && !d.turn.any()) {  // files with turns have one part
    read_slices(d, memory, &out);
  } else {
    read_levels(d, memory, &out);
  }
  return out;
}

}  // namespace

Bitmap decode(const DecodeInput& input, const LoadOptions& options, const Memory& memory, const Deadline& deadline,
              const Sink* sink) {
  g_image_files.attach();
  const MemoryFile file(input.format == SHD_FILE_FORMAT_ANY, input.bytes, input.size);
  try {
    OIIO::Filesystem::IOMemReader proxy(const_cast<unsigned char*>(input.bytes), input.size);
    Decoder decoder{input, options, deadline, sink, &proxy, file, {}, {}, 0, 0, false, {}, 0, 0, {}, {}, false, 0, {}};
    return decode_with(decoder, memory);
  } catch (const core::Failure&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    core::refuse(SHD_ERROR_CORRUPT, "%s: %s", format_name(input.format),
                 printable(file.without_path(error.what())).c_str());
  }
}

void prepare_process() {
  OIIO::attribute("threads", 1);
  OIIO::attribute("exr_threads", -1);
  OIIO::attribute("limits:channels", kMaxChannels);
  silence_libtiff(reinterpret_cast<const void*>(OIIO::openimageio_version));
  for (const Reader& reader : kReaders) {
    const Quiet<OIIO::ImageInput> input{OIIO::ImageInput::create(reader.name, false, nullptr, nullptr, "")};
  }
}

void limit_process(uint64_t max_bytes) {
  const uint64_t megabytes = (max_bytes >> 20) + 1;
  OIIO::attribute("limits:imagesize_MB", static_cast<int>(std::min<uint64_t>(megabytes, 32768)));
}

}  // namespace shd::io
