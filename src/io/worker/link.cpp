// SPDX-License-Identifier: MIT
// The state of the one worker that a process has. It is constant-initialised and never destroyed, so that loads of
// other threads may run during exit().
#include "io/worker/link.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/syscall.h>
#endif

#include <cerrno>
#include <mutex>
#include <new>

#include "core/failure.h"
#include "core/fork.h"
#include "io/file/printable.h"
#include "io/worker/child_process.h"
#include "io/worker/packet.h"
#include "io/worker/protocol.h"

namespace shd::io {

namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kStartLimit = std::chrono::seconds(30);
constexpr auto kSilenceLimit = std::chrono::seconds(2);

struct Worker {
  std::timed_mutex mutex;
  core::StaticForkHook in_child;
  pid_t owner = 0;    // process that started the worker
  pid_t starter = 0;  // our child, which forks the worker and ends; 0 once it is reaped
  int socket = -1;
  // Identity of the socket when it was made: the host may close it, and its number may become a file of the host.
  dev_t socket_device = 0;
  ino_t socket_inode = 0;
  bool ready = false;
  bool silent = false;
  uint64_t generation = 0;
  Clock::time_point started = {};       // when the start began
  Clock::time_point silent_since = {};  // when the first request without an answer was sent
  char program[4096] = {};
};

Worker g_worker;

/// Whether the descriptor is still the socket that start() made.
bool has_socket() {
  struct stat status;
  return g_worker.socket >= 0 && ::fstat(g_worker.socket, &status) == 0 && status.st_dev == g_worker.socket_device &&
         status.st_ino == g_worker.socket_inode;
}

void close_socket() {
  if (has_socket()) ::close(g_worker.socket);
  g_worker.socket = -1;
  g_worker.ready = g_worker.silent = false;
}

/// A forked child has no worker: the one of its parent stays with the parent. The mutex is made anew: another
/// thread of the parent may have locked it, and that thread does not exist in the child.
void forget_after_fork(void*) noexcept {
  ::new (&g_worker.mutex) std::timed_mutex;
  close_socket();
  g_worker.starter = 0;
}

/// Kills the worker by the descriptor of its process. That descriptor comes with the first message of the worker, which
/// stays in the socket: unlike sockets, stored descriptors of processes all have one inode in older kernels.
void kill_worker() {
#if defined(__linux__) && defined(SYS_pidfd_send_signal)
  WorkerHello hello;
  FileDescriptor process;
  if (!has_socket()) return;
  (void)peek_packet(g_worker.socket, &hello, sizeof hello, &process, 1, Deadline(0.001));
  if (process.fd >= 0) (void)::syscall(SYS_pidfd_send_signal, process.fd, SIGKILL, nullptr, 0);
#endif
}

/// A worker whose socket is closed ends by itself when its last load has ended.
void stop(bool at_once) {
  if (at_once) kill_worker();
  close_socket();
  kill_process(g_worker.starter);
  g_worker.starter = 0;
}

/// Runs when this library is unloaded and when the process exits.
__attribute__((destructor)) void stop_at_unload() {
  if (g_worker.owner != ::getpid() || !g_worker.mutex.try_lock()) return;
  stop(false);
  g_worker.mutex.unlock();
}

class Lock {
 public:
  explicit Lock(const Deadline& deadline) {
    held_ = g_worker.mutex.try_lock_for(std::chrono::milliseconds(deadline.milliseconds_left()));
  }
  ~Lock() {
    if (held_) g_worker.mutex.unlock();
  }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;
  bool held() const { return held_; }

 private:
  bool held_;
};

void start(const std::string& program) {
  if (program.size() >= sizeof g_worker.program) refuse_errno("cannot run", program.c_str(), ENAMETOOLONG);
  g_worker.in_child.attach(forget_after_fork, nullptr);
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) {
    refuse_errno("cannot connect to", program.c_str(), errno);
  }
  struct stat status = {};
  (void)::fstat(ends[0], &status);
  g_worker.socket = ends[0];
  g_worker.socket_device = status.st_dev;
  g_worker.socket_inode = status.st_ino;
  const FileDescriptor theirs(ends[1]);
  g_worker.owner = ::getpid();
  try {
    g_worker.starter = start_process(program, theirs.fd);
  } catch (...) {
    close_socket();
    throw;
  }
  program.copy(g_worker.program, program.size());
  g_worker.program[program.size()] = 0;
  g_worker.started = Clock::now();
  ++g_worker.generation;
}

/// Waits for the first message of the worker.
void await_hello(const Deadline& deadline) {
  WorkerHello hello = {};
  const Stream stream = peek_packet(g_worker.socket, &hello, sizeof hello, nullptr, 0, deadline);
  const std::string name = printable(g_worker.program);
  if (stream == Stream::kLate) {
    if (Clock::now() - g_worker.started > kStartLimit) stop(true);
    deadline.check();
  }
  if (stream != Stream::kDone) {
    const std::string end = finish_process(std::exchange(g_worker.starter, 0));
    stop(true);
    core::refuse(SHD_ERROR_INTERNAL,
                 "the worker \"%s\" did not start (%s); a load with SHD_LOAD_IN_PROCESS needs no worker", name.c_str(),
                 end.c_str());
  }
  if (hello.magic != kWorkerMagic) {
    stop(true);
    core::refuse(SHD_ERROR_INTERNAL, "the worker \"%s\" belongs to another version of shd", name.c_str());
  }
  if (hello.error) {
    stop(true);
    refuse_errno("cannot start", g_worker.program, hello.error);
  }
  g_worker.ready = true;
  kill_process(std::exchange(g_worker.starter, 0));  // it has nothing left to do
}

}  // namespace

WorkerLink connect_worker(const std::string& program, const Deadline& deadline) {
  const Lock lock(deadline);
  if (!lock.held()) {
    deadline.check();
    core::refuse(SHD_ERROR_LIMIT, "another thread still starts the worker");
  }
  if (g_worker.socket >= 0 && g_worker.owner != ::getpid()) {  // fork handlers do not run for a raw clone()
    close_socket();
    g_worker.starter = 0;
  }
  if (g_worker.socket >= 0 && !has_socket()) stop(false);  // closed by the host, and so the worker ends
  if (g_worker.socket >= 0 && program != g_worker.program) stop(!g_worker.ready);
  if (g_worker.socket < 0) start(program);
  if (!g_worker.ready) await_hello(deadline);
  WorkerLink link = {FileDescriptor(::fcntl(g_worker.socket, F_DUPFD_CLOEXEC, 3)), g_worker.generation};
  if (link.socket.fd < 0) refuse_errno("cannot connect to", g_worker.program, errno);
  return link;
}

void drop_worker(const WorkerLink& link, const Deadline& deadline) {
  const Lock lock(deadline);
  if (lock.held() && g_worker.generation == link.generation) stop(true);
}

void worker_answered(const WorkerLink& link, const Deadline& deadline) {
  const Lock lock(deadline);
  if (lock.held() && g_worker.generation == link.generation) g_worker.silent = false;
}

void worker_silent(const WorkerLink& link, Clock::time_point since) {
  const Lock lock{Deadline(0.1)};
  if (!lock.held() || g_worker.generation != link.generation) return;
  if (!g_worker.silent) g_worker.silent_since = since;
  g_worker.silent = true;
  if (Clock::now() - g_worker.silent_since >= kSilenceLimit) stop(true);
}

}  // namespace shd::io
