// SPDX-License-Identifier: MIT
// A library for LD_PRELOAD that makes the decoder of shd-maketx lie: it changes what the decoder sends. The decoder
// gets no environment variable except those whose names begin with LD_.
//   LD_FALSE_DECODER="MESSAGE OFFSET VALUE ..."   the word at this offset of the message of this number becomes VALUE
//   LD_FALSE_DECODER="MESSAGE end"                the decoder ends in the middle of this message
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

typedef ssize_t (*send_function)(int, const void*, size_t, int);

static unsigned char g_changed[1 << 20];

__attribute__((visibility("default"))) ssize_t send(int socket, const void* bytes, size_t size, int flags) {
  static long number = -1;
  send_function real;
  void* const found = dlsym(RTLD_NEXT, "send");
  memcpy(&real, &found, sizeof real);
  const char* text = getenv("LD_FALSE_DECODER");
  if (socket != 0 || !text || size > sizeof g_changed) return real(socket, bytes, size, flags);
  ++number;
  memcpy(g_changed, bytes, size);
  while (*text) {
    char* next;
    const long message = strtol(text, &next, 10);
    if (strcmp(next, " end") == 0) {
      if (message != number) break;
      (void)real(socket, bytes, size / 2, flags);
      _exit(9);
    }
    const long offset = strtol(next, &next, 10);
    const uint32_t value = (uint32_t)strtol(next, &next, 0);
    if (next == text) break;
    if (message == number && (size_t)offset + sizeof value <= size) memcpy(g_changed + offset, &value, sizeof value);
    text = next + (*next == ' ');
  }
  return real(socket, g_changed, size, flags);
}
