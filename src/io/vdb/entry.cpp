// SPDX-License-Identifier: MIT
// The exported variable of the module libshd_io_vdb.
#include "io/file/module.h"
#include "io/vdb/module.h"

namespace shd::io {

namespace {

shd_result module_decode(const unsigned char* bytes, size_t size, const LoadOptions& options, const Memory& memory,
                         const Deadline& deadline, const Sink* sink, Bitmap* out, char* text) {
  return contain(text, [&] { *out = decode_grid(bytes, size, options, memory, deadline, sink); });
}

}  // namespace

}  // namespace shd::io

extern "C" {
extern __attribute__((visibility("default"))) const shd::io::VdbModule shd_io_vdb;
const shd::io::VdbModule shd_io_vdb = {SHD_MODULE_VERSION, shd::io::module_decode};
}
