// SPDX-License-Identifier: MIT
#pragma once

#include "core/regular_file.h"

namespace shd::io {

using core::FileDescriptor;

/// Throws a Failure with the text `<action> "<path>": <reason>`. The code is SHD_ERROR_NOT_FOUND for a missing file,
/// SHD_ERROR_INVALID_ARGUMENT for a path that the system cannot represent, SHD_ERROR_OUT_OF_MEMORY for lack of memory,
/// otherwise SHD_ERROR_IO.
[[noreturn]] void refuse_errno(const char* action, const char* path, int error);

}  // namespace shd::io
