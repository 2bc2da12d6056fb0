// SPDX-License-Identifier: MIT
// Files that are written at any place. Every failure names the file and the system's reason.
#ifndef SHD_FARM_PART_FILE_H
#define SHD_FARM_PART_FILE_H

#include <cstdint>
#include <stdexcept>
#include <string>

namespace farm {

/// A failure that the user can mend: its text is the message of the job.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct File {
  std::string path;
  int fd = -1;

  File() = default;
  File(const std::string& path, int flags);  // flags of open(); throws Failure
  File(File&& other) noexcept;
  File& operator=(File&& other) noexcept;
  ~File();
};

[[noreturn]] void fail_with_errno(const std::string& path, const char* action);

void write_at(const File& file, uint64_t offset, const void* data, size_t size);
/// Returns the number of bytes that are there.
size_t read_at(const File& file, uint64_t offset, void* data, size_t size);
void append(const File& file, const std::string& text);
void sync_data(const File& file);
/// Allocates `size` bytes on the disk where the file system can, so that a full disk is found at the beginning.
void reserve(const File& file, uint64_t size);
/// Refuses a file that another job has locked.
void lock(const File& file);
void rename_file(const std::string& from, const std::string& to);
/// Makes names in the folder of `path` durable.
void sync_folder(const std::string& path);
bool file_exists(const std::string& path);
void remove_file(const std::string& path);
uint64_t size_of(const std::string& path);  // 0 if there is no such file

}  // namespace farm

#endif  // SHD_FARM_PART_FILE_H
