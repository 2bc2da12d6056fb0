// SPDX-License-Identifier: MIT
// The exported variable of the module libshd_io_oiio.
#include "io/file/module.h"
#include "io/oiio/module.h"

namespace shd::io {

namespace {

shd_result module_decode(const DecodeInput& input, const LoadOptions& options, const Memory& memory,
                         const Deadline& deadline, const Sink* sink, Bitmap* out, char* text) {
  return contain(text, [&] { *out = decode(input, options, memory, deadline, sink); });
}

shd_result module_encode(const EncodeJob& job, std::vector<unsigned char>* out, char* text) {
  return contain(text, [&] { *out = encode(job); });
}

shd_result module_open_tiled_set(const TiledPaths& paths, TiledInfo* out, TiledSet** set, char* text) {
  return contain(text, [&] { *set = open_tiled_set(paths, out); });
}

shd_result module_read_tiled_set(TiledSet& set, const TiledRead& read, char* text) {
  return contain(text, [&] { read_tiled_set(set, read); });
}

void module_close_tiled_set(TiledSet* set) {
  close_tiled_set(set);
}

}  // namespace

}  // namespace shd::io

extern "C" {
extern __attribute__((visibility("default"))) const shd::io::OiioModule shd_io_oiio;
const shd::io::OiioModule shd_io_oiio = {SHD_MODULE_VERSION,
                                         shd::io::module_decode,
                                         shd::io::module_encode,
                                         shd::io::module_open_tiled_set,
                                         shd::io::module_read_tiled_set,
                                         shd::io::module_close_tiled_set};
}
