// SPDX-License-Identifier: MIT
#pragma once

#include "io/worker/protocol.h"

namespace shd::io {

/// Whether a request names a module.
inline bool names_module(const WorkerRequest& request) {
  return request.module[0] != 0;
}

/// Opens the module of a request in this process, so that its children need not. Returns whether it is new; a module
/// that cannot be opened is not, and run_module() has the reason.
bool open_for_children(const WorkerRequest& request);

/// Runs the module of a request in this child, and sends its reply to `pipe`. `questions` is the socket to the host.
[[noreturn]] void run_module(const WorkerRequest& request, int pipe, int questions);

}  // namespace shd::io
