// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/regular_file.h"
#include "scene/limits.h"
#include "scene/read/files.h"

namespace shd::scene {

/// A file that may be read: open on disk, or bytes of the host, which stay during the load.
struct Opened {
  core::FileDescriptor file;  // if bytes.data is null
  std::string path;           // path of `file`
  Bytes bytes;
  uint64_t size = 0;
};

/// The files around a model, by the rules of the host.
class HostFiles {
 public:
  HostFiles(const Limits& limits, const Deadline& deadline)
      : limits_(limits), deadline_(deadline), left_(limits.file_bytes) {}
  virtual ~HostFiles() = default;

  /// The model itself, and its name without folders.
  virtual Opened model() = 0;
  virtual std::string name() const = 0;
  /// Finds a file `name`, which is relative to `folder` below the folder of the model ("" or "a/b/"). Returns false if
  /// there is none that may be read; `why` is the reason, for a message.
  virtual bool locate(const std::string& folder, const std::string& name, Opened* out, std::string* why) = 0;
  /// As locate(), for a reader: the file counts for the budget. Throws Failure beyond it.
  bool open(const std::string& name, Opened* out);
  /// Refusals of open(), one text for each name.
  const std::vector<std::string>& refused() const { return refused_; }

 protected:
  void charge(const std::string& name, uint64_t size);
  const Limits& limits_;
  const Deadline& deadline_;

 private:
  uint64_t left_;
  std::vector<std::string> refused_;
};

/// Files in the memory of this process, for a reader in this process.
class LoadedFiles : public Files {
 public:
  explicit LoadedFiles(HostFiles& host) : host_(host) {}
  const Bytes* find(const std::string& name) override;
  /// The whole file; throws Failure if it cannot be read.
  const Bytes& load(const std::string& name, const Opened& opened);

 private:
  struct Loaded {
    std::vector<unsigned char> memory;
    Bytes bytes;
    bool found = false;
  };
  HostFiles& host_;
  std::map<std::string, Loaded> loaded_;
};

}  // namespace shd::scene
