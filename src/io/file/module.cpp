// SPDX-License-Identifier: MIT
#include "io/file/module.h"

#include <dlfcn.h>

#include <cstring>
#include <new>
#include <string>

#include "io/file/printable.h"
#include "io/file/worker_path.h"

namespace shd::io {

const void* open_module(const char* file, const char* symbol) {
  // It stays loaded, because threads of the libraries under it run until the end of the process.
  const std::string path = module_path(file);
  if (path.empty()) core::refuse(SHD_ERROR_NOT_FOUND, "cannot open %s: there is no such file beside libshd_io", file);
  void* handle = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (!handle) {
    const char* reason = ::dlerror();
    core::refuse(SHD_ERROR_NOT_FOUND, "cannot open %s: %s", file,
                 printable(reason ? reason : "no reason given").c_str());
  }
  const void* const opened = ::dlsym(handle, symbol);
  if (!opened || std::strcmp(*static_cast<const char* const*>(opened), SHD_MODULE_VERSION) != 0) {
    core::refuse(SHD_ERROR_INTERNAL, "%s belongs to another version of shd", file);
  }
  return opened;
}

void require_module_ok(shd_result result, const char* text) {
  if (result == SHD_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  if (result != SHD_OK) core::refuse(result, "%s", text);
}

}  // namespace shd::io
