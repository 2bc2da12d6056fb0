// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/file_descriptor.h"

/// The folder OUTPUT.part of an unfinished run: raw rows of the mip levels, and the state of the pyramid after some
/// rows of the base. Throws Failure (kExitOutput).
class Part {
 public:
  /// Opens or makes the folder, for this process alone. `key` describes the input and all options that decide the bits;
  /// a folder of another key is refused, or emptied if `force` is set.
  /// @param row_sizes  bytes of a row of level 1, 2 and so on
  Part(const std::string& output, const std::string& key, bool force, std::vector<size_t> row_sizes);
  /// The rows of the base that the folder accounts for; fills `state` unless it is 0.
  uint32_t restore(std::vector<double>* state, uint32_t height);
  /// Writes rows of a level.
  void write(uint32_t level, uint32_t y, uint32_t count, const uint8_t* rows);
  void read(uint32_t level, uint32_t y, uint32_t count, uint8_t* rows) const;
  /// A later run continues after `rows` rows of the base.
  void save(uint32_t rows, const std::vector<double>& state);
  /// The file that is not complete yet.
  std::string file() const { return folder_ + "/file"; }
  /// After a failure: removes the file, and the folder as well unless `keep` is set.
  void abandon(bool keep) const;
  /// Gives the file its name, and removes the folder.
  void publish(const std::string& output);

 private:
  void clear() const;
  void remove() const;
  [[noreturn]] void refuse(const std::string& action, int error) const;
  std::string level_path(size_t level) const;

  std::string folder_, key_;
  std::vector<size_t> row_sizes_;
  std::vector<shd::io::FileDescriptor> levels_;
  shd::io::FileDescriptor lock_;
};
