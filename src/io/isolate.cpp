// SPDX-License-Identifier: MIT
#include "io/isolate.h"

#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "core/failure.h"
#include "io/child_process.h"
#include "io/file_descriptor.h"
#include "io/worker_path.h"
#include "io/worker_protocol.h"

namespace shd::io {

namespace {

/// Outcome of a transfer on the socket.
enum class Stream { kDone, kClosed, kLate };

/// Waits until the socket is ready for `events`.
Stream wait_ready(int fd, short events, const Deadline& deadline) {
  while (true) {
    const int left = deadline.milliseconds_left();
    if (left == 0) return Stream::kLate;
    pollfd item = {fd, events, 0};
    const int count = ::poll(&item, 1, left);
    if (count > 0) return Stream::kDone;
    if (count < 0 && errno != EINTR) return Stream::kClosed;
  }
}

bool again(ssize_t result) {
  return result < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
}

Stream send_all(int fd, const void* bytes, size_t size, const Deadline& deadline) {
  const auto* next = static_cast<const unsigned char*>(bytes);
  while (size > 0) {
    const Stream ready = wait_ready(fd, POLLOUT, deadline);
    if (ready != Stream::kDone) return ready;
    const ssize_t put = ::send(fd, next, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (again(put)) continue;
    if (put <= 0) return Stream::kClosed;
    next += put;
    size -= static_cast<size_t>(put);
  }
  return Stream::kDone;
}

Stream receive_all(int fd, void* bytes, size_t size, const Deadline& deadline) {
  auto* next = static_cast<unsigned char*>(bytes);
  while (size > 0) {
    const Stream ready = wait_ready(fd, POLLIN, deadline);
    if (ready != Stream::kDone) return ready;
    const ssize_t got = ::recv(fd, next, size, MSG_DONTWAIT);
    if (again(got)) continue;
    if (got <= 0) return Stream::kClosed;
    next += got;
    size -= static_cast<size_t>(got);
  }
  return Stream::kDone;
}

/// Throws Failure unless a transfer is complete.
void require_done(Stream stream, ChildProcess& child, const Deadline& deadline) {
  if (stream == Stream::kDone) return;
  const std::string end = child.finish(deadline);
  deadline.check();
  core::refuse(SHD_ERROR_CORRUPT, "the decoder died on the file (%s)", end.c_str());
}

WorkerRequest make_request(const LoadOptions& options, size_t size) {
  WorkerRequest request = {};
  request.magic = kWorkerMagic;
  request.formats = options.formats;
  request.flags = options.flags;
  request.encoding = static_cast<uint32_t>(options.encoding);
  request.subimage = options.subimage;
  request.limits = options.limits;
  request.size = size;
  return request;
}

/// Checks every field of a reply, because the process that sent it has read hostile bytes. Returns the size of the
/// pixels.
size_t check_reply(WorkerReply& reply, const LoadOptions& options, size_t file_size) {
  reply.message[sizeof reply.message - 1] = 0;
  reply.color_space[sizeof reply.color_space - 1] = 0;
  if (reply.magic != kWorkerMagic || reply.code > SHD_ERROR_INTERNAL) {
    core::refuse(SHD_ERROR_INTERNAL, "the worker belongs to another version of shd");
  }
  if (reply.code != SHD_OK) core::refuse(static_cast<shd_result>(reply.code), "%s", reply.message);
  const size_t pixel = bitmap_pixel_size(static_cast<shd_format>(reply.format));
  if (pixel == 0) core::refuse(SHD_ERROR_INTERNAL, "the worker sent format %u", reply.format);
  check_extent(options.limits, "image", reply.width, reply.height);
  const size_t size = check_bytes(options.limits, reply.width, reply.height, pixel, file_size);
  if (size != reply.size) core::refuse(SHD_ERROR_INTERNAL, "the worker sent a wrong size");
  for (char* c = reply.color_space; *c; ++c) {
    if (*c < 0x20 || *c > 0x7e) *c = '?';
  }
  return size;
}

}  // namespace

Bitmap load_isolated(const char* worker_path, const unsigned char* bytes, size_t size, const LoadOptions& options,
                     const Memory& memory, const Deadline& deadline) {
  const std::string program = worker_path ? std::string(worker_path) : default_worker_path();
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    refuse_errno("cannot connect to", program.c_str(), errno);
  const FileDescriptor ours(ends[0]);
  FileDescriptor theirs(ends[1]);
  ChildProcess child(program, theirs.fd);
  theirs.reset();
  const WorkerRequest request = make_request(options, size);
  WorkerReply reply;
  Stream sent = send_all(ours.fd, &request, sizeof request, deadline);
  if (sent == Stream::kDone) sent = send_all(ours.fd, bytes, size, deadline);
  require_done(sent, child, deadline);
  require_done(receive_all(ours.fd, &reply, sizeof reply, deadline), child, deadline);
  const size_t pixels = check_reply(reply, options, size);
  Bitmap out;
  out.format = static_cast<shd_format>(reply.format);
  out.width = reply.width;
  out.height = reply.height;
  out.info = reply.info;
  std::memcpy(out.color_space, reply.color_space, sizeof out.color_space);
  out.pixels = Buffer(memory, pixels);
  require_done(receive_all(ours.fd, out.pixels.data(), pixels, deadline), child, deadline);
  child.kill();  // the result is complete, and nothing waits for an orderly end
  return out;
}

}  // namespace shd::io
