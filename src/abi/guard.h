// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <new>

#include "core/fp_env.h"
#include "core/status.h"

namespace shd::abi {

/// Runs `body` and turns anything it throws into a result. The one place in libshd where exceptions end.
template <class Body>
shd_result guard(Body&& body) noexcept {
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
