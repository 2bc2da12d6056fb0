// SPDX-License-Identifier: MIT
#pragma once

namespace shd::io {

/// Makes libtiff silent, once per process. OpenImageIO 2.5 leaves messages about TIFF files in memory to libtiff, which
/// prints them to stderr by default. Handlers that the host or OpenImageIO has set stay. `open_image_io` is the address
/// of a function of OpenImageIO.
void silence_libtiff(const void* open_image_io);

}  // namespace shd::io
