// SPDX-License-Identifier: MIT
#pragma once

#include "io/worker/protocol.h"

namespace shd::io {

/// Serves the host until it closes its socket, descriptor 0; for shd-io-worker. Returns the exit status.
int serve();

/// Receives one WorkerRequest with the descriptors data and file, decodes the file in this process, sends the result
/// and exits. Limits of the operating system bound the memory and the time of the process.
[[noreturn]] void run_job(int socket);

}  // namespace shd::io
