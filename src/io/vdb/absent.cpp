// SPDX-License-Identifier: MIT
// A build without OpenVDB.
#include "core/failure.h"
#include "io/vdb/vdb.h"

namespace shd::io {

Bitmap decode_grid(const unsigned char*, size_t, const LoadOptions&, const Memory&, const Deadline&, const Sink*) {
  core::refuse(SHD_ERROR_UNSUPPORTED, "this libshd_io was built without OpenVDB (SHD_WITH_OPENVDB)");
}

}  // namespace shd::io
