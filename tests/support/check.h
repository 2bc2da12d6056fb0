/* SPDX-License-Identifier: MIT */
/* Common base of all tests: cmocka with its prerequisites, and comparisons that treat NaN as a value. */
#ifndef SHD_TESTS_SUPPORT_CHECK_H
#define SHD_TESTS_SUPPORT_CHECK_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif
#include <cmocka.h>
#ifdef __cplusplus
}
#endif

#include <shd/result.h>

/* An oracle that takes most of a test's time checks one result in this many. It is code of the test alone, so a
   sanitizer learns nothing from it; the library computes every result, and without a sanitizer all are checked. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
enum { SHD_IS_SANITIZED = 1, SHD_ORACLE_STRIDE = 7 };
#else
enum { SHD_IS_SANITIZED = 0, SHD_ORACLE_STRIDE = 1 };
#endif

/** `|got - want| <= abs_tol + rel_tol * |want|`. NaN matches only NaN; infinities only themselves. */
static inline int shd_is_close(double got, double want, double abs_tol, double rel_tol)
{
    if (isnan(want)) return isnan(got);
    if (isinf(want)) return got == want;
    return fabs(got - want) <= abs_tol + rel_tol * fabs(want); /* false for NaN got */
}

/** Fails with both numbers, `what` and the index unless `got` is close to `want`. */
static inline void shd_assert_close(const char *what, size_t index, double got, double want, double abs_tol,
                                    double rel_tol)
{
    if (!shd_is_close(got, want, abs_tol, rel_tol)) {
        fail_msg("%s[%zu]: got %.9g, want %.9g (abs %g, rel %g)", what, index, got, want, abs_tol, rel_tol);
    }
}

/** Fails unless result is `want`; if `want` is an error, the error text must contain `message`. */
static inline void shd_assert_result(const char *what, shd_result result, shd_result want, const char *message)
{
    if (result != want) {
        fail_msg("%s: got %s (%s), want %s", what, shd_result_name(result), shd_last_error(), shd_result_name(want));
    }
    if (want != SHD_OK && message && !strstr(shd_last_error(), message)) {
        fail_msg("%s: text \"%s\" lacks \"%s\"", what, shd_last_error(), message);
    }
}

/** Fails unless the call succeeds. */
#define shd_assert_ok(call) shd_assert_result(#call, (call), SHD_OK, "")

/** FNV-1a hash of bytes (Fowler, Noll, Vo), for comparing whole outputs; start with SHD_HASH_START. */
#define SHD_HASH_START 0xcbf29ce484222325ull
static inline uint64_t shd_hash(uint64_t hash, const void *data, size_t size)
{
    const unsigned char *bytes = (const unsigned char *)data;
    size_t i;
    for (i = 0; i < size; ++i) hash = (hash ^ bytes[i]) * 0x100000001b3ull;
    return hash;
}

#endif /* SHD_TESTS_SUPPORT_CHECK_H */
