// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <shd/io.h>

#include "io/limits.h"

namespace shd::io {

// One request and one reply go over a stream socket, the worker's descriptor 0; both ends are of one build.

/// Followed by `size` bytes, the file.
struct WorkerRequest {
  uint32_t magic;
  uint32_t formats;
  uint32_t flags;
  uint32_t encoding;
  uint32_t subimage;
  uint32_t reserved;
  Limits limits;
  uint64_t size;
};

/// Followed by `size` bytes, the pixels, when code is SHD_OK.
struct WorkerReply {
  uint32_t magic;
  uint32_t code;
  uint32_t format;
  uint32_t width;
  uint32_t height;
  uint32_t reserved;
  uint64_t size;
  shd_bitmap_info info;
  char color_space[64];
  char message[1024];
};

constexpr uint32_t kWorkerMagic = 0x73686431;  // "shd1"; changes with these structs

}  // namespace shd::io
