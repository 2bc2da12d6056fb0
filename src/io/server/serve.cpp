// SPDX-License-Identifier: MIT
// The loop of the fork server. It reads nothing that a child or a file has written. It allocates no heap memory, so
// that every child starts with the same heap, except for modules, each of which it opens once.
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <utility>

#include "io/server/job.h"
#include "io/server/module.h"
#include "io/worker/packet.h"

namespace shd::io {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kHost = 0;  // descriptor of the socket to the host
constexpr int kMaxJobs = 512;

// Times until the next spare child is forked [ms]. A fork takes 3 ms of a processor. A load keeps one busy with the
// child, and a third of another one with the host. If there is no third one, the fork waits until the child has ended
// and the kernel has cleared its memory, but not longer for a slow child.
constexpr int kAfterStart = 1;
constexpr int kAfterStartOfTwo = 20;
constexpr int kAfterEnd = 1;

/// A child that runs, and the descriptor that its host listens on; -1 once the child has been killed.
struct Job {
  pid_t pid;
  int control;
  Clock::time_point end;
};

/// The child that waits for the next file: a fork takes longer than decoding a small file.
struct Spare {
  pid_t pid = -1;
  int socket = -1;
};

struct Server {
  Job jobs[kMaxJobs];
  int count = 0;
  Spare spare;
  bool spare_due = false;  // the last spare child has got a file, and no other has been forked
  Clock::time_point spare_time = {};
  std::chrono::milliseconds after_start{kAfterStart};
  int signals = -1;
  bool host = true;  // the host may still send requests
};

Server g_server;
pollfd g_polls[2 + kMaxJobs];

const Deadline& no_deadline() {
  static const Deadline deadline(1e9);
  return deadline;
}

/// Never waits: a host that does not read must not stop the server.
template <class Message>
void tell(int socket, const Message& message) {
  (void)::send(socket, &message, sizeof message, MSG_NOSIGNAL | MSG_DONTWAIT);
}

void say_hello() {
  const WorkerHello hello = {kWorkerMagic, 0};
#ifdef SYS_pidfd_open
  const FileDescriptor self(static_cast<int>(::syscall(SYS_pidfd_open, ::getpid(), 0)));
#else
  const FileDescriptor self;
#endif
  (void)send_packet(kHost, &hello, sizeof hello, &self.fd, self.fd >= 0 ? 1 : 0, no_deadline());
}

/// Runs in a forked child: closes what belongs to the server, and waits for a file. The first lines make the child end
/// with the server: until then, a child that is stopped would outlive it and keep the files of a load open.
[[noreturn]] void enter_child(int socket, pid_t server) {
  (void)::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != server) _exit(2);  // the server died before the line above
  for (int i = 0; i < g_server.count; ++i) {
    if (g_server.jobs[i].control >= 0) ::close(g_server.jobs[i].control);
  }
  ::close(g_server.signals);
  ::close(kHost);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  run_job(socket);
}

/// Forks a spare child. Returns errno or 0.
int make_spare() {
  g_server.spare_due = false;
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) return errno;
  FileDescriptor ours(ends[0]);
  FileDescriptor theirs(ends[1]);
  const pid_t server = ::getpid();
  const pid_t pid = ::fork();
  if (pid < 0) return errno;
  if (pid == 0) {
    ours.reset();
    enter_child(theirs.fd, server);
  }
  g_server.spare = {pid, std::exchange(ours.fd, -1)};
  return 0;
}

void drop_spare() {
  if (g_server.spare.socket >= 0) ::close(g_server.spare.socket);
  g_server.spare = {};
}

Clock::time_point end_of(const WorkerRequest& request) {
  const double seconds = std::clamp(request.limits.seconds, 0.0, 1e8) + 1;
  return Clock::now() + std::chrono::milliseconds(static_cast<int64_t>(seconds * 1000));
}

/// Hands a file to the spare child, which becomes a job. Returns errno or 0.
int start_job(const WorkerRequest& request, FileDescriptor& control, const int* data_and_file) {
  if (g_server.count == kMaxJobs) return EAGAIN;
  for (int attempt = 0; attempt < 2; ++attempt) {
    if (g_server.spare.pid < 0) {
      if (const int error = make_spare()) return error;
    }
    const Stream sent = send_packet(g_server.spare.socket, &request, sizeof request, data_and_file, 2, no_deadline());
    if (sent == Stream::kDone) {
      g_server.jobs[g_server.count++] = {g_server.spare.pid, std::exchange(control.fd, -1), end_of(request)};
      drop_spare();
      g_server.spare_due = true;
      g_server.spare_time = Clock::now() + g_server.after_start;
      return 0;
    }
    drop_spare();
  }
  return ECHILD;
}

void read_request() {
  WorkerRequest request = {};
  FileDescriptor handed[kMaxDescriptors];
  const Stream stream = receive_packet(kHost, &request, sizeof request, handed, kMaxDescriptors, no_deadline());
  const bool whole = stream == Stream::kDone && request.magic == kWorkerMagic && handed[2].fd >= 0;
  if (whole) {
    const int control = handed[0].fd;
    const int data_and_file[2] = {handed[1].fd, handed[2].fd};
    if (names_module(request) && open_for_children(request)) drop_spare();  // it was forked without the module
    const WorkerStarted started = {start_job(request, handed[0], data_and_file)};
    tell(control, started);
    handed[1].reset();
    handed[2].reset();
  } else if (handed[0].fd < 0) {
    g_server.host = false;  // closed, or not a host of this version
  }
}

void kill_job(Job& job) {
  ::kill(job.pid, SIGKILL);
  if (job.control >= 0) ::close(job.control);
  job.control = -1;
}

void reap() {
  signalfd_siginfo ignored;
  while (::read(g_server.signals, &ignored, sizeof ignored) > 0) {
  }
  int status = 0;
  for (pid_t pid; (pid = ::waitpid(-1, &status, WNOHANG)) > 0;) {
    Job* const end = g_server.jobs + g_server.count;
    Job* const job = std::find_if(g_server.jobs, end, [&](const Job& row) { return row.pid == pid; });
    if (pid == g_server.spare.pid) drop_spare();
    if (job == end) continue;
    if (job->control >= 0) {
      tell(job->control, WorkerEnded{status});
      ::close(job->control);
    }
    *job = end[-1];
    --g_server.count;
    g_server.spare_time = std::min(g_server.spare_time, Clock::now() + std::chrono::milliseconds(kAfterEnd));
  }
}

/// Number of processors that this process may use.
int count_processors() {
  cpu_set_t set;
  return ::sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

/// Time from now until `end`, rounded up [ms].
int64_t milliseconds_until(Clock::time_point end, Clock::time_point now) {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - now).count();
  return std::clamp<int64_t>(left + 1, 0, 1 << 30);
}

/// Returns the number of jobs that were polled.
int wait_for_events() {
  const Clock::time_point now = Clock::now();
  int64_t timeout = g_server.spare_due ? milliseconds_until(g_server.spare_time, now) : -1;
  g_polls[0] = {g_server.host ? kHost : -1, POLLIN, 0};
  g_polls[1] = {g_server.signals, POLLIN, 0};
  for (int i = 0; i < g_server.count; ++i) {
    const Job& job = g_server.jobs[i];
    g_polls[2 + i] = {job.control, POLLIN, 0};
    if (job.control < 0) continue;
    const int64_t wait = milliseconds_until(job.end, now);
    timeout = timeout < 0 ? wait : std::min(timeout, wait);
  }
  const int polled = g_server.count;
  if (::poll(g_polls, static_cast<nfds_t>(2 + polled), static_cast<int>(timeout)) < 0) {
    for (int i = 0; i < 2 + polled; ++i) g_polls[i].revents = 0;
  }
  return polled;
}

/// Kills the jobs that are late or whose host has gone: it sends nothing.
void check_jobs(int polled) {
  const Clock::time_point now = Clock::now();
  for (int i = 0; i < polled; ++i) {
    Job& job = g_server.jobs[i];
    if (job.control >= 0 && (g_polls[2 + i].revents != 0 || now >= job.end)) kill_job(job);
  }
}

}  // namespace

int serve() {
  sigset_t children;
  ::sigemptyset(&children);
  ::sigaddset(&children, SIGCHLD);
  ::sigprocmask(SIG_BLOCK, &children, nullptr);
  g_server.signals = ::signalfd(-1, &children, SFD_CLOEXEC | SFD_NONBLOCK);
  if (g_server.signals < 0) return 6;
  (void)no_deadline();
  if (count_processors() <= 2) g_server.after_start = std::chrono::milliseconds(kAfterStartOfTwo);
  (void)make_spare();
  say_hello();
  while (g_server.host || g_server.count > 0) {
    check_jobs(wait_for_events());
    if (g_polls[1].revents) reap();
    if (g_polls[0].revents) read_request();
    if (g_server.spare_due && g_server.host && Clock::now() >= g_server.spare_time) (void)make_spare();
  }
  return 0;
}

}  // namespace shd::io
