// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <new>

#include "core/errno_scope.h"
#include "core/failure.h"
#include "core/fp_env.h"

namespace shd::core {

/// Runs `body` and turns exceptions into results. report is shd_result report(shd_result code, const char* text): it
/// stores the text, returns the code, and must not throw. Every exception of shd ends here. `body` runs with the IEEE
/// default floating-point control; the host's control bits and errno are restored afterwards.
template <class Report, class Body>
shd_result guard(Report&& report, Body&& body) noexcept {
  const ErrnoScope host_errno;
  try {
    const FpScope fp;
    return body();
  } catch (const Failure& failure) {
    return report(failure.code, failure.what());
  } catch (const std::bad_alloc&) {
    return report(SHD_ERROR_OUT_OF_MEMORY, "out of memory");
  } catch (const std::exception& error) {
    return report(SHD_ERROR_INTERNAL, error.what());
  } catch (...) {
    return report(SHD_ERROR_INTERNAL, "unknown exception");
  }
}

}  // namespace shd::core
