// SPDX-License-Identifier: MIT
// decode() and encode() of a shared libshd_io: they open the module libshd_io_oiio at their first call. OpenImageIO and
// the libraries under it start threads when they are loaded, which a host that only isolates its loads does not need.
#include <dlfcn.h>
#include <unistd.h>

#include <cstring>
#include <new>
#include <string>

#include "core/failure.h"
#include "io/oiio_module.h"
#include "io/printable.h"
#include "io/worker_path.h"

namespace shd::io {

namespace {

/// Path of the module: in its place in the installed tree, otherwise beside this library.
std::string module_path() {
  const std::string folder = library_folder();
  const std::string installed = folder + "/shd/" SHD_MODULE_FILE;
  return ::access(installed.c_str(), R_OK) == 0 ? installed : folder + "/" SHD_MODULE_FILE;
}

/// Throws Failure; a later call tries again.
const OiioModule& open_module() {
  // It stays loaded, because threads of the libraries under it run until the end of the process.
  void* handle = ::dlopen(module_path().c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (!handle) {
    const char* reason = ::dlerror();
    core::refuse(SHD_ERROR_NOT_FOUND, "cannot open " SHD_MODULE_FILE ": %s",
                 printable(reason ? reason : "no reason given").c_str());
  }
  const auto* opened = static_cast<const OiioModule*>(::dlsym(handle, kOiioSymbol));
  if (!opened || std::strcmp(opened->version, SHD_MODULE_VERSION) != 0) {
    core::refuse(SHD_ERROR_INTERNAL, SHD_MODULE_FILE " belongs to another version of shd");
  }
  return *opened;
}

const OiioModule& module() {
  static const OiioModule& opened = open_module();
  return opened;
}

void require_ok(shd_result result, const char* text) {
  if (result == SHD_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  if (result != SHD_OK) core::refuse(result, "%s", text);
}

}  // namespace

Bitmap decode(const DecodeInput& input, const LoadOptions& options, const Memory& memory, const Deadline& deadline,
              const Sink* sink) {
  Bitmap out;
  char text[core::kErrorTextSize] = "";
  require_ok(module().decode(input, options, memory, deadline, sink, &out, text), text);
  return out;
}

std::vector<unsigned char> encode(const EncodeJob& job) {
  std::vector<unsigned char> out;
  char text[core::kErrorTextSize] = "";
  require_ok(module().encode(job, &out, text), text);
  return out;
}

}  // namespace shd::io
