/* SPDX-License-Identifier: MIT */
/* The part of cmocka that api.determinism uses, for machines without its library: the first failure ends the program.
 */
#ifndef SHD_TESTS_ARM_CMOCKA_H
#define SHD_TESTS_ARM_CMOCKA_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define print_message printf
#define fail_msg(...) (fprintf(stderr, "%s:%d: ", __FILE__, __LINE__), fprintf(stderr, __VA_ARGS__), abort())
#define assert_true(condition) ((condition) ? (void)0 : (void)fail_msg("%s\n", #condition))
#define assert_null(pointer) assert_true((pointer) == NULL)
#define assert_non_null(pointer) assert_true((pointer) != NULL)
#define assert_int_equal(a, b) assert_true((a) == (b))
#define assert_memory_equal(a, b, size) assert_true(memcmp(a, b, size) == 0)
#define skip() return

struct CMUnitTest {
  const char* name;
  void (*body)(void** state);
  void *setup, *teardown, *state;
};

static inline int _cmocka_run_group_tests(const char* group, const struct CMUnitTest* tests, size_t count, void* setup,
                                          void* teardown) {
  size_t i;
  (void)setup;
  (void)teardown;
  for (i = 0; i < count; ++i) {
    void* state = tests[i].state;
    printf("%s: %s\n", group, tests[i].name);
    tests[i].body(&state);
  }
  return 0;
}

#endif /* SHD_TESTS_ARM_CMOCKA_H */
