// SPDX-License-Identifier: MIT
#include "io/file/file_descriptor.h"

#include <cerrno>
#include <cstring>

#include "core/failure.h"
#include "io/file/printable.h"

namespace shd::io {

namespace {

// The result of strerror_r(): the GNU one returns the text, the POSIX one a number.
[[maybe_unused]] const char* reason_of(const char* text, const char*) {
  return text;
}
[[maybe_unused]] const char* reason_of(int, const char* buffer) {
  return buffer;
}

}  // namespace

void refuse_errno(const char* action, const char* path, int error) {
  shd_result code = SHD_ERROR_IO;
  if (error == ENOENT || error == ENOTDIR) code = SHD_ERROR_NOT_FOUND;
  if (error == ENAMETOOLONG || error == EILSEQ || error == EINVAL) code = SHD_ERROR_INVALID_ARGUMENT;
  if (error == ENOMEM) code = SHD_ERROR_OUT_OF_MEMORY;
  char buffer[128] = "";
  const char* const reason = reason_of(::strerror_r(error, buffer, sizeof buffer), buffer);
  core::refuse(code, "%s \"%s\": %s", action, printable(path).c_str(), reason);
}

}  // namespace shd::io
