// SPDX-License-Identifier: MIT
// decode_grid() of a shared libshd_io: it opens the module libshd_io_vdb at its first call.
#include "io/file/module.h"
#include "io/vdb/module.h"

namespace shd::io {

Bitmap decode_grid(const unsigned char* bytes, size_t size, const LoadOptions& options, const Memory& memory,
                   const Deadline& deadline, const Sink* sink) {
  static const auto& opened = *static_cast<const VdbModule*>(open_module(SHD_VDB_MODULE_FILE, kVdbSymbol));
  Bitmap out;
  char text[core::kErrorTextSize] = "";
  require_module_ok(opened.decode(bytes, size, options, memory, deadline, sink, &out, text), text);
  return out;
}

}  // namespace shd::io
