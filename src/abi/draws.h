// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include <shd/render.h>

#include "core/allocator.h"
#include "frame/frame.h"

namespace shd::abi {

constexpr uint64_t kMaxItems = 1u << 20;  // draws, instances, lights

/// Checks an affine matrix.
shd_result check_matrix(const char* field, const float m[16]);

/// Prefixes the field of the latest error with the element of a desc that it belongs to.
shd_result in_element(shd_result result, const char* desc, const char* array, size_t index);

/// Checks a caller's draws and appends them, instances as draws of their own. They lie struct_size bytes apart, as the
/// caller's header laid them out. `desc` names the desc that they are in.
shd_result read_draws(const char* desc, const shd_draw* draws, size_t count, core::Buffer<frame::Draw>* out);

}  // namespace shd::abi
