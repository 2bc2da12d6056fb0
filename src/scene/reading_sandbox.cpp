// SPDX-License-Identifier: MIT
// Reading in WebAssembly, in place of reading.cpp: the readers are linked, and what they can reach is the memory of
// their instance.
#include "scene/read/read.h"
#include "scene/reading.h"

namespace shd::scene {

Model read_in_process(HostFiles& files, const Limits& limits, const Deadline& deadline) {
  LoadedFiles loaded(files);
  const Bytes bytes = loaded.load("", files.model());
  return read_model({bytes, files.name(), loaded, limits, deadline});
}

Model read_by_worker(HostFiles& files, const char*, const Limits& limits, const Deadline& deadline) {
  return read_in_process(files, limits, deadline);
}

}  // namespace shd::scene
