// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "io/bitmap/bitmap.h"

namespace shd::io {

// The worker is a fork server. Its descriptor 0 is a socket (SOCK_SEQPACKET) to the host. It sends one WorkerHello, and
// receives one WorkerRequest for each load with three descriptors:
//   0  control, a socket (SOCK_SEQPACKET): the server sends WorkerStarted when a child has got the load, and
//      WorkerEnded when this child has ended. It kills the child when the host closes its end.
//   1  data, a pipe: the child alone writes to it. It sends a WorkerReply as soon as the file is described; if its code
//      is SHD_OK, pieces of the pixels in order while it decodes, each behind its size as a uint64_t, the size 0, and
//      the final WorkerReply. A piece is whole pixels of the `channels` of the reply. The host expands them to RGBA in
//      its own memory, and uses nothing before the final reply. The pieces of a texture are bytes of its layout.
//   2  file, which the child reads from its start. If the request names a module, it is a socket (SOCK_SEQPACKET): the
//      child sends WorkerQuestions, and receives for each a WorkerAnswer with the descriptor of a file.
// The reply of a module is pieces as above, but of any bytes and without a WorkerReply before them.
// Both ends must be of one build.

/// The server is ready; with its own pidfd if the system has one.
struct WorkerHello {
  uint32_t magic;
  int32_t error;  // errno if the server cannot start
};

struct WorkerRequest {
  uint32_t magic;
  uint32_t module_request_size;        // size of module_request [bytes]
  char module[1024];                   // absolute path of a module, which gets the request; "" = an image
  unsigned char module_request[1024];  // limits.bytes is the memory of the child
  uint32_t formats;
  uint32_t flags;
  uint32_t encoding;
  uint32_t subimage;
  uint32_t parts;
  GridRequest grid;
  Limits limits;
  uint64_t size;  // bytes of the file
};

struct WorkerStarted {
  int32_t error;  // errno if there is no child
};

struct WorkerEnded {
  int32_t status;  // status of waitpid()
};

/// A question of a child that runs a module: the name of a file.
struct WorkerQuestion {
  uint32_t magic;
  char name[4096];
};

/// With one descriptor if `found`.
struct WorkerAnswer {
  uint32_t found;
  uint64_t size;  // size of the file [bytes]
};

/// The size is that of the pixels of all slices and levels in `format` [bytes]. A pixel on the pipe has `channels`
/// values, 1..4; `map` has the index of r, g, b and a among them, or -1. In the final reply, damage may have changed
/// the code, the flags, and level_count with the size, which are then smaller; surplus pixels count as absent.
struct WorkerReply {
  uint32_t magic;
  uint32_t code;
  uint32_t format;
  uint32_t width;
  uint32_t height;
  uint32_t level_count;
  uint32_t channels;
  int32_t map[4];
  uint32_t depth;
  uint64_t size;
  shd_bitmap_info info;
  GridInfo grid;
  TextureLayout layout;
  char color_space[64];
  char message[1024];
};

constexpr uint32_t kWorkerMagic = 0x73686437;  // "shd7"; must change with these structs

}  // namespace shd::io
