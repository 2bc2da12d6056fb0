// SPDX-License-Identifier: MIT
#include "io/worker/packet.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace shd::io {

namespace {

#ifndef MSG_CMSG_CLOEXEC
#define MSG_CMSG_CLOEXEC 0
#endif
#ifndef MSG_NOSIGNAL
#define MSG_NOSIGNAL 0
#endif

/// Room for the control data of a packet.
union ControlData {
  cmsghdr header;
  char bytes[CMSG_SPACE(kMaxDescriptors * sizeof(int))];
};

bool again(ssize_t result) {
  return result < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
}

/// Waits until the descriptor is ready for `events`, or the other end is closed.
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

/// Takes the descriptors of a received packet; closes those beyond `count`.
void take_descriptors(msghdr* message, FileDescriptor* descriptors, int count) {
  int taken = 0;
  for (cmsghdr* part = CMSG_FIRSTHDR(message); part; part = CMSG_NXTHDR(message, part)) {
    if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != SCM_RIGHTS) continue;
    const size_t number = (part->cmsg_len - CMSG_LEN(0)) / sizeof(int);
    for (size_t i = 0; i < number; ++i) {
      int fd;
      std::memcpy(&fd, CMSG_DATA(part) + i * sizeof fd, sizeof fd);
      FileDescriptor owned(fd);
      if (taken < count) descriptors[taken++] = std::move(owned);
    }
  }
}

Stream receive(int socket, void* bytes, size_t size, FileDescriptor* descriptors, int count, const Deadline& deadline,
               int flags) {
  while (true) {
    const Stream ready = wait_ready(socket, POLLIN, deadline);
    if (ready != Stream::kDone) return ready;
    iovec part = {bytes, size};
    ControlData control = {};
    msghdr message = {};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = &control;
    message.msg_controllen = sizeof control;
    const ssize_t got = ::recvmsg(socket, &message, MSG_DONTWAIT | MSG_CMSG_CLOEXEC | flags);
    if (again(got)) continue;
    if (got >= 0) take_descriptors(&message, descriptors, count);
    const bool whole = got == static_cast<ssize_t>(size) && !(message.msg_flags & (MSG_TRUNC | MSG_CTRUNC));
    return whole ? Stream::kDone : Stream::kClosed;
  }
}

}  // namespace

Stream send_packet(int socket, const void* bytes, size_t size, const int* descriptors, int count,
                   const Deadline& deadline) {
  iovec part = {const_cast<void*>(bytes), size};
  ControlData control = {};
  msghdr message = {};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  if (count > 0) {
    const size_t length = static_cast<size_t>(count) * sizeof(int);
    message.msg_control = &control;
    message.msg_controllen = CMSG_SPACE(length);
    control.header.cmsg_level = SOL_SOCKET;
    control.header.cmsg_type = SCM_RIGHTS;
    control.header.cmsg_len = CMSG_LEN(length);
    std::memcpy(CMSG_DATA(&control.header), descriptors, length);
  }
  while (true) {
    const Stream ready = wait_ready(socket, POLLOUT, deadline);
    if (ready != Stream::kDone) return ready;
    const ssize_t put = ::sendmsg(socket, &message, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (again(put)) continue;
    return put == static_cast<ssize_t>(size) ? Stream::kDone : Stream::kClosed;
  }
}

Stream receive_packet(int socket, void* bytes, size_t size, FileDescriptor* descriptors, int count,
                      const Deadline& deadline) {
  return receive(socket, bytes, size, descriptors, count, deadline, 0);
}

Stream peek_packet(int socket, void* bytes, size_t size, FileDescriptor* descriptors, int count,
                   const Deadline& deadline) {
  return receive(socket, bytes, size, descriptors, count, deadline, MSG_PEEK);
}

Stream send_all(int socket, const void* bytes, size_t size, const Deadline& deadline) {
  const auto* next = static_cast<const unsigned char*>(bytes);
  while (size > 0) {
    const Stream ready = wait_ready(socket, POLLOUT, deadline);
    if (ready != Stream::kDone) return ready;
    const ssize_t put = ::send(socket, next, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (again(put)) continue;
    if (put <= 0) return Stream::kClosed;
    next += put;
    size -= static_cast<size_t>(put);
  }
  return Stream::kDone;
}

Stream receive_all(int pipe, void* bytes, size_t size, const Deadline& deadline) {
  auto* next = static_cast<unsigned char*>(bytes);
  while (size > 0) {
    const Stream ready = wait_ready(pipe, POLLIN, deadline);
    if (ready != Stream::kDone) return ready;
    const ssize_t got = ::read(pipe, next, size);
    if (again(got)) continue;
    if (got <= 0) return Stream::kClosed;
    next += got;
    size -= static_cast<size_t>(got);
  }
  return Stream::kDone;
}

}  // namespace shd::io
