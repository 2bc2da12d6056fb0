// SPDX-License-Identifier: MIT
// decode() and encode() of a shared libshd_io: they open the module libshd_io_oiio at their first call. OpenImageIO and
// the libraries under it start threads when they are loaded, which a host that only isolates its loads does not need.
#include "io/file/module.h"
#include "io/oiio/module.h"

namespace shd::io {

namespace {

const OiioModule& module() {
  static const auto& opened = *static_cast<const OiioModule*>(open_module(SHD_MODULE_FILE, kOiioSymbol));
  return opened;
}

}  // namespace

Bitmap decode(const DecodeInput& input, const LoadOptions& options, const Memory& memory, const Deadline& deadline,
              const Sink* sink) {
  Bitmap out;
  char text[core::kErrorTextSize] = "";
  require_module_ok(module().decode(input, options, memory, deadline, sink, &out, text), text);
  return out;
}

std::vector<unsigned char> encode(const EncodeJob& job) {
  std::vector<unsigned char> out;
  char text[core::kErrorTextSize] = "";
  require_module_ok(module().encode(job, &out, text), text);
  return out;
}

TiledSet* open_tiled_set(const TiledPaths& paths, TiledInfo* info) {
  TiledSet* set = nullptr;
  char text[core::kErrorTextSize] = "";
  require_module_ok(module().open_tiled_set(paths, info, &set, text), text);
  return set;
}

void read_tiled_set(TiledSet& set, const TiledRead& read) {
  char text[core::kErrorTextSize] = "";
  require_module_ok(module().read_tiled_set(set, read, text), text);
}

void close_tiled_set(TiledSet* set) noexcept {
  if (set) module().close_tiled_set(set);
}

}  // namespace shd::io
