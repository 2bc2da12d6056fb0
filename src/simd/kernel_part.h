// SPDX-License-Identifier: MIT
#pragma once

#include <hwy/base.h>

/// Marks the larger parts of a kernel. They are inlined, except in builds with a sanitizer: these builds would take
/// many minutes to compile a whole kernel as one function.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SHD_KERNEL_PART HWY_NOINLINE
#else
#define SHD_KERNEL_PART HWY_INLINE
#endif

/// Marks lambdas of the hottest loops. gcc 12 does not inline the lambdas of large functions by itself.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SHD_INLINE_LAMBDA
#else
#define SHD_INLINE_LAMBDA __attribute__((always_inline))
#endif
