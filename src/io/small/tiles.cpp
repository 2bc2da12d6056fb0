// SPDX-License-Identifier: MIT
// Tiled files of TIFF and OpenEXR need OpenImageIO; those of KTX2 and DDS do not come here.
#include "io/codec/tiles.h"

#include "core/failure.h"
#include "io/file/printable.h"

namespace shd::io {

class TiledSet {};

TiledSet* open_tiled_set(const TiledPaths& paths, TiledInfo*) {
  core::refuse(SHD_ERROR_UNSUPPORTED,
               "\"%s\": neither KTX2 nor DDS; this build has no OpenImageIO for other tiled files",
               printable(paths.paths[0]).c_str());
}

void read_tiled_set(TiledSet&, const TiledRead&) {}

void close_tiled_set(TiledSet* set) noexcept {
  delete set;
}

}  // namespace shd::io
