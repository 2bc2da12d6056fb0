/* SPDX-License-Identifier: MIT */
/* Random numbers for tests in C, equal on every machine; C++ has support/random.h. */
#ifndef SHD_TESTS_SUPPORT_NOISE_H
#define SHD_TESTS_SUPPORT_NOISE_H

#include <stdint.h>

/** The next state: Knuth's linear congruential generator (TAOCP 2, 3.3.4). Its high bits are the random ones. */
static inline uint32_t shd_noise(uint32_t *state) { return *state = *state * 1664525u + 1013904223u; }

#endif /* SHD_TESTS_SUPPORT_NOISE_H */
