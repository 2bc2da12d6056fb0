// SPDX-License-Identifier: MIT
#ifdef __linux__
#include "io/worker/call.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>

#include "core/failure.h"
#include "io/file/printable.h"
#include "io/file/worker_path.h"
#include "io/worker/child_process.h"
#include "io/worker/link.h"

namespace shd::io {

namespace {

/// Size of the pipe for the reply, if the system grants it [bytes].
constexpr int kPipeSize = 1 << 20;

Ends connect(int type) {
  int ends[2];
  if (::socketpair(AF_UNIX, type | SOCK_CLOEXEC, 0, ends) != 0) refuse_errno("cannot make", "socket", errno);
  return {FileDescriptor(ends[0]), FileDescriptor(ends[1])};
}

Ends make_pipe() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) refuse_errno("cannot make", "pipe", errno);
  Ends out = {FileDescriptor(ends[0]), FileDescriptor(ends[1])};
  (void)::fcntl(out.ours.fd, F_SETPIPE_SZ, kPipeSize);
  if (::fcntl(out.ours.fd, F_SETFL, O_NONBLOCK) != 0) refuse_errno("cannot make", "pipe", errno);
  return out;
}

/// A path as it is at this moment: the working directory can change before another load names it.
std::string absolute_path(const char* path) {
  std::error_code error;
  const std::string absolute = std::filesystem::absolute(path, error).string();
  if (error) refuse_errno("cannot find", path, error.value());
  return absolute;
}

/// Hands the request to the worker. Returns false if the worker is dead and has not taken it.
bool hand_over(const WorkerLink& link, Channel& channel, int file, const WorkerRequest& request,
               const Deadline& deadline) {
  const auto since = std::chrono::steady_clock::now();
  const int input = file < 0 ? channel.input.theirs.fd : file;
  const int handed[kMaxDescriptors] = {channel.control.theirs.fd, channel.data.theirs.fd, input};
  WorkerStarted started = {};
  Stream stream = send_packet(link.socket.fd, &request, sizeof request, handed, kMaxDescriptors, deadline);
  for (Ends* ends : {&channel.control, &channel.data, &channel.input}) ends->theirs.reset();
  if (stream == Stream::kDone) {
    stream = receive_packet(channel.control.ours.fd, &started, sizeof started, nullptr, 0, deadline);
  }
  if (stream == Stream::kClosed) return false;
  if (stream == Stream::kLate) {
    worker_silent(link, since);
    deadline.check();
  }
  worker_answered(link, deadline);
  if (started.error) refuse_errno("cannot start", "a child of the worker", started.error);
  return true;
}

}  // namespace

Channel::Channel(int input_type) : control(connect(SOCK_SEQPACKET)), data(make_pipe()) {
  if (input_type) input = connect(input_type);
}

Channel::~Channel() {
  if (control.ours.fd >= 0) ::shutdown(control.ours.fd, SHUT_RDWR);
}

Channel begin_call(const char* worker_path, const WorkerRequest& request, int file, int input_type,
                   const Deadline& deadline) {
  const std::string program = worker_path ? absolute_path(worker_path) : default_worker_path();
  // A worker that has died since the last request is replaced, once.
  for (int attempt = 0; attempt < 2; ++attempt) {
    Channel channel(input_type);
    const WorkerLink link = connect_worker(program, deadline);
    if (hand_over(link, channel, file, request, deadline)) return channel;
    drop_worker(link, deadline);
  }
  core::refuse(SHD_ERROR_INTERNAL, "the worker \"%s\" ends when it gets a file", printable(program.c_str()).c_str());
}

void require_done(Stream stream, const Channel& channel, const Deadline& deadline) {
  if (stream == Stream::kDone) return;
  WorkerEnded ended = {};
  std::string end = "no reply";
  // A child that closes its pipe and lives is killed when the channel is closed.
  const Deadline moment(std::min(0.25, deadline.seconds_left()));
  if (receive_packet(channel.control.ours.fd, &ended, sizeof ended, nullptr, 0, moment) == Stream::kDone) {
    end = describe_status(ended.status);
  }
  deadline.check();
  core::refuse(SHD_ERROR_CORRUPT, "the decoder died on the file (%s)", end.c_str());
}

}  // namespace shd::io
#endif
