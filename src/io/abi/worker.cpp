// SPDX-License-Identifier: MIT
#include <shd/worker.h>

#include <unistd.h>

#include <cmath>
#include <cstring>
#include <string>

#include "extension/guard.h"
#include "io/file/worker_path.h"
#include "io/worker/run.h"

extern "C" shd_result shd_worker_find_module(const char* file, char* out_path, size_t size) {
  using namespace shd::extension;
  return guard([&]() -> shd_result {
    if (!file || !out_path || size == 0) refuse(SHD_ERROR_INVALID_ARGUMENT, "%s: NULL", file ? "out_path" : "file");
    *out_path = 0;
    std::string path = shd::io::module_path(file);
    if (path.empty()) {
      const std::string worker = shd::io::default_worker_path();
      path = worker.substr(0, worker.rfind('/') + 1) + file;
      if (::access(path.c_str(), R_OK) != 0) path.clear();
    }
    if (path.empty()) refuse(SHD_ERROR_NOT_FOUND, "cannot find the module %s", file);
    if (path.size() >= size) refuse(SHD_ERROR_LIMIT, "size: %zu is too small for the path of %s", size, file);
    std::memcpy(out_path, path.c_str(), path.size() + 1);
    return SHD_OK;
  });
}

#ifdef __linux__

struct shd_worker_stream {
  shd::io::ModuleRun& run;
};

namespace {

using namespace shd;
using extension::guard;
using extension::refuse;
using extension::require;

shd_worker_task checked(const shd_worker_task& in) {
  shd_worker_task task = in;
  if (!task.module || *task.module != '/') {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "worker.module: %s", task.module ? "is not an absolute path" : "NULL");
  }
  if (!task.receive) refuse(SHD_ERROR_INVALID_ARGUMENT, "worker.receive: NULL");
  if (task.time_limit == 0) task.time_limit = 60;
  if (!(task.time_limit > 0) || !std::isfinite(task.time_limit)) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "worker.time_limit: %g is not positive", task.time_limit);
  }
  return task;
}

io::WorkerRequest request_of(const shd_worker_task& task) {
  io::WorkerRequest request = {};
  request.magic = io::kWorkerMagic;
  const size_t length = std::strlen(task.module);
  if (length >= sizeof request.module) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "worker.module: %zu bytes are not below %zu", length, sizeof request.module);
  }
  if (task.request_size > sizeof request.module_request || (task.request_size > 0 && !task.request)) {
    refuse(SHD_ERROR_INVALID_ARGUMENT, "worker.request_size: %zu is not in 0..%zu, or worker.request is NULL",
           task.request_size, sizeof request.module_request);
  }
  std::memcpy(request.module, task.module, length);
  if (task.request_size > 0) std::memcpy(request.module_request, task.request, task.request_size);
  request.module_request_size = static_cast<uint32_t>(task.request_size);
  request.limits.bytes = task.max_bytes ? task.max_bytes : uint64_t{1} << 32;
  request.limits.seconds = task.time_limit;
  return request;
}

bool find(void* owner, const char* name, io::Given* out) {
  const auto& task = *static_cast<const shd_worker_task*>(owner);
  if (!task.find) return false;
  shd_worker_file file = {-1, nullptr, 0};
  const shd_result result = task.find(name, &file, task.user_data);
  out->file.fd = static_cast<int>(file.descriptor);
  out->bytes = file.bytes;
  out->size = file.size;
  if (result != SHD_ERROR_NOT_FOUND) require(result);
  return result == SHD_OK;
}

}  // namespace

extern "C" {

shd_result shd_worker_run(const shd_worker_task* task) {
  return guard([&]() -> shd_result {
    if (!task) refuse(SHD_ERROR_INVALID_ARGUMENT, "worker: NULL");
    shd_worker_task read = checked(*task);
    const io::Deadline deadline(read.time_limit);
    io::ModuleRun run(read.worker_path, request_of(read), {&read, find}, deadline);
    shd_worker_stream stream = {run};
    require(read.receive(&stream, read.user_data));
    run.finish();
    return SHD_OK;
  });
}

shd_result shd_worker_read(shd_worker_stream* reply, void* bytes, size_t size) {
  return guard([&]() -> shd_result {
    if (!reply || (size > 0 && !bytes)) refuse(SHD_ERROR_INVALID_ARGUMENT, "%s: NULL", reply ? "bytes" : "reply");
    reply->run.read(bytes, size);
    return SHD_OK;
  });
}

}  // extern "C"

#else

extern "C" {

shd_result shd_worker_run(const shd_worker_task*) {
  return shd::extension::fail(SHD_ERROR_UNSUPPORTED, "the worker needs Linux");
}

shd_result shd_worker_read(shd_worker_stream*, void*, size_t) {
  return shd::extension::fail(SHD_ERROR_UNSUPPORTED, "the worker needs Linux");
}

}  // extern "C"

#endif
