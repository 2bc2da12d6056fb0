// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "io/file/file_descriptor.h"

/// The folder OUTPUT.part of an unfinished run: raw rows of the mip levels, and the state of the pyramid after some
/// rows of the base, with checksums of both. It belongs to this user, and no other user may write into it. Its files
/// are opened by its descriptor, and no link is followed. Throws Failure (kExitOutput).
class Part {
 public:
  /// Opens or makes the folder, for this process alone. `key` describes the input and all options that decide the bits;
  /// a folder of another key is refused, or emptied if `force` is set.
  /// @param row_sizes  bytes of a row of level 1, 2 and so on
  /// @param height     rows of the base
  Part(const std::string& output, const std::string& key, bool force, std::vector<size_t> row_sizes, uint32_t height);
  /// The rows of the base that the folder accounts for; fills `state` unless it is 0. If a checksum is wrong, it is 0,
  /// and `damaged` gets the name of the file.
  uint32_t restore(std::vector<double>* state, std::string* damaged);
  /// Writes the next rows of a level.
  void write(uint32_t level, uint32_t y, uint32_t count, const uint8_t* rows);
  /// Reads the next rows of a complete level, and checks it with its last one.
  void read(uint32_t level, uint32_t y, uint32_t count, uint8_t* rows);
  /// A later run continues after `rows` rows of the base.
  void save(uint32_t rows, const std::vector<double>& state);
  /// Makes the file that is not complete yet, anew.
  shd::io::FileDescriptor create_file() const;
  /// After a failure: removes the file, and the folder as well unless `keep` is set.
  void abandon(bool keep) const;
  /// Gives the file its name, and removes the folder.
  void publish(const std::string& output);

 private:
  void open_folder();
  void clear() const;
  void remove() const;
  [[noreturn]] void refuse(const std::string& action, int error) const;
  shd::io::FileDescriptor open_inside(const std::string& name, int flags, unsigned mode = 0600) const;
  shd::io::FileDescriptor create(const char* name, unsigned mode) const;
  uint32_t completed(size_t level, uint32_t rows) const;

  std::string path_, key_;
  std::vector<size_t> row_sizes_;
  uint32_t height_;
  shd::io::FileDescriptor folder_, lock_;
  std::vector<shd::io::FileDescriptor> levels_;
  std::vector<uint64_t> sums_;  // checksum of the rows of each level that have been written
  uint64_t read_sum_ = 0;       // checksum of the rows of the current level that have been read
};
