// SPDX-License-Identifier: MIT
// shd-io-worker: a fork server, started once by a process that loads files. It sets up OpenImageIO and forks a child
// for every file. So each file is decoded in a copy of one clean process, and starting costs a fork only.
#include <dirent.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "io/codec/codec.h"
#include "io/server/job.h"

namespace {

/// The threads of this process.
struct Threads {
  int count = 0;
  bool idle = true;  // all except the first one sleep
};

bool sleeps(const std::string& thread) {
  char text[256] = "";
  std::FILE* file = std::fopen(("/proc/self/task/" + thread + "/stat").c_str(), "r");
  if (!file) return true;  // it has just ended
  (void)!std::fread(text, 1, sizeof text - 1, file);
  std::fclose(file);
  const char* name_end = std::strrchr(text, ')');
  return !name_end || std::strncmp(name_end, ") S", 3) == 0;
}

Threads look_at_threads() {
  Threads threads;
  DIR* folder = ::opendir("/proc/self/task");
  if (!folder) return threads;
  while (const dirent* entry = ::readdir(folder)) {
    const int thread = std::atoi(entry->d_name);
    if (thread <= 0) continue;
    ++threads.count;
    if (thread != ::getpid()) threads.idle = threads.idle && sleeps(entry->d_name);
  }
  ::closedir(folder);
  return threads;
}

/// Waits until a fork is safe: if another thread holds a lock at the fork, the lock stays held in every child.
/// OpenImageIO starts a thread for its pool and ends it some time after the pool is disabled; until then the thread
/// takes locks of the pool. The `expected` other threads belong to libraries under OpenImageIO. They hold no lock while
/// they sleep.
void await_idle_threads(int expected) {
  for (int quiet = 0, tries = 0; quiet < 3 && tries < 1000; ++tries) {
    const Threads threads = look_at_threads();
    quiet = threads.idle && threads.count <= expected ? quiet + 1 : 0;
    ::usleep(1000);
  }
}

/// Closes what the host left open, for hosts whose glibc has no function for it.
void close_inherited() {
  DIR* folder = ::opendir("/proc/self/fd");
  if (!folder) return;
  std::vector<int> open;
  while (const dirent* entry = ::readdir(folder)) open.push_back(std::atoi(entry->d_name));
  ::closedir(folder);
  for (const int descriptor : open) {
    if (descriptor > 2) ::close(descriptor);
  }
}

}  // namespace

int main() {
  try {
    close_inherited();
    const int threads = look_at_threads().count;
    shd::io::prepare_process();
    await_idle_threads(threads);
  } catch (...) {
    _exit(4);
  }
  // The host must not have a lasting child, because it may wait for all its children.
  const pid_t pid = ::fork();
  if (pid != 0) _exit(pid > 0 ? 0 : 5);
  (void)::prctl(PR_SET_NAME, "shd-io-worker");
  (void)::setsid();  // signals of the host's terminal do not reach the worker
  (void)!::chdir("/");
  // Destructors are skipped, because the decoders' libraries take longer to unload than to decode.
  _exit(shd::io::serve());
}
