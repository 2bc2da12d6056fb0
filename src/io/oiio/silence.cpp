// SPDX-License-Identifier: MIT
#include "io/oiio/silence.h"

#include <dlfcn.h>

#include <cstdarg>

namespace shd::io {

namespace {

using Handler = void (*)(const char* module, const char* format, va_list arguments);
using SetHandler = Handler (*)(Handler);

const void* library_of(const void* address) {
  Dl_info info;
  return dladdr(address, &info) ? info.dli_fbase : nullptr;
}

/// Replaces a handler of libtiff by none if libtiff itself has set it. `libraries` is searched for libtiff.
void silence(void* libraries, const char* set_name) {
  void* const symbol = dlsym(libraries, set_name);
  if (!symbol) return;  // OpenImageIO without TIFF
  const auto set = reinterpret_cast<SetHandler>(symbol);
  const Handler previous = set(nullptr);
  if (library_of(reinterpret_cast<const void*>(previous)) != library_of(symbol)) set(previous);
}

bool silence_all(const char* open_image_io) {
  // Libraries that are loaded privately (RTLD_LOCAL) are found by way of their user only.
  void* const libraries = dlopen(open_image_io, RTLD_NOLOAD | RTLD_LAZY);
  if (!libraries) return false;
  silence(libraries, "TIFFSetErrorHandler");
  silence(libraries, "TIFFSetWarningHandler");
  dlclose(libraries);
  return true;
}

}  // namespace

void silence_libtiff(const void* open_image_io) {
  static const bool done = [&] {
    Dl_info info;
    return dladdr(open_image_io, &info) && silence_all(info.dli_fname);
  }();
  (void)done;
}

}  // namespace shd::io
