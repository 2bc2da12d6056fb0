/* SPDX-License-Identifier: MIT */
/**
 * @file
 * @brief Texels outside an image, for lookups and for mip kernels.
 *
 * Thread safety: this header has no functions.
 *
 * @code
 * shd_sampler_desc desc = shd_sampler_desc_default();
 * desc.wrap_u = SHD_WRAP_REPEAT, desc.wrap_v = SHD_WRAP_CLAMP;
 * @endcode
 */
#ifndef SHD_WRAP_H
#define SHD_WRAP_H

#include <shd/base.h>

SHD_BEGIN_DECLS

/** Texel that index i reads along an axis of n texels (Vulkan specification, "Wrapping Operation"). */
typedef enum shd_wrap {
    SHD_WRAP_REPEAT = 0,      /**< i mod n */
    SHD_WRAP_CLAMP = 1,       /**< clamp(i, 0, n - 1) */
    SHD_WRAP_MIRROR = 2,      /**< repeat with every second copy flipped */
    SHD_WRAP_BORDER = 3,      /**< the border colour outside 0..n - 1 */
    SHD_WRAP_MIRROR_ONCE = 4, /**< one flipped copy below 0, clamped beyond: clamp(i < 0 ? -1 - i : i, 0, n - 1) */
    SHD_WRAP_MAX_ENUM = 0x7fffffff
} shd_wrap;

SHD_END_DECLS

#endif /* SHD_WRAP_H */
