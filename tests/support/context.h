// SPDX-License-Identifier: MIT
// The context of a group of tests, from set_up to tear_down. Tests of one program share these functions.
#pragma once

#include <shd/shd.h>

#include "support/check.h"

namespace shd::tests
{

inline shd_context *g_context;

inline int set_up(void **)
{
    shd_assert_ok(shd_context_create(nullptr, &g_context));
    return 0;
}
inline int tear_down(void **)
{
    shd_context_release(g_context);
    return 0;
}

}  // namespace shd::tests
