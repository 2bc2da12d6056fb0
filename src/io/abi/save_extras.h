// SPDX-License-Identifier: MIT
#pragma once

#include <shd/io.h>

#include "io/abi/plane_rows.h"
#include "io/codec/codec.h"
#include "io/file/memory.h"

namespace shd::io {

/// Appends the texts of a desc to an OpenEXR file. Checks them for any file. Throws Failure.
void add_attributes(const shd_save_desc& desc, bool is_exr, EncodeJob* job);

/// Appends the matrices of a view to an OpenEXR file.
void add_matrices(const shd_view& view, EncodeJob* job);

/// Appends the channels of a desc to an OpenEXR file. Checks them for any file. Throws Failure.
void add_channels(const shd_save_desc& desc, bool is_exr, PlaneRows* rows, EncodeJob* job);

/// Distances along the viewing direction, [height][width] floats, from depths of the view. Throws Failure.
Buffer make_distances(const shd_view& view, const shd_plane_view& depth, uint32_t width, uint32_t height,
                      const Memory& memory);

}  // namespace shd::io
