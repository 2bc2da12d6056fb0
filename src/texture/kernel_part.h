// SPDX-License-Identifier: MIT
#pragma once

#include <hwy/base.h>

/// The larger pieces of a kernel: inlined, but for builds with a sanitizer, whose bookkeeping for a whole kernel in
/// one function takes the compiler many minutes.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SHD_KERNEL_PART HWY_NOINLINE
#else
#define SHD_KERNEL_PART HWY_INLINE
#endif
