// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "io/file/file_descriptor.h"
#include "io/file/limits.h"

namespace shd::io {

/// A connection to the worker of this process.
struct WorkerLink {
  FileDescriptor socket;
  uint64_t generation;  // number of the worker, counted by this process
};

/// Connects to the worker, which is started by the first load and whenever there is none. Another program replaces the
/// one that runs. Throws Failure; SHD_ERROR_LIMIT if the deadline passes first, and then the worker goes on starting.
WorkerLink connect_worker(const std::string& program, const Deadline& deadline);

/// Ends a worker that does not work, unless another one has taken its place.
void drop_worker(const WorkerLink& link, const Deadline& deadline);

/// Reports that the worker took a request.
void worker_answered(const WorkerLink& link, const Deadline& deadline);

/// Reports that the worker did not take a request, sent at `since`, until the deadline of the load. A worker that takes
/// no request for two seconds is ended.
void worker_silent(const WorkerLink& link, std::chrono::steady_clock::time_point since);

}  // namespace shd::io
