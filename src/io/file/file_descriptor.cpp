// SPDX-License-Identifier: MIT
#include "io/file/file_descriptor.h"

#include <cerrno>
#include <cstring>

#include "core/failure.h"
#include "io/file/printable.h"

namespace shd::io {

void refuse_errno(const char* action, const char* path, int error) {
  shd_result code = SHD_ERROR_IO;
  if (error == ENOENT || error == ENOTDIR) code = SHD_ERROR_NOT_FOUND;
  if (error == ENAMETOOLONG || error == EILSEQ || error == EINVAL) code = SHD_ERROR_INVALID_ARGUMENT;
  if (error == ENOMEM) code = SHD_ERROR_OUT_OF_MEMORY;
  char buffer[128] = "";
  // The GNU strerror_r returns the text, the POSIX one a number. This build uses the GNU one.
  const char* reason = ::strerror_r(error, buffer, sizeof buffer);
  core::refuse(code, "%s \"%s\": %s", action, printable(path).c_str(), reason);
}

}  // namespace shd::io
