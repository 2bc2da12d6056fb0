// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace shd::io {

/// The budget of a process that decodes an untrusted file.
struct Confinement {
  uint64_t memory;      // in addition to what the process uses at this moment [bytes]
  uint64_t file_bytes;  // largest file that it may write
  double seconds;       // time, and time of a processor
};

/// Limits this process by the operating system, for good: memory, files, time, no core dump, no new privileges.
void confine(const Confinement& limits);

}  // namespace shd::io
