// SPDX-License-Identifier: MIT
// The exported variable of the module libshd_io_oiio.
#include "io/module.h"
#include "io/oiio_module.h"

namespace shd::io {

namespace {

shd_result module_decode(const DecodeInput& input, const LoadOptions& options, const Memory& memory,
                         const Deadline& deadline, const Sink* sink, Bitmap* out, char* text) {
  return contain(text, [&] { *out = decode(input, options, memory, deadline, sink); });
}

shd_result module_encode(const EncodeJob& job, std::vector<unsigned char>* out, char* text) {
  return contain(text, [&] { *out = encode(job); });
}

}  // namespace

}  // namespace shd::io

extern "C" {
extern __attribute__((visibility("default"))) const shd::io::OiioModule shd_io_oiio;
const shd::io::OiioModule shd_io_oiio = {SHD_MODULE_VERSION, shd::io::module_decode, shd::io::module_encode};
}
