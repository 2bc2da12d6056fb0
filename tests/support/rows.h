/* SPDX-License-Identifier: MIT */
/* The cases of a test program: rows of tables whose first member is the name, and single cases. */
#ifndef SHD_TESTS_SUPPORT_ROWS_H
#define SHD_TESTS_SUPPORT_ROWS_H

#include <stdlib.h>

#include "support/check.h"

enum { MAX_CASES = 200 };

static struct CMUnitTest g_tests[MAX_CASES];
static size_t g_count;

/** Adds one case; `state` is passed to its body. */
static inline void add(const char *name, CMUnitTestFunction body, const void *state)
{
    if (g_count < MAX_CASES) {
        const struct CMUnitTest test = {name, body, NULL, NULL, (void *)state};
        g_tests[g_count++] = test;
    } else {
        fprintf(stderr, "%s: more than %d cases\n", name, (int)MAX_CASES);
        exit(1);
    }
}

/** Adds every row of a table whose first member is `const char *name`. */
#define ADD_ROWS(rows, body)                                                         \
    do {                                                                             \
        size_t row_;                                                                 \
        for (row_ = 0; row_ < sizeof rows / sizeof rows[0]; ++row_) {                \
            add(*(const char *const *)(const void *)&rows[row_], body, &rows[row_]); \
        }                                                                            \
    } while (0)

#endif /* SHD_TESTS_SUPPORT_ROWS_H */
