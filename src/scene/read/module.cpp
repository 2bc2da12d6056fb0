// SPDX-License-Identifier: MIT
// The module libshd_scene_readers: all readers, for children of the worker and for hosts that read by themselves.
#include "scene/read/module.h"

#include <cstdio>
#include <cstring>
#include <map>

#include <shd/worker.h>

#include "core/guard.h"
#include "scene/read/stream.h"

namespace shd::scene {
namespace {

/// Files that the host of the worker answers.
class AskedFiles : public Files {
 public:
  explicit AskedFiles(const shd_worker_call& call) : call_(call) {}

  const Bytes* find(const std::string& name) override {
    const auto known = known_.find(name);
    if (known != known_.end()) return known->second.data ? &known->second : nullptr;
    Bytes& bytes = known_[name];
    const void* data = nullptr;
    size_t size = 0;
    const shd_result result = name.empty() ? SHD_ERROR_NOT_FOUND : call_.find(name.c_str(), &data, &size);
    if (result == SHD_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    if (result != SHD_OK) return nullptr;
    bytes = {static_cast<const unsigned char*>(data), size};
    return &bytes;
  }

  /// The model itself, which has no name.
  Bytes model() const {
    const void* data = nullptr;
    size_t size = 0;
    const shd_result result = call_.find("", &data, &size);
    if (result == SHD_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    if (result != SHD_OK) core::refuse(result, "the model cannot be read");
    return {static_cast<const unsigned char*>(data), size};
  }

 private:
  const shd_worker_call& call_;
  std::map<std::string, Bytes> known_;
};

ReadRequest request_of(const shd_worker_call& call) {
  const auto* next = static_cast<const unsigned char*>(call.request);
  size_t left = call.request_size;
  const auto receive = [&](void* out, size_t size) {
    if (size > left) core::refuse(SHD_ERROR_INTERNAL, "the request is too short");
    if (size) std::memcpy(out, next, size);
    next += size;
    left -= size;
  };
  ReadRequest request;
  FieldReader reader(receive, call.request_size);
  reader(request);
  if (request.version != SHD_MODULE_VERSION)
    core::refuse(SHD_ERROR_INTERNAL, "the readers are of another version of shd");
  return request;
}

void answer(const shd_worker_call& call) {
  const ReadRequest request = request_of(call);
  const Deadline deadline(request.limits.seconds);
  AskedFiles files(call);
  static Model model;  // its memory is lent until the process ends
  model = read_model({files.model(), request.name, files, request.limits, deadline});
  FieldWriter writer([&call](const void* bytes, size_t size) { call.send(bytes, size); });
  writer(model);
}

template <class Body>
shd_result contain(char* text, size_t size, Body&& body) noexcept {
  const auto report = [&](shd_result code, const char* what) {
    std::snprintf(text, size, "%s", what);
    return code;
  };
  return core::guard(report, [&] {
    body();
    return SHD_OK;
  });
}

shd_result read(const Source& source, Model* out, char* text) {
  return contain(text, core::kErrorTextSize, [&] { *out = read_model(source); });
}

}  // namespace
}  // namespace shd::scene

extern "C" {

SHD_API shd_result shd_worker_entry(const shd_worker_call* call);
shd_result shd_worker_entry(const shd_worker_call* call) {
  return shd::scene::contain(call->message, call->message_size, [&] { shd::scene::answer(*call); });
}

extern SHD_API const shd::scene::ReadersModule shd_scene_readers;
const shd::scene::ReadersModule shd_scene_readers = {SHD_MODULE_VERSION, shd::scene::read};
}
