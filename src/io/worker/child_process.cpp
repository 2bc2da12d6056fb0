// SPDX-License-Identifier: MIT
#include "io/worker/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <new>
#include <vector>

#include "core/failure.h"
#include "io/file/file_descriptor.h"

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
#if __GLIBC_PREREQ(2, 29)
  if (!error) error = ::posix_spawn_file_actions_addchdir_np(&options.files, "/");
#endif
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

bool is_kept(const std::string& variable) {
  const std::string name = variable.substr(0, variable.find('='));
  const std::string sanitizer = "SAN_OPTIONS";
  const bool ends =
      name.size() > sanitizer.size() && name.compare(name.size() - sanitizer.size(), sanitizer.size(), sanitizer) == 0;
  return ends || name.compare(0, 3, "LD_") == 0;
}

/// The variables that the worker needs, and a null pointer. Others could hold secrets of the host, or settings of
/// OpenImageIO such as folders of plugins.
std::vector<char*> kept_environment() {
  std::vector<char*> kept;
  for (char** variable = environ; variable && *variable; ++variable) {
    if (is_kept(*variable)) kept.push_back(*variable);
  }
  kept.push_back(nullptr);
  return kept;
}

[[noreturn]] void refuse_start(const std::string& program, int error) {
  try {
    refuse_errno("cannot run", program.c_str(), error);
  } catch (const core::Failure& failure) {
    core::refuse(failure.code, "%s; a load with SHD_LOAD_IN_PROCESS needs no worker", failure.what());
  }
}

}  // namespace

pid_t start_process(const std::string& program, int socket, const char* argument) {
  if (::access(program.c_str(), X_OK) != 0) refuse_start(program, errno);
  std::vector<char*> environment = kept_environment();
  SpawnOptions options;
  int error = fill_options(options, socket);
  char* arguments[] = {const_cast<char*>(program.c_str()), const_cast<char*>(argument), nullptr};
  pid_t pid = -1;
  if (!error) {
    error = ::posix_spawn(&pid, program.c_str(), &options.files, &options.attributes, arguments, environment.data());
  }
  if (error) refuse_start(program, error);
  return pid;
}

void kill_process(pid_t pid) {
  if (pid <= 0) return;
  // Only a process that still runs is killed: the number of one that the host has reaped can belong to another process.
  if (::waitpid(pid, nullptr, WNOHANG) != 0) return;
  ::kill(pid, SIGKILL);
  while (::waitpid(pid, nullptr, 0) < 0 && errno == EINTR) {
  }
}

// A process can close its socket and still run, so that waiting without a limit could last forever. waitpid() has no
// timeout; the pauses between two calls grow from 1 to 64 ms.
std::string finish_process(pid_t pid) {
  if (pid <= 0) return "ended before";
  for (int pause = 1; pause <= 64; pause *= 2) {
    int status = 0;
    const pid_t got = ::waitpid(pid, &status, WNOHANG);
    if (got > 0) return describe_status(status);
    if (got < 0 && errno != EINTR)
      return "reaped by the host";  // SIGCHLD is ignored, or waitpid(-1) was called elsewhere
    (void)::poll(nullptr, 0, pause);
  }
  kill_process(pid);
  return "killed, because it did not end";
}

std::string describe_status(int status) {
  if (WIFSIGNALED(status)) return "signal " + std::to_string(WTERMSIG(status));
  return "exit status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace shd::io
