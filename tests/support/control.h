/* SPDX-License-Identifier: MIT */
/* Floating-point control of the calling thread: the register MXCSR of x86, and the values that hosts set. */
#ifndef SHD_TESTS_SUPPORT_CONTROL_H
#define SHD_TESTS_SUPPORT_CONTROL_H

#if defined(__SSE__)
#include <xmmintrin.h>
#define SHD_HAS_MXCSR 1
#else
#define SHD_HAS_MXCSR 0
#endif

#include "support/check.h"

static inline unsigned shd_read_control(void)
{
#if SHD_HAS_MXCSR
    return _mm_getcsr();
#else
    return 0;
#endif
}
static inline void shd_write_control(unsigned value)
{
#if SHD_HAS_MXCSR
    _mm_setcsr(value);
#else
    (void)value;
#endif
}

/** A value of the register; 0x1f80 is the default of IEEE 754. */
struct control_case {
    const char *name;
    unsigned mxcsr;
};
static const struct control_case k_controls[] = {
    {"control/default", 0x1f80},      {"control/flush_to_zero", 0x9f80},       {"control/denormals_are_zero", 0x1fc0},
    {"control/both", 0x9fc0},         {"control/round_down", 0x3f80},          {"control/round_up", 0x5f80},
    {"control/truncate", 0x7f80},     {"control/exceptions_unmasked", 0x0000}, {"control/everything", 0xe040},
    {"control/flags_raised", 0x1fbf},
};

#endif /* SHD_TESTS_SUPPORT_CONTROL_H */
