// SPDX-License-Identifier: MIT
// Tiled files of TIFF and OpenEXR need OpenImageIO; those of KTX2 and DDS do not come here.
#include "io/codec/tiles.h"

#include "core/failure.h"

namespace shd::io {

class TiledSet {};

TiledSet* open_tiled_set(const TiledPaths&, TiledInfo*) {
  core::refuse(SHD_ERROR_UNSUPPORTED,
               "this build keeps KTX2 and DDS files open, because it has no OpenImageIO for tiled TIFF and OpenEXR");
}

void read_tiled_set(TiledSet&, const TiledRead&) {}

void close_tiled_set(TiledSet* set) noexcept {
  delete set;
}

}  // namespace shd::io
