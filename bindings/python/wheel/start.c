// SPDX-License-Identifier: MIT
// Lets a program that is linked on a new system start with glibc 2.28; libraries do without this file. Since glibc 2.34
// the constructors of a program are called by glibc. Before, the program gave a function for it.
typedef void (*function)(int, char**, char**);
extern function __init_array_start[] __attribute__((visibility("hidden")));
extern function __init_array_end[] __attribute__((visibility("hidden")));

#if defined(__x86_64__)
#define FIRST "GLIBC_2.2.5"
#else
#define FIRST "GLIBC_2.17"
#endif

int first_start(int (*program)(int, char**, char**), int count, char** arguments, function init, void (*fini)(void),
                void (*unload)(void), void* stack);
__asm__(".symver first_start, __libc_start_main@" FIRST);

static void construct(int count, char** arguments, char** environment) {
  for (function* next = __init_array_start; next < __init_array_end; ++next) (*next)(count, arguments, environment);
}

__attribute__((visibility("hidden"))) int __libc_start_main(int (*program)(int, char**, char**), int count,
                                                            char** arguments, function init, void (*fini)(void),
                                                            void (*unload)(void), void* stack) {
  (void)init;
  return first_start(program, count, arguments, construct, fini, unload, stack);
}
