// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <string>

#include "io/limits.h"

namespace shd::io {

/// A child process with `socket` as its descriptor 0, /dev/null as 1 and 2, no other descriptor, an empty signal mask
/// and default signal handlers. The destructor kills and reaps the process if it still runs.
class ChildProcess {
 public:
  /// Throws Failure; SHD_ERROR_NOT_FOUND if the program is missing.
  ChildProcess(const std::string& program, int socket);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Waits for the end of the process, and kills it at the deadline. Returns a description of how it ended.
  std::string finish(const Deadline& deadline);
  /// Kills and reaps the process if it still runs.
  void kill();

 private:
  pid_t pid_ = -1;
};

}  // namespace shd::io
