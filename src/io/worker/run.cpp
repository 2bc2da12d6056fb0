// SPDX-License-Identifier: MIT
#ifdef __linux__
#include "io/worker/run.h"

#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/failure.h"
#include "core/printable.h"

namespace shd::io {

namespace {

constexpr uint32_t kMaxQuestions = 65536;
constexpr uint64_t kSmallPiece = uint64_t{1} << 17;  // read at once; the values in it have a few bytes each

/// A copy of bytes as a file, which the child reads while this process does something else.
FileDescriptor memory_file(const Given& given) {
  FileDescriptor file(::memfd_create("shd", MFD_CLOEXEC));
  if (file.fd < 0) refuse_errno("cannot make", "an anonymous file", errno);
  const auto* next = static_cast<const unsigned char*>(given.bytes);
  for (uint64_t left = given.size; left > 0;) {
    const ssize_t put = ::write(file.fd, next, static_cast<size_t>(std::min(left, uint64_t{1} << 26)));
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) refuse_errno("cannot write", "an anonymous file", errno);
    next += put;
    left -= static_cast<uint64_t>(put);
  }
  return file;
}

}  // namespace

ModuleRun::ModuleRun(const char* worker_path, const WorkerRequest& request, const Finder& finder,
                     const Deadline& deadline)
    : deadline_(deadline), finder_(finder), channel_(begin_call(worker_path, request, -1, SOCK_SEQPACKET, deadline)) {}

void ModuleRun::answer() {
  WorkerQuestion question;
  const int socket = channel_.input.ours.fd;
  const Stream stream = receive_packet(socket, &question, sizeof question, nullptr, 0, deadline_);
  if (stream != Stream::kDone || question.magic != kWorkerMagic) {
    channel_.input.ours.reset();  // the child has ended, or is damaged; the pipe shows which
    return;
  }
  if (++questions_ > kMaxQuestions) {
    core::refuse(SHD_ERROR_LIMIT, "the file names more than %u other files", kMaxQuestions);
  }
  question.name[sizeof question.name - 1] = 0;
  Given given;
  WorkerAnswer answer = {finder_.find(finder_.owner, question.name, &given) ? 1u : 0u, given.size};
  if (answer.found && given.file.fd < 0) given.file = memory_file(given);
  (void)send_packet(socket, &answer, sizeof answer, &given.file.fd, answer.found ? 1 : 0, deadline_);
}

/// Returns when the pipe can be read.
void ModuleRun::wait() {
  while (true) {
    const int left = deadline_.milliseconds_left();
    if (left == 0) require_done(Stream::kLate, channel_, deadline_);
    pollfd items[2] = {{channel_.data.ours.fd, POLLIN, 0}, {channel_.input.ours.fd, POLLIN, 0}};
    if (::poll(items, 2, left) < 0 && errno != EINTR) refuse_errno("cannot wait for", "the worker", errno);
    if (items[0].revents) return;
    if (items[1].revents) answer();
  }
}

void ModuleRun::read_raw(void* bytes, size_t size) {
  auto* next = static_cast<unsigned char*>(bytes);
  while (size > 0) {
    const ssize_t got = ::read(channel_.data.ours.fd, next, size);
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) {
      wait();
      continue;
    }
    if (got <= 0) require_done(Stream::kClosed, channel_, deadline_);
    next += got;
    size -= static_cast<size_t>(got);
  }
  if (deadline_.milliseconds_left() == 0) deadline_.check();
}

void ModuleRun::next_piece() {
  read_raw(&piece_, sizeof piece_);
  small_.clear();
  if (piece_ != 0 && piece_ <= kSmallPiece) {
    small_.resize(static_cast<size_t>(piece_));
    read_raw(small_.data(), small_.size());
  }
  if (piece_ != 0) return;
  WorkerReply reply;
  read_raw(&reply, sizeof reply);
  reply.message[sizeof reply.message - 1] = 0;
  core::make_printable(reply.message, std::strlen(reply.message));
  if (reply.magic != kWorkerMagic || reply.code > SHD_ERROR_INTERNAL) {
    core::refuse(SHD_ERROR_CORRUPT, "the decoder sent a wrong reply");
  }
  if (reply.code != SHD_OK) core::refuse(static_cast<shd_result>(reply.code), "%s", reply.message);
  ended_ = true;
}

void ModuleRun::read(void* bytes, size_t size) {
  auto* next = static_cast<unsigned char*>(bytes);
  while (size > 0) {
    if (piece_ == 0 && !ended_) next_piece();
    if (ended_) core::refuse(SHD_ERROR_CORRUPT, "the decoder sent a reply that ends too early");
    const auto part = static_cast<size_t>(std::min<uint64_t>(piece_, size));
    if (small_.empty()) {
      read_raw(next, part);
    } else {
      std::memcpy(next, small_.data() + small_.size() - piece_, part);
    }
    piece_ -= part;
    next += part;
    size -= part;
  }
}

void ModuleRun::finish() {
  if (piece_ == 0 && !ended_) next_piece();
  if (!ended_) core::refuse(SHD_ERROR_CORRUPT, "the decoder sent a reply that is too long");
}

}  // namespace shd::io
#endif
