// SPDX-License-Identifier: MIT
#include "scene/reading.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <utility>

#include <shd/worker.h>

#include "extension/guard.h"
#include "scene/read/check_model.h"
#include "scene/read/module.h"
#include "scene/read/stream.h"
#include "scene/text.h"

namespace shd::scene {
namespace {

using extension::require;

/// The path of the module of the readers.
std::string module_path() {
  std::string path(4096, 0);
  require(shd_worker_find_module(SHD_READERS_FILE, path.data(), path.size()));
  path.resize(std::strlen(path.c_str()));
  return path;
}

const ReadersModule& module() {
  // It stays loaded, as the libraries under it need not survive the end of their code.
  void* const handle = ::dlopen(module_path().c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (!handle) {
    const char* const reason = ::dlerror();
    core::refuse(SHD_ERROR_NOT_FOUND, "cannot open %s: %s", SHD_READERS_FILE, text_of(reason ? reason : "").c_str());
  }
  const void* const opened = ::dlsym(handle, kReadersSymbol);
  if (!opened || std::strcmp(*static_cast<const char* const*>(opened), SHD_MODULE_VERSION) != 0) {
    core::refuse(SHD_ERROR_INTERNAL, "%s belongs to another version of shd", SHD_READERS_FILE);
  }
  return *static_cast<const ReadersModule*>(opened);
}

/// Files for the readers, which are given no exception: the first one is kept for the end of the reading. A file that
/// threw is absent for the reader.
class ContainedFiles : public Files {
 public:
  explicit ContainedFiles(Files& files) : files_(files) {}

  const Bytes* find(const std::string& name) override {
    if (failure_) return nullptr;
    try {
      return files_.find(name);
    } catch (...) {
      failure_ = std::current_exception();
      return nullptr;
    }
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  Files& files_;
  std::exception_ptr failure_;
};

/// State of one reading by the worker.
struct Reading {
  HostFiles& files;
  const Limits& limits;
  Model model;
  Opened opened;  // the last answer
};

shd_result answer(const char* name, shd_worker_file* out, void* user) {
  return extension::guard([&]() -> shd_result {
    auto& reading = *static_cast<Reading*>(user);
    reading.opened = Opened();
    if (!*name) {
      reading.opened = reading.files.model();
    } else if (!reading.files.open(name, &reading.opened)) {
      return SHD_ERROR_NOT_FOUND;
    }
    out->descriptor = std::exchange(reading.opened.file.fd, -1);
    out->bytes = reading.opened.bytes.data;
    out->size = reading.opened.size;
    return SHD_OK;
  });
}

shd_result receive(shd_worker_stream* reply, void* user) {
  return extension::guard([&]() -> shd_result {
    auto& reading = *static_cast<Reading*>(user);
    FieldReader reader([reply](void* bytes, size_t size) { require(shd_worker_read(reply, bytes, size)); },
                       reading.limits.reader_bytes);
    reader(reading.model);
    return SHD_OK;
  });
}

template <class Part>
void clean_names(std::vector<Part>& parts) {
  for (Part& part : parts) part.name = text_of(part.name);
}

/// The reader may have died of what it read, and lies: its names are made printable again.
void clean_names(Model& model) {
  clean_names(model.geometries);
  clean_names(model.surfaces);
  clean_names(model.nodes);
  clean_names(model.animations);
  clean_names(model.lights);
  clean_names(model.cameras);
}

std::vector<unsigned char> bytes_of(ReadRequest request) {
  std::vector<unsigned char> out;
  FieldWriter writer([&out](const void* bytes, size_t size) {
    const auto* first = static_cast<const unsigned char*>(bytes);
    out.insert(out.end(), first, first + size);
  });
  writer(request);
  return out;
}

}  // namespace

Model read_in_process(HostFiles& files, const Limits& limits, const Deadline& deadline) {
  LoadedFiles loaded(files);
  const Bytes bytes = loaded.load("", files.model());
  Model model;
  char text[core::kErrorTextSize] = "";
  ContainedFiles contained(loaded);
  const shd_result result = module().read({bytes, files.name(), contained, limits, deadline}, &model, text);
  contained.rethrow();
  if (result == SHD_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  if (result != SHD_OK) core::refuse(result, "%s", text);
  return model;
}

Model read_by_worker(HostFiles& files, const char* worker_path, const Limits& limits, const Deadline& deadline) {
  deadline.check();
  Reading reading = {files, limits, {}, Opened()};
  const std::string path = module_path();
  ReadRequest request = {SHD_MODULE_VERSION, files.name().substr(0, 255), limits};
  request.limits.seconds = std::max(deadline.seconds_left(), 1e-3);
  const std::vector<unsigned char> bytes = bytes_of(request);
  shd_worker_task task = SHD_ZERO_INIT;
  task.module = path.c_str();
  task.worker_path = worker_path;
  task.request = bytes.data();
  task.request_size = bytes.size();
  task.max_bytes = limits.reader_bytes;
  task.time_limit = request.limits.seconds;
  task.find = answer;
  task.receive = receive;
  task.user_data = &reading;
  const shd_result result = shd_worker_run(&task);
  if (result != SHD_OK) {
    const core::Failure failure(result, shd_last_error());
    deadline.check();
    throw failure;
  }
  clean_names(reading.model);
  check_model(reading.model, limits);
  return std::move(reading.model);
}

}  // namespace shd::scene
