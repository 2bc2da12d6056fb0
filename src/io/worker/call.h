// SPDX-License-Identifier: MIT
#pragma once

#include "io/worker/packet.h"
#include "io/worker/protocol.h"

namespace shd::io {

/// A pair of connected descriptors, the second of which goes to the worker.
struct Ends {
  FileDescriptor ours, theirs;
};

/// The connections of one request. The worker kills the child when `control` is shut down; a process that is forked
/// meanwhile may still hold a copy of the descriptor, so closing alone would not do.
struct Channel {
  Ends control, data;
  Ends input;  // a socket, or unused

  explicit Channel(int input_type);
  Channel(Channel&&) = default;
  ~Channel();
};

/// Hands a request to a fresh child of the worker, which is started if there is none. The child gets `file`, or the
/// other end of a new socket of `input_type` if file is -1. Throws Failure.
Channel begin_call(const char* worker_path, const WorkerRequest& request, int file, int input_type,
                   const Deadline& deadline);

/// Throws Failure unless a transfer is complete: SHD_ERROR_CORRUPT with the signal if the child has died.
void require_done(Stream stream, const Channel& channel, const Deadline& deadline);

}  // namespace shd::io
