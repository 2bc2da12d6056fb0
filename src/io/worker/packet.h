// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "io/file/file_descriptor.h"
#include "io/file/limits.h"

namespace shd::io {

/// Outcome of a transfer: complete, the other end is closed or breaks the protocol, or the deadline has passed.
enum class Stream { kDone, kClosed, kLate };

/// Largest number of descriptors in a packet.
constexpr int kMaxDescriptors = 3;

/// Sends one packet with copies of `count` descriptors over a SOCK_SEQPACKET socket.
Stream send_packet(int socket, const void* bytes, size_t size, const int* descriptors, int count,
                   const Deadline& deadline);

/// Receives one packet of exactly `size` bytes and up to `count` descriptors; absent ones are -1.
Stream receive_packet(int socket, void* bytes, size_t size, FileDescriptor* descriptors, int count,
                      const Deadline& deadline);

/// As receive_packet(), but the packet stays in the socket.
Stream peek_packet(int socket, void* bytes, size_t size, FileDescriptor* descriptors, int count,
                   const Deadline& deadline);

/// Sends `size` bytes over a SOCK_STREAM socket.
Stream send_all(int socket, const void* bytes, size_t size, const Deadline& deadline);

/// Reads `size` bytes from a pipe that does not block.
Stream receive_all(int pipe, void* bytes, size_t size, const Deadline& deadline);

}  // namespace shd::io
