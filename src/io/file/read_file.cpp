// SPDX-License-Identifier: MIT
#include "io/file/read_file.h"

#include "core/failure.h"
#include "io/file/printable.h"

namespace shd::io {

core::RegularFile open_file(const char* path) {
  core::RegularFile opened = core::open_regular(path);
  if (opened.other_kind) core::refuse(SHD_ERROR_IO, "\"%s\" is not a regular file", printable(path).c_str());
  if (opened.error) refuse_errno("cannot open", path, opened.error);
  return opened;
}

OpenFile open_file(const char* path, const Limits& limits) {
  core::RegularFile opened = open_file(path);
  if (opened.size == 0) core::refuse(SHD_ERROR_CORRUPT, "\"%s\" is empty", printable(path).c_str());
  if (opened.size > limits.file_bytes) {
    core::refuse(SHD_ERROR_LIMIT, "\"%s\" has %llu bytes, above load.max_file_bytes %llu", printable(path).c_str(),
                 static_cast<unsigned long long>(opened.size), static_cast<unsigned long long>(limits.file_bytes));
  }
  return {std::move(opened.file), static_cast<size_t>(opened.size)};
}

void read_bytes_at(int file, uint64_t at, size_t size, unsigned char* out) {
  int error = 0;
  const size_t got = core::read_at(file, at, size, out, &error);
  if (error) refuse_errno("cannot read", "the file", error);
  if (got < size) core::refuse(SHD_ERROR_IO, "the file became shorter while it was read");
}

Buffer read_bytes(int file, size_t size, const Memory& memory) {
  Buffer bytes(memory, size);
  read_bytes_at(file, 0, size, bytes.data());
  return bytes;
}

}  // namespace shd::io
