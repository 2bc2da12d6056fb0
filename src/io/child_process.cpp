// SPDX-License-Identifier: MIT
#include "io/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "io/file_descriptor.h"

extern "C" char** environ;

namespace shd::io {

namespace {

/// The two option objects of posix_spawn.
struct SpawnOptions {
  posix_spawn_file_actions_t files;
  posix_spawnattr_t attributes;
  SpawnOptions() {
    if (::posix_spawn_file_actions_init(&files) != 0) throw std::bad_alloc();
    if (::posix_spawnattr_init(&attributes) != 0) {
      ::posix_spawn_file_actions_destroy(&files);
      throw std::bad_alloc();
    }
  }
  ~SpawnOptions() {
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&files);
  }
};

int fill_options(SpawnOptions& options, int socket) {
  // Descriptor 0 comes first: the socket itself may be 1 or 2, which are replaced afterwards.
  int error = ::posix_spawn_file_actions_adddup2(&options.files, socket, 0);
  if (!error) error = ::posix_spawn_file_actions_addopen(&options.files, 1, "/dev/null", O_WRONLY, 0);
  if (!error) error = ::posix_spawn_file_actions_addopen(&options.files, 2, "/dev/null", O_WRONLY, 0);
#if defined(__GLIBC_PREREQ)
#if __GLIBC_PREREQ(2, 34)
  if (!error) error = ::posix_spawn_file_actions_addclosefrom_np(&options.files, 3);
#endif
#endif
  sigset_t none, all;
  ::sigemptyset(&none);
  ::sigfillset(&all);
  if (!error) error = ::posix_spawnattr_setsigmask(&options.attributes, &none);
  if (!error) error = ::posix_spawnattr_setsigdefault(&options.attributes, &all);
  if (!error) error = ::posix_spawnattr_setflags(&options.attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  return error;
}

}  // namespace

ChildProcess::ChildProcess(const std::string& program, int socket) {
  if (::access(program.c_str(), X_OK) != 0) refuse_errno("cannot run", program.c_str(), errno);
  SpawnOptions options;
  int error = fill_options(options, socket);
  char* arguments[] = {const_cast<char*>(program.c_str()), nullptr};
  pid_t pid = -1;
  if (!error) error = ::posix_spawn(&pid, program.c_str(), &options.files, &options.attributes, arguments, environ);
  if (error) refuse_errno("cannot run", program.c_str(), error);
  pid_ = pid;
}

ChildProcess::~ChildProcess() {
  kill();
}

void ChildProcess::kill() {
  if (pid_ <= 0) return;
  // Only a process that still runs is killed: the number of one that the host has reaped can belong to another process.
  if (::waitpid(pid_, nullptr, WNOHANG) == 0) {
    ::kill(pid_, SIGKILL);
    while (::waitpid(pid_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  pid_ = -1;
}

// A process can close its socket and still run, so that waiting without a limit could last forever. waitpid() has no
// timeout; the pauses between two calls grow from 1 to 16 ms.
std::string ChildProcess::finish(const Deadline& deadline) {
  if (pid_ <= 0) return "ended before";
  int status = 0;
  int pause = 1;
  pid_t got;
  while ((got = ::waitpid(pid_, &status, WNOHANG)) == 0 || (got < 0 && errno == EINTR)) {
    const int left = deadline.milliseconds_left();
    if (left == 0) {
      kill();
      return "killed at the deadline";
    }
    (void)::poll(nullptr, 0, std::min(left, pause));
    pause = std::min(2 * pause, 16);
  }
  pid_ = -1;
  if (got < 0) return "reaped by the host";  // SIGCHLD is ignored, or waitpid(-1) was called elsewhere
  if (WIFSIGNALED(status)) return "signal " + std::to_string(WTERMSIG(status));
  return "exit status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace shd::io
