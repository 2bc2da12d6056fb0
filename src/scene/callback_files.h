// SPDX-License-Identifier: MIT
#pragma once

#include <shd/scene.h>

#include "scene/host_files.h"
#include "scene/text.h"

namespace shd::scene {

/// A model in memory, or on disk, with the files that the callback of a desc answers.
class CallbackFiles : public HostFiles {
 public:
  CallbackFiles(Opened model, std::string name, const shd_scene_desc& desc, const Limits& limits,
                const Deadline& deadline)
      : HostFiles(limits, deadline), model_(std::move(model)), name_(std::move(name)), desc_(desc) {
    charge(name_, model_.size);
  }

  Opened model() override { return std::move(model_); }
  std::string name() const override { return name_; }
  bool locate(const std::string& folder, const std::string& name, Opened* out, std::string* why) override {
    why->clear();
    if (!desc_.find) return false;
    const void* bytes = nullptr;
    size_t size = 0;
    const shd_result result = desc_.find((folder + name).c_str(), &bytes, &size, desc_.user_data);
    if (result == SHD_ERROR_NOT_FOUND) return false;
    if (result != SHD_OK) core::refuse(result, "scene.find failed for \"%s\"", text_of(folder + name).c_str());
    if (!bytes) core::refuse(SHD_ERROR_INVALID_ARGUMENT, "scene.find gave no bytes");
    out->bytes = {static_cast<const unsigned char*>(bytes), size};
    out->size = size;
    return true;
  }

 private:
  Opened model_;
  std::string name_;
  const shd_scene_desc& desc_;
};

}  // namespace shd::scene
