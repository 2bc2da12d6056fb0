// SPDX-License-Identifier: MIT
#pragma once

#include "scene/read/read.h"

namespace shd::scene {

/// Functions of the module of the readers for a host that reads in its own process, beside shd_worker_entry(). Both
/// ends are of one build. No exception passes between them, because each may have a C++ runtime of its own: a failure
/// is a result and a text of core::kErrorTextSize bytes, and source.files throws nothing.
struct ReadersModule {
  const char* version;
  shd_result (*read)(const Source& source, Model* out, char* text);
};

/// Name of the exported variable, of type ReadersModule.
constexpr const char* kReadersSymbol = "shd_scene_readers";

}  // namespace shd::scene
