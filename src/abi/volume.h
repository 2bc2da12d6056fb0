// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <shd/volume.h>

#include "core/allocator.h"
#include "frame/frame.h"

namespace shd::abi {

/// Checks a caller's volumes and appends them. They lie struct_size bytes apart.
shd_result read_volumes(const shd_volume_draw* draws, size_t count, core::Buffer<frame::VolumeDraw>* out);

}  // namespace shd::abi
