// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <string>

namespace shd::io {

/// Starts the program of an absolute path with `socket` as its descriptor 0, /dev/null as 1 and 2, no other descriptor,
/// an empty signal mask, default signal handlers, and no environment variable except those of the dynamic linker and of
/// sanitizers. Its working directory is /, so that a relative folder in LD_LIBRARY_PATH never names libraries of the
/// host's working directory. `argument` is its only argument, or null. Throws Failure; SHD_ERROR_NOT_FOUND if the
/// program is missing.
pid_t start_process(const std::string& program, int socket, const char* argument = nullptr);

/// Waits a moment for the end of a process that seems to end, then kills it. Returns a description of how it ended.
std::string finish_process(pid_t pid);

/// Kills and reaps a process if it still runs. The host may have reaped it.
void kill_process(pid_t pid);

/// Describes a status of waitpid().
std::string describe_status(int status);

}  // namespace shd::io
