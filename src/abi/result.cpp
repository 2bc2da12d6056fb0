// SPDX-License-Identifier: MIT
#include <shd/base.h>
#include <shd/result.h>

#include "abi/desc.h"
#include "core/status.h"

extern "C" {

uint32_t shd_version(void) {
  return (SHD_VERSION_MAJOR << 16) | (SHD_VERSION_MINOR << 8) | SHD_VERSION_PATCH;
}

const char* shd_last_error(void) {
  return shd::core::last_error();
}

const char* shd_result_name(shd_result result) {
  switch (shd::abi::enum_bits(result)) {
    case SHD_OK: return "SHD_OK";
    case SHD_ERROR_INVALID_ARGUMENT: return "SHD_ERROR_INVALID_ARGUMENT";
    case SHD_ERROR_OUT_OF_MEMORY: return "SHD_ERROR_OUT_OF_MEMORY";
    case SHD_ERROR_UNSUPPORTED: return "SHD_ERROR_UNSUPPORTED";
    case SHD_ERROR_NOT_FOUND: return "SHD_ERROR_NOT_FOUND";
    case SHD_ERROR_IO: return "SHD_ERROR_IO";
    case SHD_ERROR_CORRUPT: return "SHD_ERROR_CORRUPT";
    case SHD_ERROR_LIMIT: return "SHD_ERROR_LIMIT";
    case SHD_ERROR_CANCELLED: return "SHD_ERROR_CANCELLED";
    case SHD_ERROR_CALLBACK: return "SHD_ERROR_CALLBACK";
    case SHD_ERROR_INTERNAL: return "SHD_ERROR_INTERNAL";
  }
  return "SHD_RESULT_UNKNOWN";
}

}  // extern "C"
