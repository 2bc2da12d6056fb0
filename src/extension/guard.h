// SPDX-License-Identifier: MIT
#pragma once

#include "core/guard.h"
#include "extension/error.h"

namespace shd::extension {

/// The guard of the C functions of libshd_color, libshd_io, libshd_scene and libshd_embree.
template <class Body>
shd_result guard(Body&& body) noexcept {
  return core::guard([](shd_result code, const char* text) { return fail(code, "%s", text); }, body);
}

}  // namespace shd::extension
