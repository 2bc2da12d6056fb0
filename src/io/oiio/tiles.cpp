// SPDX-License-Identifier: MIT
// Tiles of files by OpenImageIO. A reader of OpenImageIO is used by one thread between take() and give(); several exist
// for a file that several threads read.
#include "io/codec/tiles.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>

#include "core/failure.h"
#include "io/bitmap/levels.h"
#include "io/bitmap/transfer.h"
#include "io/file/printable.h"
#include "io/file/read_file.h"
#include "io/oiio/handle.h"
#include "io/oiio/silence.h"

namespace shd::io {

namespace {

constexpr int kMaxTiledSide = 1 << 20;
constexpr uint64_t kMaxTileBytes = uint64_t{1} << 26;

struct Component {
  OIIO::TypeDesc::BASETYPE type;
  shd_format formats[4];  // for one to four channels
  unsigned char one[4];   // the number 1, little-endian
};
constexpr Component kComponents[] = {
    {OIIO::TypeDesc::UINT8, {SHD_FORMAT_R8, SHD_FORMAT_RG8, SHD_FORMAT_RGBA8, SHD_FORMAT_RGBA8}, {255}},
    {OIIO::TypeDesc::UINT16, {SHD_FORMAT_R16, SHD_FORMAT_RG16, SHD_FORMAT_RGBA16, SHD_FORMAT_RGBA16}, {255, 255}},
    {OIIO::TypeDesc::HALF, {SHD_FORMAT_R16F, SHD_FORMAT_RG16F, SHD_FORMAT_RGBA16F, SHD_FORMAT_RGBA16F}, {0, 0x3c}},
    {OIIO::TypeDesc::FLOAT,
     {SHD_FORMAT_R32F, SHD_FORMAT_RG32F, SHD_FORMAT_RGBA32F, SHD_FORMAT_RGBA32F},
     {0, 0, 0x80, 0x3f}}};
constexpr shd_format kSrgb[] = {SHD_FORMAT_R8_SRGB, SHD_FORMAT_RG8_SRGB, SHD_FORMAT_RGBA8_SRGB, SHD_FORMAT_RGBA8_SRGB};

}  // namespace

struct CloseStream {
  void operator()(std::FILE* stream) const { std::fclose(stream); }
};

/// An open file, at one of its levels.
struct TileReader {
  TileReader(size_t number, FileDescriptor&& opened) : file(number), stream(::fdopen(opened.fd, "rb")) {
    if (!stream) throw std::bad_alloc();
    opened.fd = -1;
  }

  size_t file;
  int level = 0;
  std::unique_ptr<std::FILE, CloseStream> stream;
  OIIO::Filesystem::IOFile proxy{stream.get(), OIIO::Filesystem::IOProxy::Read};
  Quiet<OIIO::ImageInput> input;
};

class TiledSet {
 public:
  explicit TiledSet(const TiledPaths& paths) : paths_(paths.paths), max_readers_(paths.max_readers) {
    g_image_files.attach();
    mutex_.attach();
    silence_libtiff(reinterpret_cast<const void*>(OIIO::openimageio_version));
    for (size_t file = 0; file < paths_.size(); ++file) open_file(file, paths.encoding);
  }

  const TiledInfo& info() const { return info_; }

  void read(const TiledRead& read) {
    std::unique_ptr<TileReader> reader = take(read.file, static_cast<int>(read.level));
    try {
      read_with(*reader, read);
    } catch (...) {
      reader.reset();  // its state is not known after an error
      throw;
    }
    give(std::move(reader));
  }

 private:
  std::string name(size_t file) const { return "\"" + printable(paths_[file]) + "\""; }

  std::unique_ptr<TileReader> open(size_t file) const {
    auto reader = std::make_unique<TileReader>(file, io::open_file(paths_[file].c_str()).file);
    const core::ForkGate::Scope inside(g_image_files);
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);  // numbers as they are stored
    reader->input.handle = OIIO::ImageInput::open(paths_[file], &config, &reader->proxy);
    if (!reader->input.handle) {
      core::refuse(SHD_ERROR_CORRUPT, "%s: cannot open: %s", name(file).c_str(),
                   printable(reader->input.error()).c_str());
    }
    reader->input.handle->threads(1);
    begin_pixels(reader->input.handle->format_name());
    return reader;
  }

  void open_file(size_t file, shd_color_encoding encoding) {
    std::unique_ptr<TileReader> reader = open(file);
    const core::ForkGate::Scope inside(g_image_files);
    const OIIO::ImageSpec base = reader->input.handle->spec();
    check_base(file, base);
    TiledInfo info;
    info.width = static_cast<uint32_t>(base.width);
    info.height = static_cast<uint32_t>(base.height);
    info.tile_width = static_cast<uint32_t>(base.tile_width);
    info.tile_height = static_cast<uint32_t>(base.tile_height);
    info.format = format_of(file, base, encoding);
    info.premultiplied = base.alpha_channel == 3 && base.get_int_attribute("oiio:UnassociatedAlpha", 0) == 0;
    const uint32_t full = full_level_count(info.width, info.height);
    for (info.level_count = 1; info.level_count < full; ++info.level_count) {
      if (!reader->input.handle->seek_subimage(0, static_cast<int>(info.level_count))) break;
      check_level(file, base, reader->input.handle->spec(), info.level_count);
      reader->level = static_cast<int>(info.level_count);
    }
    (void)reader->input.error();  // the reason why there is no further level
    if (info.level_count == 1 && (info.width > info.tile_width || info.height > info.tile_height)) {
      core::refuse(SHD_ERROR_UNSUPPORTED, "%s: no mip levels: convert it with shd-maketx", name(file).c_str());
    }
    const bool same = info.width == info_.width && info.height == info_.height && info.format == info_.format &&
                      info.level_count == info_.level_count && base.nchannels == channels_ &&
                      info.premultiplied == info_.premultiplied;
    if (file > 0 && !same) {
      core::refuse(SHD_ERROR_UNSUPPORTED, "%s: its size, channels, alpha or levels differ from those of %s",
                   name(file).c_str(), name(0).c_str());
    }
    if (file == 0) {
      info_ = info;
      channels_ = base.nchannels;
      type_ = OIIO::TypeDesc(static_cast<OIIO::TypeDesc::BASETYPE>(base.format.basetype));
    }
    if (info.level_count == full) give(std::move(reader));  // the state is not known after a level that is not there
  }

  void check_base(size_t file, const OIIO::ImageSpec& spec) const {
    const std::string path = name(file);
    if (spec.deep || spec.depth > 1) core::refuse(SHD_ERROR_UNSUPPORTED, "%s: deep images and volumes", path.c_str());
    if (spec.tile_width < 1 || spec.tile_height < 1) {
      core::refuse(SHD_ERROR_UNSUPPORTED, "%s: not tiled: convert it with shd-maketx", path.c_str());
    }
    if (spec.width < 1 || spec.height < 1 || spec.width > kMaxTiledSide || spec.height > kMaxTiledSide) {
      core::refuse(SHD_ERROR_LIMIT, "%s: %d x %d texels are not in 1..%d", path.c_str(), spec.width, spec.height,
                   kMaxTiledSide);
    }
    if (spec.nchannels < 1 || spec.nchannels > 4) {
      core::refuse(SHD_ERROR_UNSUPPORTED, "%s: %d channels are not in 1..4", path.c_str(), spec.nchannels);
    }
    const auto area = static_cast<uint64_t>(spec.tile_width) * static_cast<uint64_t>(spec.tile_height);
    if (spec.tile_depth > 1 || area > kMaxTileBytes || area * spec.pixel_bytes() > kMaxTileBytes) {
      core::refuse(SHD_ERROR_LIMIT, "%s: tiles of %d x %d texels are above 2^26 bytes", path.c_str(), spec.tile_width,
                   spec.tile_height);
    }
    if (spec.x != spec.full_x || spec.y != spec.full_y || spec.width != spec.full_width ||
        spec.height != spec.full_height) {
      core::refuse(SHD_ERROR_UNSUPPORTED, "%s: the data window is not the display window", path.c_str());
    }
    for (int c = 0; c < spec.nchannels; ++c) {
      if (spec.channelformat(c) != spec.format) {
        core::refuse(SHD_ERROR_UNSUPPORTED, "%s: channels of different types", path.c_str());
      }
    }
  }

  void check_level(size_t file, const OIIO::ImageSpec& base, const OIIO::ImageSpec& spec, uint32_t level) const {
    const uint32_t width = level_side(static_cast<uint32_t>(base.width), level);
    const uint32_t height = level_side(static_cast<uint32_t>(base.height), level);
    if (static_cast<uint32_t>(spec.width) != width || static_cast<uint32_t>(spec.height) != height) {
      core::refuse(SHD_ERROR_UNSUPPORTED, "%s: mip level %u has %d x %d texels, not %u x %u (rounded down)",
                   name(file).c_str(), level, spec.width, spec.height, width, height);
    }
    const auto area =
        static_cast<uint64_t>(std::max(spec.tile_width, 0)) * static_cast<uint64_t>(std::max(spec.tile_height, 0));
    if (area == 0 || spec.tile_depth > 1 || area * spec.pixel_bytes() > kMaxTileBytes) {
      core::refuse(SHD_ERROR_UNSUPPORTED, "%s: mip level %u has tiles of %d x %d texels", name(file).c_str(), level,
                   spec.tile_width, spec.tile_height);
    }
    if (spec.nchannels != base.nchannels || spec.format != base.format || spec.x != 0 || spec.y != 0) {
      core::refuse(SHD_ERROR_UNSUPPORTED, "%s: mip level %u has other channels or another place than the base",
                   name(file).c_str(), level);
    }
  }

  shd_format format_of(size_t file, const OIIO::ImageSpec& spec, shd_color_encoding encoding) const {
    const auto* found = std::find_if(std::begin(kComponents), std::end(kComponents),
                                     [&](const Component& row) { return spec.format == row.type; });
    if (found == std::end(kComponents)) {
      core::refuse(SHD_ERROR_UNSUPPORTED, "%s: numbers of type %s", name(file).c_str(), spec.format.c_str());
    }
    const bool integers = spec.format == OIIO::TypeUInt8 || spec.format == OIIO::TypeUInt16;
    const std::string space =
        name_color_space(encoding, spec.get_string_attribute("oiio:ColorSpace"), integers, nullptr);
    const Curve curve = transfer_of(space).curve;
    if (curve == Curve::kLinear) return found->formats[spec.nchannels - 1];
    if (curve == Curve::kSrgb && spec.format == OIIO::TypeUInt8) return kSrgb[spec.nchannels - 1];
    core::refuse(SHD_ERROR_UNSUPPORTED, "%s: colour space \"%s\" of numbers of type %s: set tile_file.color_space",
                 name(file).c_str(), printable(space).c_str(), spec.format.c_str());
  }

  /// A reader of a file, at `level` if there is one.
  std::unique_ptr<TileReader> take(size_t file, int level) {
    std::unique_ptr<TileReader> reader;
    std::vector<std::unique_ptr<TileReader>> of_parent;  // closed after the lock
    {
      const std::lock_guard<core::ForkMutex> lock(mutex_);
      if (generation_ != core::fork_generation()) {  // the readers share their places in the files with the parent
        generation_ = core::fork_generation();
        of_parent.swap(idle_);
      }
      auto found = idle_.end();
      for (auto it = idle_.begin(); it != idle_.end(); ++it) {
        if ((*it)->file != file) continue;
        found = it;
        if ((*it)->level == level) break;
      }
      if (found != idle_.end()) {
        reader = std::move(*found);
        idle_.erase(found);
      }
    }
    return reader ? std::move(reader) : open(file);
  }

  /// Keeps a reader, and closes the one that was not used for the longest time if there are too many.
  void give(std::unique_ptr<TileReader> reader) {
    std::unique_ptr<TileReader> oldest;
    const std::lock_guard<core::ForkMutex> lock(mutex_);
    idle_.push_back(std::move(reader));
    if (idle_.size() <= max_readers_) return;
    oldest = std::move(idle_.front());
    idle_.erase(idle_.begin());
  }

  [[noreturn]] void refuse_read(TileReader& reader, const TiledRead& read) const {
    core::refuse(SHD_ERROR_CORRUPT, "%s: mip level %u, columns %u to %u, rows %u to %u: %s", name(read.file).c_str(),
                 read.level, read.x, read.x + read.width - 1, read.y, read.y + read.height - 1,
                 printable(reader.input.error()).c_str());
  }

  void read_with(TileReader& reader, const TiledRead& read) const {
    const core::ForkGate::Scope inside(g_image_files);
    OIIO::ImageInput& input = *reader.input.handle;
    const int level = static_cast<int>(read.level);
    if (!input.seek_subimage(0, level)) refuse_read(reader, read);
    reader.level = level;
    const OIIO::ImageSpec& spec = input.spec();
    const bool same = spec.width == static_cast<int>(level_side(info_.width, read.level)) &&
                      spec.height == static_cast<int>(level_side(info_.height, read.level)) &&
                      spec.nchannels == channels_ && spec.tile_width > 0 && spec.tile_height > 0;
    if (!same) {
      core::refuse(SHD_ERROR_CORRUPT, "%s: mip level %u has changed since the file was opened", name(read.file).c_str(),
                   read.level);
    }
    const auto down = [](uint32_t value, int tile) { return static_cast<int>(value) / tile * tile; };
    const auto up = [](uint32_t value, int tile, int size) {
      return std::min((static_cast<int>(value) + tile - 1) / tile * tile, size);
    };
    const int x = down(read.x, spec.tile_width), y = down(read.y, spec.tile_height);
    const int x_end = up(read.x + read.width, spec.tile_width, spec.width);
    const int y_end = up(read.y + read.height, spec.tile_height, spec.height);
    const size_t pixel = static_cast<size_t>(channels_) * type_.size();
    const bool whole = x == static_cast<int>(read.x) && x_end == static_cast<int>(read.x + read.width) &&
                       y == static_cast<int>(read.y) && y_end == static_cast<int>(read.y + read.height);
    if (whole && channels_ != 3) {
      read_pixels(reader, read, {x, x_end, y, y_end}, read.texels, read.row_stride);
      return;
    }
    const size_t stride = static_cast<size_t>(x_end - x) * pixel;
    const std::unique_ptr<unsigned char[]> rows(new unsigned char[stride * static_cast<size_t>(y_end - y)]);
    read_pixels(reader, read, {x, x_end, y, y_end}, rows.get(), stride);
    const unsigned char* from =
        rows.get() + (read.y - static_cast<uint32_t>(y)) * stride + (read.x - static_cast<uint32_t>(x)) * pixel;
    for (uint32_t row = 0; row < read.height; ++row)
      copy_row(from + row * stride, read.width, read.texels + row * read.row_stride);
  }

  struct Box {
    int x, x_end, y, y_end;
  };

  void read_pixels(TileReader& reader, const TiledRead& read, const Box& box, unsigned char* out, size_t stride) const {
    const size_t row = static_cast<size_t>(box.x_end - box.x) * static_cast<size_t>(channels_) * type_.size();
    // A decoder may succeed without writing all of it.
    for (int y = 0; y < box.y_end - box.y; ++y) std::memset(out + static_cast<size_t>(y) * stride, 0, row);
    OIIO::ImageInput& input = *reader.input.handle;
    const bool done = input.read_tiles(0, static_cast<int>(read.level), box.x, box.x_end, box.y, box.y_end, 0, 1, 0,
                                       channels_, type_, out, OIIO::AutoStride, static_cast<OIIO::stride_t>(stride));
    // Some readers report damage by a message alone.
    if (!done || input.has_error()) refuse_read(reader, read);
  }

  void copy_row(const unsigned char* from, uint32_t count, unsigned char* to) const {
    const size_t size = type_.size(), pixel = static_cast<size_t>(channels_) * size;
    if (channels_ != 3) {
      std::memcpy(to, from, count * pixel);
      return;
    }
    const unsigned char* const one =
        std::find_if(std::begin(kComponents), std::end(kComponents), [&](const Component& c) {
          return type_ == c.type;
        })->one;
    for (uint32_t x = 0; x < count; ++x, from += pixel, to += 4 * size) {
      std::memcpy(to, from, pixel);
      std::memcpy(to + pixel, one, size);
    }
  }

  std::vector<std::string> paths_;
  size_t max_readers_;
  TiledInfo info_;
  int channels_ = 0;
  OIIO::TypeDesc type_;
  core::ForkMutex mutex_{core::ForkLevel::kTileFile};
  uint32_t generation_ = core::fork_generation();
  std::vector<std::unique_ptr<TileReader>> idle_;  // the one used last is the last
};

TiledSet* open_tiled_set(const TiledPaths& paths, TiledInfo* out) {
  auto set = std::make_unique<TiledSet>(paths);
  *out = set->info();
  return set.release();
}

void read_tiled_set(TiledSet& set, const TiledRead& read) {
  set.read(read);
}

void close_tiled_set(TiledSet* set) noexcept {
  delete set;
}

}  // namespace shd::io
