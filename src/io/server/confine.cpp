// SPDX-License-Identifier: MIT
#include "io/server/confine.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace shd::io {

namespace {

void set_limit(decltype(RLIMIT_CPU) resource, uint64_t value) {
  const rlimit limit = {value, value};
  (void)::setrlimit(resource, &limit);
}

/// Sanitizers reserve more address space than any limit would leave.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
void limit_memory(uint64_t) {}
#else
/// Address space in use at this moment, by the libraries of the decoders [bytes].
uint64_t address_space() {
  unsigned long long pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%llu", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return pages * static_cast<uint64_t>(::sysconf(_SC_PAGESIZE));
}

void limit_memory(uint64_t bytes) {
  const uint64_t used = address_space();
  if (used > 0) set_limit(RLIMIT_AS, used + bytes);
}
#endif

void limit_time(double seconds) {
  const auto whole = static_cast<uint64_t>(std::ceil(std::clamp(seconds, 0.0, 1e8))) + 1;
  set_limit(RLIMIT_CPU, whole);
  itimerval timer = {};
  timer.it_value.tv_sec = static_cast<time_t>(whole + 1);
  (void)::setitimer(ITIMER_REAL, &timer, nullptr);
}

}  // namespace

void confine(const Confinement& limits) {
  set_limit(RLIMIT_CORE, 0);
  set_limit(RLIMIT_FSIZE, limits.file_bytes);
  limit_time(limits.seconds);
  limit_memory(limits.memory);
  (void)::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
}

}  // namespace shd::io
