/* SPDX-License-Identifier: MIT */
/* SIMD targets of this build on this machine. */
#ifndef SHD_TESTS_SUPPORT_SIMD_H
#define SHD_TESTS_SUPPORT_SIMD_H

#include <shd/context.h>

/** Whether contexts can have a target. */
static inline int shd_simd_can_run(int simd)
{
    shd_context_desc desc = shd_context_desc_default();
    shd_context *context = NULL;
    shd_result result;
    desc.simd = (shd_simd)simd;
    result = shd_context_create(&desc, &context);
    shd_context_release(context);
    return result == SHD_OK;
}

#endif /* SHD_TESTS_SUPPORT_SIMD_H */
