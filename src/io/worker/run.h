// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "io/worker/call.h"

namespace shd::io {

/// A file for a child: `file` if it is open, otherwise bytes.
struct Given {
  FileDescriptor file;
  const void* bytes = nullptr;
  uint64_t size = 0;
};

/// The host's answer to a question of a child. Returns false if there is no such file; throws Failure to end the run.
struct Finder {
  void* owner;
  bool (*find)(void* owner, const char* name, Given* out);
};

/// A module that runs in a child of the worker, and its reply.
class ModuleRun {
 public:
  ModuleRun(const char* worker_path, const WorkerRequest& request, const Finder& finder, const Deadline& deadline);
  /// The next bytes of the reply. Questions are answered meanwhile. Throws Failure, also that of the module.
  void read(void* bytes, size_t size);
  /// Requires that the reply has ended, with success.
  void finish();

 private:
  void read_raw(void* bytes, size_t size);
  void next_piece();
  void wait();
  void answer();

  const Deadline& deadline_;
  const Finder finder_;
  Channel channel_;
  std::vector<unsigned char> small_;  // the piece, if it is small
  uint64_t piece_ = 0;                // bytes of the current piece that have not been read
  uint32_t questions_ = 0;
  bool ended_ = false;  // the final reply has come, and has no error
};

}  // namespace shd::io
