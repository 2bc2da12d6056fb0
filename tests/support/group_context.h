/* SPDX-License-Identifier: MIT */
/* The context of a group of tests, for the set-up and tear-down of the group. */
#ifndef SHD_TESTS_GROUP_CONTEXT_H
#define SHD_TESTS_GROUP_CONTEXT_H

#include <shd/context.h>

#include "support/check.h"

static shd_context *g_context;

static int set_up_context(void **state)
{
    (void)state;
    shd_assert_ok(shd_context_create(NULL, &g_context));
    return 0;
}

static int tear_down_context(void **state)
{
    (void)state;
    shd_context_release(g_context);
    return 0;
}

#endif
