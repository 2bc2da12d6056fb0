// SPDX-License-Identifier: MIT
// shd-io-worker: decodes one file for SHD_LOAD_ISOLATE and exits. Limits of the operating system bound its memory and
// time, so that a failing decoder ends only this process.
#include <sys/resource.h>
#include <sys/socket.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "core/guard.h"
#include "io/load.h"
#include "io/oiio.h"
#include "io/worker_protocol.h"

namespace {

using namespace shd::io;

constexpr int kSocket = 0;

/// Largest size of a bitmap that a request allows; cannot overflow for any request [bytes].
uint64_t decoded_bytes(const WorkerRequest& request) {
  return std::min(request.limits.bytes, std::min(request.limits.pixels, kMaxSide * kMaxSide) * 16);
}

void* plain_allocate(void*, size_t size) {
  return std::malloc(size);
}
void plain_free(void*, void* memory, size_t) {
  std::free(memory);
}
constexpr Memory kPlain = {nullptr, plain_allocate, plain_free};

bool receive_all(void* bytes, size_t size) {
  auto* next = static_cast<unsigned char*>(bytes);
  while (size > 0) {
    const ssize_t got = ::recv(kSocket, next, size, 0);
    if (got <= 0) return false;
    next += got;
    size -= static_cast<size_t>(got);
  }
  return true;
}

bool send_all(const void* bytes, size_t size) {
  const auto* next = static_cast<const unsigned char*>(bytes);
  while (size > 0) {
    const ssize_t put = ::send(kSocket, next, size, MSG_NOSIGNAL);
    if (put <= 0) return false;
    next += put;
    size -= static_cast<size_t>(put);
  }
  return true;
}

void set_limit(decltype(RLIMIT_CPU) resource, uint64_t value) {
  const rlimit limit = {value, value};
  (void)::setrlimit(resource, &limit);
}

/// Sanitizers reserve more address space than any limit would leave.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
void limit_memory(const WorkerRequest&) {}
#else
/// Address space in use at this moment, by the libraries of the decoders [bytes].
uint64_t address_space() {
  unsigned long long pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%llu", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return pages * static_cast<uint64_t>(::sysconf(_SC_PAGESIZE));
}

/// Decoders hold up to two copies of a picture in addition to the result. The constant covers three copies of the
/// largest row or tile that any max_bytes allows, 64 MiB, and tables.
void limit_memory(const WorkerRequest& request) {
  const uint64_t decoded = decoded_bytes(request);
  const uint64_t used = address_space();
  if (used > 0) set_limit(RLIMIT_AS, used + 3 * decoded + 3 * request.size + (uint64_t{256} << 20));
}
#endif

void confine(const WorkerRequest& request) {
  set_limit(RLIMIT_CORE, 0);
  set_limit(RLIMIT_CPU, static_cast<uint64_t>(std::ceil(std::min(request.limits.seconds, 1e9))) + 1);
  limit_memory(request);
#ifdef __linux__
  (void)::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
#endif
  limit_process(decoded_bytes(request));
}

LoadOptions options_of(const WorkerRequest& request) {
  LoadOptions options;
  options.formats = request.formats;
  options.flags = request.flags;
  options.encoding = static_cast<shd_color_encoding>(request.encoding);
  options.subimage = request.subimage;
  options.limits = request.limits;
  return options;
}

/// Decodes the file of a request; a failure is stored in the reply.
Bitmap answer(const WorkerRequest& request, WorkerReply* reply) {
  Bitmap bitmap;
  const auto report = [&](shd_result code, const char* text) {
    reply->code = static_cast<uint32_t>(code);
    if (code == SHD_ERROR_OUT_OF_MEMORY) text = "out of memory in the worker";
    std::strncpy(reply->message, text, sizeof reply->message - 1);
    return code;
  };
  shd::core::guard(report, [&] {
    Buffer bytes(kPlain, request.size);
    if (!receive_all(bytes.data(), bytes.size())) std::_Exit(3);
    const Deadline deadline(request.limits.seconds);
    bitmap = load(bytes.data(), bytes.size(), options_of(request), kPlain, deadline);
    reply->code = SHD_OK;
    reply->format = static_cast<uint32_t>(bitmap.format);
    reply->width = bitmap.width;
    reply->height = bitmap.height;
    reply->size = bitmap.pixels.size();
    reply->info = bitmap.info;
    std::memcpy(reply->color_space, bitmap.color_space, sizeof reply->color_space);
    return SHD_OK;
  });
  return bitmap;
}

}  // namespace

int main() {
#ifdef __linux__
  (void)::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  WorkerRequest request;
  if (!receive_all(&request, sizeof request) || request.magic != kWorkerMagic) return 2;
  confine(request);
  static WorkerReply reply;
  reply.magic = kWorkerMagic;
  const Bitmap bitmap = answer(request, &reply);
  const bool sent = send_all(&reply, sizeof reply) && send_all(bitmap.pixels.data(), bitmap.pixels.size());
  // Destructors are skipped, because the decoders' libraries take longer to unload than to decode.
  std::_Exit(sent ? 0 : 3);
}
