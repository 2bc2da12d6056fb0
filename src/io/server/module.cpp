// SPDX-License-Identifier: MIT
// A module in a child of the worker: see shd/worker.h. Its request and reply are opaque here.
#include "io/server/module.h"

#include <dlfcn.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include <shd/worker.h>

#include "core/regular_file.h"
#include "io/file/printable.h"
#include "io/server/confine.h"
#include "io/server/memory.h"
#include "io/server/send.h"
#include "io/worker/packet.h"

namespace shd::io {

namespace {

/// Bytes from this size on are lent to the pipe, not copied.
constexpr size_t kLentSize = size_t{1} << 16;

/// A file from this size on gets a heap of its size times kHeapOfFile, within half of the memory [bytes].
constexpr size_t kLargeFile = size_t{1} << 20;
constexpr uint64_t kHeapOfFile = 12;

int g_pipe, g_questions;
uint64_t g_memory;  // limit of this process [bytes]
bool g_heap_is_ready = false;
std::vector<unsigned char> g_pending;  // small pieces that have not been sent

void flush() {
  if (g_pending.empty()) return;
  const uint64_t size = g_pending.size();
  require_sent(send_all(g_pipe, &size, sizeof size) && send_all(g_pipe, g_pending.data(), g_pending.size()));
  g_pending.clear();
}

void send(const void* bytes, size_t size) {
  const auto* first = static_cast<const unsigned char*>(bytes);
  if (size < kLentSize) {
    g_pending.insert(g_pending.end(), first, first + size);
    if (g_pending.size() >= kLentSize) flush();
    return;
  }
  flush();
  const uint64_t piece = size;
  require_sent(send_all(g_pipe, &piece, sizeof piece) && lend_all(g_pipe, bytes, size));
}

/// The host answers until its deadline, after which it kills this process.
shd_result find(const char* name, const void** out_bytes, size_t* out_size) {
  WorkerQuestion question = {kWorkerMagic, ""};
  const size_t length = std::strlen(name);
  if (length >= sizeof question.name) return SHD_ERROR_NOT_FOUND;
  std::memcpy(question.name, name, length);
  const Deadline never(1e9);
  WorkerAnswer answer = {};
  FileDescriptor file;
  require_sent(send_packet(g_questions, &question, sizeof question, nullptr, 0, never) == Stream::kDone);
  require_sent(receive_packet(g_questions, &answer, sizeof answer, &file, 1, never) == Stream::kDone);
  if (!answer.found || file.fd < 0 || answer.size > SIZE_MAX / 2) return SHD_ERROR_NOT_FOUND;
  const auto size = static_cast<size_t>(answer.size);
  if (!g_heap_is_ready && size >= kLargeFile) {
    g_heap_is_ready = true;
    prepare_heap(static_cast<size_t>(std::min(kHeapOfFile * answer.size, g_memory / 2)));
  }
  void* const bytes = kWorkerMemory.allocate(nullptr, std::max(size, size_t{1}));
  if (!bytes) return SHD_ERROR_OUT_OF_MEMORY;
  int error = 0;
  if (core::read_at(file.fd, 0, size, bytes, &error) < size) return SHD_ERROR_NOT_FOUND;
  *out_bytes = bytes;
  *out_size = size;
  return SHD_OK;
}

/// A module that this process opened, or the one that forked it. To find it once more by dlopen() would touch the names
/// of all libraries, in hundreds of pages that a fresh child has not mapped.
struct Module {
  std::string path;
  shd_worker_entry_fn entry;
};
std::vector<Module> g_modules;

shd_worker_entry_fn find_module(const char* path) {
  for (const Module& module : g_modules) {
    if (module.path == path) return module.entry;
  }
  return nullptr;
}

shd_worker_entry_fn open_module(const char* path) {
  void* const module = ::dlopen(path, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  return module ? reinterpret_cast<shd_worker_entry_fn>(::dlsym(module, "shd_worker_entry")) : nullptr;
}

shd_result run(const WorkerRequest& request, char* message, size_t message_size) {
  const shd_worker_entry_fn known = find_module(request.module), entry = known ? known : open_module(request.module);
  if (!entry) {
    const char* const reason = ::dlerror();
    std::strncpy(message, ("cannot open a module: " + printable(reason ? reason : request.module)).c_str(),
                 message_size - 1);
    return SHD_ERROR_NOT_FOUND;
  }
  const shd_worker_call call = {request.module_request, request.module_request_size, find, send, message, message_size};
  return entry(&call);
}

}  // namespace

bool open_for_children(const WorkerRequest& request) {
  if (std::memchr(request.module, 0, sizeof request.module) == nullptr || find_module(request.module)) return false;
  const shd_worker_entry_fn entry = open_module(request.module);
  if (entry) g_modules.push_back({request.module, entry});
  return entry != nullptr;
}

void run_module(const WorkerRequest& request, int pipe, int questions) {
  g_pipe = pipe;
  g_questions = questions;
  g_memory = request.limits.bytes;
  confine(Confinement{request.limits.bytes, 0, request.limits.seconds});
  static WorkerReply reply = {};
  reply.magic = kWorkerMagic;
  reply.code = static_cast<uint32_t>(run(request, reply.message, sizeof reply.message));
  flush();
  constexpr uint64_t kEnd = 0;
  require_sent(send_all(g_pipe, &kEnd, sizeof kEnd) && send_all(g_pipe, &reply, sizeof reply));
  _exit(0);
}

}  // namespace shd::io
