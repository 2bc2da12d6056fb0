// SPDX-License-Identifier: MIT
#pragma once

#include "core/call.h"
#include "core/guard.h"
#include "core/status.h"

namespace shd::abi {

/// The guard of libshd's functions: stores the text of what `body` throws for shd_last_error().
template <class Body>
shd_result guard(Body&& body) noexcept {
  const core::CallScope scope;
  return core::guard([](shd_result code, const char* text) { return core::fail(code, "%s", text); }, body);
}

}  // namespace shd::abi
