// SPDX-License-Identifier: MIT
#pragma once

#include "scene/host_files.h"
#include "scene/model.h"

namespace shd::scene {

/// Reads a model by the module of the readers in this process.
Model read_in_process(HostFiles& files, const Limits& limits, const Deadline& deadline);

/// Reads a model in a child of the worker, and checks its reply. A null worker_path is that of libshd_io.
/// WebAssembly (reading_sandbox.cpp) has no processes, and its instance is the sandbox: it reads as read_in_process().
Model read_by_worker(HostFiles& files, const char* worker_path, const Limits& limits, const Deadline& deadline);

}  // namespace shd::scene
