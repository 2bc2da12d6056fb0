// SPDX-License-Identifier: MIT
// One file, in a child of the worker. Limits of the operating system bound its memory and time, so that a failing
// decoder ends only this process.
#include "io/server/job.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "core/guard.h"
#include "io/bitmap/levels.h"
#include "io/codec/codec.h"
#include "io/file/read_file.h"
#include "io/load/load.h"
#include "io/server/confine.h"
#include "io/server/memory.h"
#include "io/server/module.h"
#include "io/server/send.h"
#include "io/worker/packet.h"

namespace shd::io {

namespace {

/// Largest size of a bitmap with its mip levels that a request allows; cannot overflow for any request [bytes].
uint64_t decoded_bytes(const WorkerRequest& request) {
  return std::min(request.limits.bytes, std::min(request.limits.pixels, 2 * kMaxSide * kMaxSide) * 16);
}

/// More than any pipe holds that an unprivileged process makes [bytes].
constexpr int kMaxPipe = 1 << 24;

/// Decoders hold up to two copies of a picture in addition to the result. The constant covers three copies of the
/// largest row or tile that any max_bytes allows, 64 MiB, and tables. The server kills a child at its deadline, too;
/// the limit of time holds if the server ends.
void confine(const WorkerRequest& request) {
  const uint64_t decoded = decoded_bytes(request);
  // Some decoders need an anonymous file of the same size.
  const bool needs_file =
      (request.formats & SHD_FILE_FORMAT_ANY) != 0 || static_cast<Parts>(request.parts) == Parts::kGrid;
  const uint64_t memory = 3 * decoded + 3 * request.size + (uint64_t{256} << 20);
  confine(Confinement{memory, needs_file ? request.size : 0, request.limits.seconds});
  limit_process(decoded);
}

LoadOptions options_of(const WorkerRequest& request) {
  LoadOptions options;
  options.parts = static_cast<Parts>(request.parts);
  options.grid = request.grid;
  options.formats = request.formats;
  options.flags = request.flags;
  options.encoding = static_cast<shd_color_encoding>(request.encoding);
  options.subimage = request.subimage;
  options.limits = request.limits;
  return options;
}

void describe(const Bitmap& bitmap, WorkerReply* reply) {
  reply->code = SHD_OK;
  reply->format = static_cast<uint32_t>(bitmap.format);
  reply->width = bitmap.width;
  reply->height = bitmap.height;
  reply->level_count = bitmap.level_count;
  reply->depth = bitmap.depth;
  reply->size =
      bitmap.layout.image_count ? bitmap.layout.size : bitmap_pixels(bitmap) * bitmap_pixel_size(bitmap.format);
  reply->info = bitmap.info;
  reply->grid = bitmap.grid;
  reply->layout = bitmap.layout;
  std::memcpy(reply->color_space, bitmap.color_space, sizeof reply->color_space);
}

/// State of the answer to a request.
struct Answer {
  int pipe;
  WorkerReply reply;
  bool begun;  // the first reply has been sent
  LentRing ring;
};

void send_description(void* owner, const Bitmap& bitmap, const Packing& packing) {
  auto* answer = static_cast<Answer*>(owner);
  describe(bitmap, &answer->reply);
  answer->reply.channels = static_cast<uint32_t>(packing.channels);
  std::copy(std::begin(packing.map.index), std::end(packing.map.index), answer->reply.map);
  require_sent(send_all(answer->pipe, &answer->reply, sizeof answer->reply));
  answer->begun = true;
}

unsigned char* make_room(void* owner, size_t size) {
  return static_cast<Answer*>(owner)->ring.room(size);
}

void send_piece(void* owner, const unsigned char* bytes, size_t size) {
  const auto* answer = static_cast<Answer*>(owner);
  const uint64_t piece = size;
  require_sent(send_all(answer->pipe, &piece, sizeof piece) && lend_all(answer->pipe, bytes, size));
}

size_t pipe_capacity(int pipe) {
  const int size = ::fcntl(pipe, F_GETPIPE_SZ);
  return static_cast<size_t>(size > 0 ? size : kMaxPipe);
}

/// Memory that the pipe may refer to until the process ends.
struct Lent {
  Buffer bytes;
  Bitmap bitmap;
};

/// Decodes the file of a request and sends it; a failure is stored in the reply.
Lent answer_request(const WorkerRequest& request, int file, Answer* answer) {
  Lent lent;
  const auto report = [&](shd_result code, const char* text) {
    answer->reply.code = static_cast<uint32_t>(code);
    if (code == SHD_ERROR_OUT_OF_MEMORY) text = "out of memory in the worker";
    std::strncpy(answer->reply.message, text, sizeof answer->reply.message - 1);
    return code;
  };
  core::guard(report, [&] {
    const Deadline deadline(request.limits.seconds);
    lent.bytes = read_bytes(file, request.size, kWorkerMemory);
    const Sink sink = {answer, send_description, make_room, send_piece};
    lent.bitmap = load(lent.bytes.data(), lent.bytes.size(), options_of(request), kWorkerMemory, deadline, &sink);
    describe(lent.bitmap, &answer->reply);
    return SHD_OK;
  });
  return lent;
}

/// Overwrites what the server left on the stack, which differs between two children.
__attribute__((noinline)) void wipe_stack() {
  volatile unsigned char unused[1 << 15];
  for (size_t i = 0; i < sizeof unused; ++i) unused[i] = 0;
}

}  // namespace

void run_job(int socket) {
  wipe_stack();
  WorkerRequest request = {};
  FileDescriptor handed[2];
  if (receive_packet(socket, &request, sizeof request, handed, 2, Deadline(1e9)) != Stream::kDone) _exit(2);
  ::close(socket);
  if (names_module(request)) run_module(request, handed[0].fd, handed[1].fd);
  confine(request);
  static Answer answer = {handed[0].fd, {}, false, LentRing(pipe_capacity(handed[0].fd))};
  answer.reply.magic = kWorkerMagic;
  const Lent lent = answer_request(request, handed[1].fd, &answer);
  constexpr uint64_t kEnd = 0;
  if (answer.begun) require_sent(send_all(answer.pipe, &kEnd, sizeof kEnd));
  require_sent(send_all(answer.pipe, &answer.reply, sizeof answer.reply));
  _exit(0);
}

}  // namespace shd::io
