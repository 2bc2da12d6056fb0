// SPDX-License-Identifier: MIT
#include "scene/host_files.h"

#include "scene/text.h"

namespace shd::scene {

bool HostFiles::open(const std::string& name, Opened* out) {
  deadline_.check();
  std::string why;
  if (!locate("", name, out, &why)) {
    if (!why.empty()) refused_.push_back("\"" + text_of(name) + "\" was not read: " + why);
    return false;
  }
  charge(name, out->size);
  return true;
}

void HostFiles::charge(const std::string& name, uint64_t size) {
  if (size > left_) {
    core::refuse(SHD_ERROR_LIMIT, "with \"%s\" its files have more bytes than scene.max_file_bytes %llu",
                 text_of(name).c_str(), static_cast<unsigned long long>(limits_.file_bytes));
  }
  left_ -= size;
}

const Bytes* LoadedFiles::find(const std::string& name) {
  const auto known = loaded_.find(name);
  if (known != loaded_.end()) return known->second.found ? &known->second.bytes : nullptr;
  Opened opened;
  if (host_.open(name, &opened)) return &load(name, opened);
  loaded_[name];
  return nullptr;
}

const Bytes& LoadedFiles::load(const std::string& name, const Opened& opened) {
  Loaded& loaded = loaded_[name];
  loaded.bytes = opened.bytes;
  if (!opened.bytes.data) {
    loaded.memory.resize(static_cast<size_t>(opened.size));
    int error = 0;
    const size_t size = loaded.memory.size();
    if (core::read_at(opened.file.fd, 0, size, loaded.memory.data(), &error) < size) {
      core::refuse(SHD_ERROR_IO, "cannot read \"%s\"", text_of(opened.path).c_str());
    }
    loaded.bytes = {loaded.memory.data(), size};
  }
  loaded.found = true;
  return loaded.bytes;
}

}  // namespace shd::scene
