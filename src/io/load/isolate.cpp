// SPDX-License-Identifier: MIT
#include "io/load/isolate.h"

#include <sys/socket.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/failure.h"
#include "core/printable.h"
#include "io/bitmap/channels.h"
#include "io/bitmap/levels.h"
#include "io/container/texture_load.h"
#include "io/worker/call.h"
#include "io/worker/packet.h"

namespace shd::io {

#ifndef __linux__

Bitmap load_isolated(const char*, const Source&, const LoadOptions&, const Memory&, const Deadline&) {
  core::refuse(SHD_ERROR_UNSUPPORTED, "the worker needs Linux; trusted files load with SHD_LOAD_IN_PROCESS");
}

#else

namespace {

/// Pixels that are received and then expanded while the processor's cache holds them.
constexpr size_t kChunkPixels = size_t{1} << 14;

WorkerRequest make_request(const LoadOptions& options, size_t size) {
  WorkerRequest request = {};
  request.magic = kWorkerMagic;
  request.formats = options.formats;
  request.flags = options.flags;
  request.encoding = static_cast<uint32_t>(options.encoding);
  request.subimage = options.subimage;
  request.parts = static_cast<uint32_t>(options.parts);
  request.grid = options.grid;
  request.limits = options.limits;
  request.size = size;
  return request;
}

/// Checks the properties of a grid.
GridInfo check_grid(const WorkerReply& reply, const LoadOptions& options) {
  if (options.parts != Parts::kGrid) return {};
  GridInfo grid = reply.grid;
  bool good = reply.format == SHD_FORMAT_R32F && grid.grid_class <= SHD_VDB_CLASS_FOG_VOLUME;
  for (const double value : grid.index_to_world) good = good && std::isfinite(value);
  if (!good) core::refuse(SHD_ERROR_CORRUPT, "the decoder sent a wrong grid");
  grid.name[sizeof grid.name - 1] = 0;
  core::make_printable(grid.name, std::strlen(grid.name));
  return grid;
}

Packing packing_of(const WorkerReply& reply) {
  return {static_cast<int>(reply.channels), {{reply.map[0], reply.map[1], reply.map[2], reply.map[3]}}};
}

void check_packing(const WorkerReply& reply, const LoadOptions& options) {
  if (reply.channels < 1 || reply.channels > 4) {
    core::refuse(SHD_ERROR_CORRUPT, "the decoder sent %u channels", reply.channels);
  }
  for (const int32_t index : reply.map) {
    if (index >= -1 && index < static_cast<int32_t>(reply.channels)) continue;
    core::refuse(SHD_ERROR_CORRUPT, "the decoder sent channel %d of %u", index, reply.channels);
  }
  if (!has_one_channel(static_cast<shd_format>(reply.format))) return;
  if (options.parts == Parts::kImage || !(packing_of(reply) == kSingle)) {
    core::refuse(SHD_ERROR_CORRUPT, "the decoder sent format %u", reply.format);
  }
}

void check_depth(const WorkerReply& reply, const LoadOptions& options) {
  const bool volume = options.parts == Parts::kSlices || options.parts == Parts::kGrid;
  if (reply.depth < 1 || (reply.depth > 1 && (!volume || reply.level_count > 1))) {
    core::refuse(SHD_ERROR_CORRUPT, "the decoder sent %u slices", reply.depth);
  }
  if (volume) check_volume(options.limits, reply.width, reply.height, reply.depth);
}

/// Whether the load gives the texels of a texture file as they are.
bool is_texture(const LoadOptions& options) {
  return options.parts == Parts::kTexture || options.parts == Parts::kTextureImage;
}

/// Size of the texels of a texture. Throws Failure unless its description is one of a file of this size.
size_t check_texture(const WorkerReply& reply, const LoadOptions& options, size_t file_size) {
  check_layout(reply.layout, options);
  Limits limits = options.limits;
  limits.pixels = UINT64_MAX;  // check_layout() has counted the texels; these are bytes
  const size_t size = check_bytes(limits, reply.layout.size, 1, file_size);
  const shd_texture_file_info& info = reply.layout.info;
  if (reply.size != size || reply.width != info.width || reply.height != info.height ||
      reply.format != static_cast<uint32_t>(info.format) || reply.depth != 1 || reply.level_count != 1) {
    core::refuse(SHD_ERROR_CORRUPT, "the decoder sent a wrong texture");
  }
  return size;
}

/// Checks every field of a reply, because the process that sent it has read hostile bytes. Returns the size of the
/// pixels.
size_t check_reply(WorkerReply& reply, const LoadOptions& options, size_t file_size) {
  reply.message[sizeof reply.message - 1] = 0;
  reply.color_space[sizeof reply.color_space - 1] = 0;
  if (reply.magic != kWorkerMagic || reply.code > SHD_ERROR_INTERNAL) {
    core::refuse(SHD_ERROR_CORRUPT, "the decoder sent a wrong reply");
  }
  core::make_printable(reply.message, std::strlen(reply.message));
  if (reply.code != SHD_OK) core::refuse(static_cast<shd_result>(reply.code), "%s", reply.message);
  if (is_texture(options)) return check_texture(reply, options, file_size);
  const size_t pixel = bitmap_pixel_size(static_cast<shd_format>(reply.format));
  if (pixel == 0) core::refuse(SHD_ERROR_CORRUPT, "the decoder sent format %u", reply.format);
  check_packing(reply, options);
  check_extent(options.limits, "image", reply.width, reply.height);
  const bool levels = (options.flags & SHD_LOAD_FILE_LEVELS) != 0;
  const uint32_t most = levels ? full_level_count(reply.width, reply.height) : 1;
  if (reply.level_count < 1 || reply.level_count > most) {
    core::refuse(SHD_ERROR_CORRUPT, "the decoder sent %u mip levels", reply.level_count);
  }
  check_depth(reply, options);
  const uint64_t total = level_pixels(reply.width, reply.height, reply.level_count) * reply.depth;
  const size_t size = check_bytes(options.limits, total, pixel, file_size);
  if (size != reply.size) core::refuse(SHD_ERROR_CORRUPT, "the decoder sent a wrong size");
  for (char* c = reply.color_space; *c; ++c) {
    if (*c < 0x20 || *c > 0x7e) *c = '?';
  }
  return size;
}

shd_bitmap_info check_info(const shd_bitmap_info& sent) {
  shd_bitmap_info info = {};
  const auto format = static_cast<uint32_t>(sent.file_format);
  const bool single = format == SHD_FILE_FORMAT_ANY || (format < 0x8000 && (format & (format - 1)) == 0);
  if (!single || (sent.flags & ~uint32_t{SHD_BITMAP_PARTIAL | SHD_BITMAP_PREMULTIPLIED}) != 0) {
    core::refuse(SHD_ERROR_CORRUPT, "the decoder sent wrong properties");
  }
  info.file_format = sent.file_format;
  info.channel_count = sent.channel_count;
  info.flags = sent.flags;
  return info;
}

/// Receives the pixels that a checked reply describes, and expands them to RGBA.
class PixelReceiver {
 public:
  /// The pixels of a texture are its bytes, of no format.
  PixelReceiver(const Channel& channel, const WorkerReply& reply, shd_format format, const Buffer& pixels,
                const Memory& memory, const Deadline& deadline)
      : channel_(channel),
        deadline_(deadline),
        format_(format),
        packing_(packing_of(reply)),
        expanded_(std::max<size_t>(bitmap_pixel_size(format_), 1)),
        packed_(format == SHD_FORMAT_NONE || has_one_channel(format_) ? expanded_ : expanded_ / 4 * reply.channels),
        next_(pixels.data()),
        left_(pixels.size() / expanded_),
        chunk_(memory, packed_ == expanded_ && (packing_ == kExpanded || packing_ == kSingle)
                           ? 0
                           : std::min(left_, kChunkPixels) * packed_) {}

  /// Receives pieces until the child ends them. Returns the number of pixels that are absent.
  size_t receive() {
    while (true) {
      uint64_t piece = 0;
      receive_bytes(&piece, sizeof piece);
      if (piece == 0) return left_;
      if (piece > left_ * packed_) core::refuse(SHD_ERROR_CORRUPT, "the decoder sent too many pixels");
      if (piece % packed_ != 0) core::refuse(SHD_ERROR_CORRUPT, "the decoder sent a part of a pixel");
      receive_piece(static_cast<size_t>(piece / packed_));
    }
  }

 private:
  void receive_bytes(void* bytes, size_t size) {
    require_done(receive_all(channel_.data.ours.fd, bytes, size, deadline_), channel_, deadline_);
  }

  void receive_piece(size_t pixels) {
    left_ -= pixels;
    if (!chunk_.size()) {
      receive_bytes(next_, pixels * expanded_);
      next_ += pixels * expanded_;
      return;
    }
    while (pixels > 0) {
      const size_t count = std::min(pixels, kChunkPixels);
      receive_bytes(chunk_.data(), count * packed_);
      expand_pixels(packing_.map, 0, chunk_.data(), static_cast<size_t>(packing_.channels), count, format_, next_);
      next_ += count * expanded_;
      pixels -= count;
    }
  }

  const Channel& channel_;
  const Deadline& deadline_;
  const shd_format format_;
  const Packing packing_;
  const size_t expanded_, packed_;  // size of a pixel after and before its expansion [bytes]
  unsigned char* next_;
  size_t left_;         // pixels that have not been announced
  const Buffer chunk_;  // for pixels that are not RGBA
};

/// Receives the pixels that `first` describes, and the final reply.
Bitmap receive_bitmap(const Channel& channel, WorkerReply& first, const LoadOptions& options, size_t file_size,
                      const Memory& memory, const Deadline& deadline) {
  Bitmap out;
  out.pixels = Buffer(memory, check_reply(first, options, file_size));
  (void)check_info(first.info);
  const shd_format format = is_texture(options) ? SHD_FORMAT_NONE : static_cast<shd_format>(first.format);
  const size_t pixel = std::max<size_t>(bitmap_pixel_size(format), 1);
  const size_t absent = PixelReceiver(channel, first, format, out.pixels, memory, deadline).receive() * pixel;
  WorkerReply last;
  require_done(receive_all(channel.data.ours.fd, &last, sizeof last, deadline), channel, deadline);
  const size_t size = check_reply(last, options, file_size);
  const bool same = last.format == first.format && last.width == first.width && last.height == first.height &&
                    last.depth == first.depth;
  if (!same || size > out.pixels.size() - absent) core::refuse(SHD_ERROR_CORRUPT, "the decoder sent a wrong size");
  if (!(packing_of(last) == packing_of(first))) core::refuse(SHD_ERROR_CORRUPT, "the decoder sent other channels");
  out.format = static_cast<shd_format>(last.format);
  out.width = last.width;
  out.height = last.height;
  out.depth = last.depth;
  out.level_count = last.level_count;
  out.info = check_info(last.info);
  out.grid = check_grid(last, options);
  if (is_texture(options)) out.layout = last.layout;
  std::memcpy(out.color_space, last.color_space, sizeof out.color_space);
  return out;
}

Bitmap finish_load(const Channel& channel, const Source& source, const LoadOptions& options, const Memory& memory,
                   const Deadline& deadline) {
  WorkerReply reply;
  Stream stream = Stream::kDone;
  if (source.bytes) stream = send_all(channel.input.ours.fd, source.bytes, source.size, deadline);
  // A child that refuses a file need not have read all of it.
  if (stream != Stream::kLate) stream = receive_all(channel.data.ours.fd, &reply, sizeof reply, deadline);
  require_done(stream, channel, deadline);
  return receive_bitmap(channel, reply, options, source.size, memory, deadline);
}

}  // namespace

Bitmap load_isolated(const char* worker_path, const Source& source, const LoadOptions& options, const Memory& memory,
                     const Deadline& deadline) {
  const Channel channel = begin_call(worker_path, make_request(options, source.size), source.bytes ? -1 : source.file,
                                     source.bytes ? SOCK_STREAM : 0, deadline);
  return finish_load(channel, source, options, memory, deadline);
}

#endif

}  // namespace shd::io
