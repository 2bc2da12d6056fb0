// SPDX-License-Identifier: MIT
#include "io/worker_path.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>

namespace shd::io {

namespace {

/// An environment variable, unless the process has more rights than its caller.
const char* environment(const char* name) {
#ifdef __GLIBC__
  return ::secure_getenv(name);
#else
  return ::getuid() == ::geteuid() && ::getgid() == ::getegid() ? std::getenv(name) : nullptr;
#endif
}

}  // namespace

std::string library_folder() {
  Dl_info info = {};
  if (::dladdr(reinterpret_cast<const void*>(&library_folder), &info) == 0 || !info.dli_fname) return "";
  const std::string file(info.dli_fname);
  const size_t slash = file.rfind('/');
  return slash == std::string::npos ? "." : file.substr(0, slash);
}

std::string default_worker_path() {
  const char* named = environment("SHD_IO_WORKER");
  if (named && *named) return named;
  const std::string folder = library_folder();
  if (!folder.empty()) {
    for (const char* relative : {"/shd-io-worker", "/" SHD_WORKER_FROM_LIBRARY}) {
      const std::string path = folder + relative;
      if (::access(path.c_str(), X_OK) == 0) return path;
    }
  }
  return SHD_WORKER_INSTALLED;
}

}  // namespace shd::io
