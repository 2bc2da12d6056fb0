// SPDX-License-Identifier: MIT
#pragma once

#include "core/guard.h"
#include "core/status.h"

namespace shd::abi {

/// The guard of libshd's functions: stores the text of what `body` throws for shd_last_error().
template <class Body>
shd_result guard(Body&& body) noexcept {
  return core::guard([](shd_result code, const char* text) { return core::fail(code, "%s", text); }, body);
}

}  // namespace shd::abi
