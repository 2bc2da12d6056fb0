// SPDX-License-Identifier: MIT
#pragma once

#include <cerrno>
#include <exception>
#include <new>

#include "core/fp_env.h"
#include "core/status.h"

namespace shd::abi {

/// The host's errno comes back at the end of a scope: a failing malloc sets it.
class ErrnoScope {
 public:
  ErrnoScope() : saved_(errno) {}
  ~ErrnoScope() { errno = saved_; }
  ErrnoScope(const ErrnoScope&) = delete;
  ErrnoScope& operator=(const ErrnoScope&) = delete;

 private:
  int saved_;
};

/// Runs `body` and turns anything it throws into a result. The one place in libshd where exceptions end.
template <class Body>
shd_result guard(Body&& body) noexcept {
  const ErrnoScope host_errno;
  try {
    const core::FpScope fp;
    return body();
  } catch (const core::Failure& failure) {
    return failure.code;
  } catch (const std::bad_alloc&) {
    return core::fail(SHD_ERROR_OUT_OF_MEMORY, "out of memory");
  } catch (const std::exception& error) {
    return core::fail(SHD_ERROR_INTERNAL, "%s", error.what());
  } catch (...) {
    return core::fail(SHD_ERROR_INTERNAL, "unknown exception");
  }
}

}  // namespace shd::abi
