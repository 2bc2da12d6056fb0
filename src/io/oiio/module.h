// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "io/codec/codec.h"
#include "io/codec/tiles.h"

namespace shd::io {

/// The functions of the module libshd_io_oiio. Both ends must be of one build. No exception leaves them: a failure is a
/// result and a text of at most core::kErrorTextSize bytes.
struct OiioModule {
  const char* version;
  shd_result (*decode)(const DecodeInput& input, const LoadOptions& options, const Memory& memory,
                       const Deadline& deadline, const Sink* sink, Bitmap* out, char* text);
  shd_result (*encode)(const EncodeJob& job, std::vector<unsigned char>* out, char* text);
  shd_result (*open_tiled_set)(const TiledPaths& paths, TiledInfo* out, TiledSet** set, char* text);
  shd_result (*read_tiled_set)(TiledSet& set, const TiledRead& read, char* text);
  void (*close_tiled_set)(TiledSet* set);
};

/// Name of the module's only exported variable, of type OiioModule.
constexpr const char* kOiioSymbol = "shd_io_oiio";

}  // namespace shd::io
