// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace shd::io {

/// Folder of this library (or program, if linked statically), an absolute path that was determined when the library was
/// loaded: a later chdir() has no effect. "" if unknown.
std::string library_folder();

/// Absolute path of shd-io-worker: the environment variable SHD_IO_WORKER if it is set, otherwise beside this library
/// (or program, if linked statically), otherwise in its place in the installed tree around it, otherwise in the
/// configured install path. The last path need not exist. Throws Failure if SHD_IO_WORKER is a relative path.
std::string default_worker_path();

/// Absolute path of a module: in the folder shd beside this library, or beside it. "" if there is none.
std::string module_path(const std::string& file);

}  // namespace shd::io
