// SPDX-License-Identifier: MIT
#pragma once

#include "io/vdb/vdb.h"

namespace shd::io {

/// The function of the module libshd_io_vdb; see io/oiio_module.h.
struct VdbModule {
  const char* version;
  shd_result (*decode)(const unsigned char* bytes, size_t size, const LoadOptions& options, const Memory& memory,
                       const Deadline& deadline, const Sink* sink, Bitmap* out, char* text);
};

/// Name of the module's only exported variable, of type VdbModule.
constexpr const char* kVdbSymbol = "shd_io_vdb";

}  // namespace shd::io
