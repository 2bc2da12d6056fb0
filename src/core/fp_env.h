// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#if defined(__SSE__) || defined(_M_X64)
#include <xmmintrin.h>
#endif

namespace shd::core {

/// Sets the IEEE 754 defaults (round to nearest, no flush-to-zero, all exceptions masked) for the duration of a scope,
/// and restores the host's control and status bits at its end.
class FpScope {
 public:
#if defined(__SSE__) || defined(_M_X64)
  FpScope() : saved_(_mm_getcsr()) {
    _mm_setcsr(0x1f80);
  }
  ~FpScope() {
    _mm_setcsr(saved_);
  }

 private:
  uint32_t saved_;
#elif defined(__aarch64__)
  FpScope() {
    __asm__ volatile("mrs %0, fpcr" : "=r"(saved_));
    __asm__ volatile("mrs %0, fpsr" : "=r"(status_));
    __asm__ volatile("msr fpcr, %0" : : "r"(uint64_t{0}));
  }
  ~FpScope() {
    __asm__ volatile("msr fpcr, %0" : : "r"(saved_));
    __asm__ volatile("msr fpsr, %0" : : "r"(status_));
  }

 private:
  uint64_t saved_, status_;
#else
  FpScope() {}
#endif
 public:
  FpScope(const FpScope&) = delete;
  FpScope& operator=(const FpScope&) = delete;
};

}  // namespace shd::core
