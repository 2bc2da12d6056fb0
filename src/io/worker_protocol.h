// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <shd/io.h>

#include "io/limits.h"

namespace shd::io {

// One request and one reply are sent over a stream socket, descriptor 0 of the worker. Both ends must be of one build.

/// Followed by `size` bytes: the file.
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

/// Followed by `size` bytes of pixels if code is SHD_OK.
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

constexpr uint32_t kWorkerMagic = 0x73686431;  // "shd1"; must change with these structs

}  // namespace shd::io
