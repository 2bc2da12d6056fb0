// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace shd::io {

/// Folder of this library (or program, if linked statically); "" if unknown.
std::string library_folder();

/// Path of shd-io-worker: the environment variable SHD_IO_WORKER if it is set, otherwise beside this library (or
/// program, if linked statically), otherwise in its place in the installed tree around it, otherwise in the configured
/// install path. The last path need not exist.
std::string default_worker_path();

}  // namespace shd::io
