/* SPDX-License-Identifier: MIT */
/* The context of a group of tests, from set_up to tear_down. C++ tests of one program share these functions. */
#ifndef SHD_TESTS_SUPPORT_CONTEXT_H
#define SHD_TESTS_SUPPORT_CONTEXT_H

#include <shd/context.h>

#include "support/check.h"

#ifdef __cplusplus
#define SHD_TESTS_SHARED inline
namespace shd::tests
{
#else
#define SHD_TESTS_SHARED static
#endif

SHD_TESTS_SHARED shd_context *g_context;

SHD_TESTS_SHARED int set_up(void **state)
{
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &g_context));
    return 0;
}
SHD_TESTS_SHARED int tear_down(void **state)
{
    (void)state;
    shd_context_release(g_context);
    return 0;
}

#undef SHD_TESTS_SHARED
#ifdef __cplusplus
}  // namespace shd::tests
#endif

#endif /* SHD_TESTS_SUPPORT_CONTEXT_H */
