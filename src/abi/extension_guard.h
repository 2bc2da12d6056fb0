// SPDX-License-Identifier: MIT
#pragma once

#include <cerrno>
#include <exception>
#include <new>

#include "core/extension_error.h"
#include "core/fp_env.h"

namespace shd::extension {

/// Runs `body` and turns anything it throws into a result. The one place in the library where exceptions end;
/// floating-point control and errno come back as the host had them.
template <class Body>
shd_result guard(Body&& body) noexcept {
  struct ErrnoScope {
    int saved = errno;
    ~ErrnoScope() { errno = saved; }
  };
  const ErrnoScope errno_scope;
  try {
    const core::FpScope fp;
    return body();
  } catch (const Failure& failure) {
    return failure.code;
  } catch (const std::bad_alloc&) {
    return fail(SHD_ERROR_OUT_OF_MEMORY, "out of memory");
  } catch (const std::exception& error) {
    return fail(SHD_ERROR_INTERNAL, "%s", error.what());
  } catch (...) {
    return fail(SHD_ERROR_INTERNAL, "unknown exception");
  }
}

}  // namespace shd::extension
