// SPDX-License-Identifier: MIT
#include "io/file/worker_path.h"

#include <dlfcn.h>
#include <link.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

#include "core/failure.h"
#include "io/file/printable.h"

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

/// Folder of an absolute path; "" for any other.
std::string folder_of(const std::string& path) {
  return path.empty() || path[0] != '/' ? "" : path.substr(0, path.rfind('/'));
}

#ifdef __GLIBC__
/// Path of the running program; "" without /proc.
std::string program_path() {
  std::string path(size_t{1} << 16, 0);
  const ssize_t size = ::readlink("/proc/self/exe", path.data(), path.size());
  path.resize(size > 0 ? static_cast<size_t>(size) : 0);
  return path;
}

/// The folder that the dynamic linker stored when it loaded a library by a relative path. The path itself belongs to
/// the working directory of that moment.
std::string origin_of(link_map* library) {
  std::string folder(size_t{1} << 16, 0);
  if (::dlinfo(library, RTLD_DI_ORIGIN, folder.data()) != 0) return "";
  folder.resize(std::strlen(folder.c_str()));
  return folder_of(folder + "/");
}
#endif

}  // namespace

std::string library_folder() {
  Dl_info info = {};
  const auto* const own = reinterpret_cast<const void*>(&library_folder);
#ifdef __GLIBC__
  link_map* library = nullptr;
  const int found = ::dladdr1(own, &info, reinterpret_cast<void**>(&library), RTLD_DL_LINKMAP);
  if (found == 0 || !library) return "";
  if (!*library->l_name) return folder_of(program_path());  // linked statically
  return *library->l_name == '/' ? folder_of(library->l_name) : origin_of(library);
#else
  return ::dladdr(own, &info) != 0 && info.dli_fname ? folder_of(info.dli_fname) : "";
#endif
}

std::string module_path(const std::string& file) {
  const std::string folder = library_folder();
  if (folder.empty()) return "";
  for (const std::string& path : {folder + "/shd/" + file, folder + "/" + file}) {
    if (::access(path.c_str(), R_OK) == 0) return path;
  }
  return "";
}

std::string default_worker_path() {
  const char* named = environment("SHD_IO_WORKER");
  if (named && *named == '/') return named;
  if (named && *named) {
    core::refuse(SHD_ERROR_INVALID_ARGUMENT, "the environment variable SHD_IO_WORKER: \"%s\" is not an absolute path",
                 printable(named).c_str());
  }
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
